// SPDX-License-Identifier: Apache-2.0
#include "dataset/picture_header.h"

#include <charconv>
#include <cstddef>
#include <system_error>

extern "C" {
#include <libavutil/crc.h>
}

namespace pacer::dataset {
namespace {

using Header = std::optional<PictureHeader>;

std::int64_t byte_at(std::string_view bytes, std::size_t at) {
  return static_cast<unsigned char>(bytes[at]);
}

std::int64_t big_endian(std::string_view bytes, std::size_t at, std::size_t count) {
  std::int64_t value = 0;
  for (std::size_t i = 0; i < count; ++i) value = value * 256 + byte_at(bytes, at + i);
  return value;
}

std::int64_t little_endian(std::string_view bytes, std::size_t at, std::size_t count) {
  std::int64_t value = 0;
  for (std::size_t i = count; i > 0; --i) value = value * 256 + byte_at(bytes, at + i - 1);
  return value;
}

/// Chunks: length, name, data, checksum. The size is in the first, and the last is named IEND.
Header read_png(std::string_view bytes) {
  constexpr std::size_t kSignature = 8, kAround = 12;
  if (bytes.size() < kSignature + kAround + 13 || bytes.substr(12, 4) != "IHDR") return {};
  PictureHeader header{.width = big_endian(bytes, 16, 4), .height = big_endian(bytes, 20, 4)};
  for (std::size_t at = kSignature; bytes.size() - at >= kAround;) {
    const auto length = static_cast<std::size_t>(big_endian(bytes, at, 4));
    if (length > bytes.size() - at - kAround) break;
    const auto* const named = reinterpret_cast<const std::uint8_t*>(bytes.data()) + at + 4;
    const std::uint32_t sum = ~av_crc(av_crc_get_table(AV_CRC_32_IEEE_LE), ~0U, named, length + 4);
    if (sum != static_cast<std::uint32_t>(big_endian(bytes, at + 8 + length, 4))) break;
    if (bytes.substr(at + 4, 4) == "IEND") header.whole = true;
    if (header.whole) break;
    at += kAround + length;
  }
  return header;
}

/// Segments: a marker (0xff, kind), and length and data for most. The size is in a start of frame;
/// behind the start of a scan, coded data hold no 0xff 0xd9, which ends the picture.
Header read_jpeg(std::string_view bytes) {
  constexpr std::int64_t kStartOfScan = 0xda;
  Header header;
  for (std::size_t at = 2; at + 4 <= bytes.size();) {
    if (byte_at(bytes, at) != 0xff) return {};
    const std::int64_t kind = byte_at(bytes, at + 1);
    if (kind == 0xff) {  // a fill byte
      ++at;
      continue;
    }
    const auto length = static_cast<std::size_t>(big_endian(bytes, at + 2, 2));
    const bool frame = kind >= 0xc0 && kind <= 0xcf && kind != 0xc4 && kind != 0xc8 && kind != 0xcc;
    if (frame && at + 9 <= bytes.size()) {
      header = PictureHeader{.width = big_endian(bytes, at + 7, 2),
                             .height = big_endian(bytes, at + 5, 2)};
    }
    at += 2 + length;
    if (kind == kStartOfScan) {
      if (header) header->whole = bytes.find("\xff\xd9", at) != std::string_view::npos;
      return header;
    }
  }
  return header;
}

Header read_bmp(std::string_view bytes) {
  constexpr std::size_t kSmallest = 30;
  if (bytes.size() < kSmallest) return {};
  const std::int64_t start = little_endian(bytes, 10, 4);
  PictureHeader header;
  std::int64_t bits = 0;
  std::int64_t packing = 0;
  if (little_endian(bytes, 14, 4) == 12) {
    header.width = little_endian(bytes, 18, 2);
    header.height = little_endian(bytes, 20, 2);
    bits = little_endian(bytes, 24, 2);
  } else {
    if (bytes.size() < kSmallest + 4) return {};
    header.width = little_endian(bytes, 18, 4);
    const std::int64_t height = little_endian(bytes, 22, 4);  // negative: the top row comes first
    header.height = height < (std::int64_t{1} << 31) ? height : (std::int64_t{1} << 32) - height;
    bits = little_endian(bytes, 28, 2);
    packing = little_endian(bytes, 30, 4);
  }
  const bool run_length = packing == 1 || packing == 2;  // of any length
  const std::int64_t row = (header.width * bits + 31) / 32 * 4;
  if (packing < 0 || packing > 3) return {};
  header.whole =
      run_length || (header.height < (std::int64_t{1} << 20) &&
                     start + row * header.height <= static_cast<std::int64_t>(bytes.size()));
  return header;
}

/// The next number of a PNM's header, behind blanks and comments; `at` goes behind it.
std::optional<std::int64_t> pnm_number(std::string_view bytes, std::size_t& at) {
  constexpr std::string_view kBlank = " \t\r\n\v\f";
  at = bytes.find_first_not_of(kBlank, at);
  while (at < bytes.size() && bytes[at] == '#') {
    at = bytes.find_first_not_of(kBlank, bytes.find('\n', at));
  }
  if (at >= bytes.size()) return std::nullopt;
  std::int32_t value = 0;
  const auto [rest, error] = std::from_chars(bytes.data() + at, bytes.data() + bytes.size(), value);
  if (error != std::errc() || value < 0) return std::nullopt;
  at = static_cast<std::size_t>(rest - bytes.data());
  return value;
}

Header read_pnm(std::string_view bytes) {
  std::size_t at = 2;
  const auto width = pnm_number(bytes, at);
  const auto height = width ? pnm_number(bytes, at) : std::nullopt;
  const auto highest = height ? pnm_number(bytes, at) : std::nullopt;
  if (!highest) return {};
  const std::int64_t pixel = (bytes[1] == '6' ? 3 : 1) * (*highest > 255 ? 2 : 1);
  const auto left = static_cast<std::int64_t>(bytes.size() - at) - 1;  // one blank behind it
  return PictureHeader{.width = *width,
                       .height = *height,
                       .whole = *height == 0 || *width * pixel <= left / *height};
}

}  // namespace

std::optional<PictureHeader> read_picture_header(std::string_view bytes) {
  if (bytes.starts_with("\x89PNG\r\n\x1a\n")) return read_png(bytes);
  if (bytes.starts_with("\xff\xd8")) return read_jpeg(bytes);
  if (bytes.starts_with("BM")) return read_bmp(bytes);
  if (bytes.starts_with("P5") || bytes.starts_with("P6")) return read_pnm(bytes);
  return std::nullopt;
}

}  // namespace pacer::dataset
