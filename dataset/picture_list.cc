// SPDX-License-Identifier: Apache-2.0
#include "dataset/picture_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <tuple>
#include <utility>

#include "dataset/files.h"
#include "dataset/sequence_annotation.h"

namespace pacer::dataset {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 6> kExtensions = {".jpg", ".jpeg", ".png",
                                                         ".bmp", ".ppm",  ".pgm"};
constexpr std::size_t kMostDigits = 12;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::optional<std::int64_t> number_of(std::string_view digits) {
  if (digits.empty() || digits.size() > kMostDigits || !std::ranges::all_of(digits, is_digit)) {
    return std::nullopt;
  }
  std::int64_t number = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return number;
}

std::vector<NumberedPicture> sorted(const fs::path& folder, std::vector<NumberedPicture> pictures) {
  std::ranges::sort(pictures, [](const NumberedPicture& a, const NumberedPicture& b) {
    return std::tie(a.number, a.path) < std::tie(b.number, b.path);
  });
  const auto twice = std::ranges::adjacent_find(pictures, {}, &NumberedPicture::number);
  if (twice != pictures.end()) {
    throw std::runtime_error(
        fmt::format("{}: {} and {} have the same number; take one of them away", folder.string(),
                    twice->path.filename().string(), std::next(twice)->path.filename().string()));
  }
  if (pictures.size() > kMostPictures) {
    throw std::runtime_error(
        fmt::format("{}: holds more than {} pictures", folder.string(), kMostPictures));
  }
  return pictures;
}

}  // namespace

bool is_picture(const fs::path& file) {
  std::string extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return std::ranges::find(kExtensions, extension) != kExtensions.end();
}

std::vector<NumberedPicture> list_pictures(const fs::path& folder) {
  std::map<std::string, std::vector<NumberedPicture>> by_prefix;
  for (const fs::path& file : list_files(folder)) {
    if (!is_picture(file)) continue;
    const std::string stem = file.stem().string();
    const auto digits = static_cast<std::size_t>(
        std::find_if_not(stem.rbegin(), stem.rend(), is_digit) - stem.rbegin());
    const std::size_t begin = stem.size() - digits;
    if (const auto number = number_of(std::string_view(stem).substr(begin))) {
      by_prefix[stem.substr(0, begin)].push_back({*number, file});
    }
  }
  if (by_prefix.empty()) return {};
  auto& [prefix, chosen] = *by_prefix.begin();  // the empty prefix comes first
  if (!prefix.empty() && by_prefix.size() > 1) {
    throw std::runtime_error(
        fmt::format("{}: pictures of two kinds, {} and {}; keep those of one", folder.string(),
                    chosen.front().path.filename().string(),
                    std::next(by_prefix.begin())->second.front().path.filename().string()));
  }
  return sorted(folder, std::move(chosen));
}

std::vector<NumberedPicture> list_pictures(const fs::path& folder, const std::string& prefix,
                                           const std::string& suffix) {
  std::vector<NumberedPicture> pictures;
  for (const fs::path& file : list_files(folder)) {
    const std::string name = file.filename().string();
    if (!is_picture(file) || name.size() < prefix.size() + suffix.size() ||
        !name.starts_with(prefix) || !name.ends_with(suffix)) {
      continue;
    }
    const std::string_view digits =
        std::string_view(name).substr(prefix.size(), name.size() - prefix.size() - suffix.size());
    if (const auto number = number_of(digits)) pictures.push_back({*number, file});
  }
  return sorted(folder, std::move(pictures));
}

}  // namespace pacer::dataset
