// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace pacer::dataset {

/// The file's text. Throws std::runtime_error, naming it, when it cannot be read or is larger
/// than `most` bytes.
[[nodiscard]] std::string read_text(const std::filesystem::path& path,
                                    std::uintmax_t most = 64U << 20U);

/// Writes a new file through to the disk. Throws std::runtime_error, naming it: a full disk is
/// noticed here.
void write_text(const std::filesystem::path& path, std::string_view text);

/// Replaces a file as a whole by way of another on the same file system: whoever reads it, whenever
/// the writer is killed, finds the old text or the new.
void replace_text(const std::filesystem::path& path, const std::filesystem::path& by_way_of,
                  std::string_view text);

/// Puts a file or folder through to the disk. Throws std::runtime_error, naming it.
void sync(const std::filesystem::path& path);

/// Renames; both must be on one file system. Throws std::runtime_error, naming both.
void move(const std::filesystem::path& from, const std::filesystem::path& to);

/// Makes the folder and those above it. Throws std::runtime_error, naming it.
void make_folder(const std::filesystem::path& path);

/// The plain files in a folder that are not hidden, by name; none where there is no folder. Throws
/// std::runtime_error, naming it, when it cannot be listed or holds more than `most`.
[[nodiscard]] std::vector<std::filesystem::path> list_files(const std::filesystem::path& folder,
                                                            std::size_t most = 2'000'000);

/// A folder that one process writes. The lock goes with the object, or with the process.
class FolderLock {
 public:
  /// Waits up to ten seconds for a killed predecessor's last breath; throws UsageError after that.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_ = -1;
};

/// A hash of bytes (MurmurHash3, 128 bits): tells damage and difference, not malice.
class ContentHash {
 public:
  ContentHash();
  ~ContentHash();
  ContentHash(const ContentHash&) = delete;
  ContentHash& operator=(const ContentHash&) = delete;

  void add(std::string_view bytes);
  /// Adds the bytes of a file. Throws std::runtime_error, naming it.
  void add_file(const std::filesystem::path& path);
  /// 32 hexadecimal digits; nothing can be added after it.
  [[nodiscard]] std::string finish();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

[[nodiscard]] std::string hash_of_file(const std::filesystem::path& path);

}  // namespace pacer::dataset
