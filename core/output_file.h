// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string_view>

namespace pacer {

/// A file that holds a result as a whole or not at all: it is written aside, next to its place,
/// and takes the place of what was there only when it is kept. What is no plain file (a device, a
/// pipe, anything under /dev and /proc) is never replaced: it is appended to as it is.
class OutputFile {
 public:
  /// Makes the folders above, and tries at once whether the file can be written: before the work
  /// whose result it shall hold. Throws std::runtime_error, naming it, when it cannot.
  explicit OutputFile(std::filesystem::path place);
  /// What was not kept is gone, with the folders that were made for it, and the old file stays.
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Where to write, until keep().
  [[nodiscard]] const std::filesystem::path& path() const noexcept { return aside_; }

  /// Writes all of it. Throws std::runtime_error, naming it: a full disk is noticed here.
  void write(std::string_view bytes) const;

  /// Puts what was written in its place. Throws like write().
  void keep();

 private:
  [[noreturn]] void fail(int error) const;

  std::filesystem::path place_;
  std::filesystem::path aside_;  // the place itself where that is no plain file
  int made_ = 0;                 // folders above it, the nearest ones
};

}  // namespace pacer
