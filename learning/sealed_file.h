// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cerrno>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

#include "core/hash.h"
#include "core/output_file.h"
#include "learning/byte_stream.h"

namespace pacer {

/// A kind of model file.
struct SealedKind {
  std::string_view magic;     ///< its first eight bytes
  std::uint32_t version = 0;  ///< of its format or meaning
  std::string_view name;      ///< with its article, e.g. "an affordance model"
};

/// For readers of untrusted bytes: throws std::runtime_error with `what` unless `condition`.
inline void sane(bool condition, const char* what) {
  if (!condition) throw std::runtime_error(what);
}

/// `body` as a file. Little-endian: the magic, the version (u32), the length of the body (u64), the
/// body, and its checksum (FNV-1a, u64).
[[nodiscard]] inline std::string sealed(const SealedKind& kind, std::string_view body) {
  ByteWriter out;
  for (const char letter : kind.magic) out.value(letter);
  out.value(kind.version);
  out.text(body);
  out.value(fnv1a(body));
  return out.bytes();
}

/// Reads the body of what sealed() wrote with `read`, and returns what that returns. `bytes` are
/// not trusted. Throws std::runtime_error naming `source`: another kind of file, another version,
/// truncated, damaged, or what `read` throws.
template <class Read>
[[nodiscard]] auto unsealed(const SealedKind& kind, std::string_view bytes, std::string_view source,
                            const Read& read) {
  const std::string file(source);
  if (!bytes.starts_with(kind.magic)) {
    throw std::runtime_error(file + ": not " + std::string(kind.name));
  }
  ByteReader in(bytes.substr(kind.magic.size()));
  std::uint32_t version = 0;
  try {
    version = in.value<std::uint32_t>();
    if (version == kind.version) {
      const std::string_view body = in.take(in.count(1));
      const auto sum = in.value<std::uint64_t>();
      sane(in.rest().empty(), "something follows its end");
      sane(sum == fnv1a(body), "its checksum does not match");
      return read(body);
    }
  } catch (const std::exception& error) {
    const std::string_view name = kind.name.substr(kind.name.find(' ') + 1);
    throw std::runtime_error(file + ": a damaged " + std::string(name) + ": " + error.what() +
                             "; train it again");
  }
  throw std::runtime_error(file + ": a model of version " + std::to_string(version) +
                           ", and this program reads version " + std::to_string(kind.version) +
                           "; train it again");
}

/// Writes aside and renames: `path` is never half a model. Throws std::runtime_error.
inline void write_model_file(std::string_view bytes, const std::filesystem::path& path) {
  OutputFile file(path);
  file.write(bytes);
  file.keep();
}

/// All of the file's bytes. Throws std::system_error when `path` cannot be read.
[[nodiscard]] inline std::string read_model_file(const std::filesystem::path& path) {
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (!in.is_open() || in.bad()) {
    throw std::system_error(errno != 0 ? errno : EIO, std::generic_category(),
                            "cannot read the model " + path.string());
  }
  return bytes;
}

}  // namespace pacer
