// SPDX-License-Identifier: Apache-2.0
#include "core/output_file.h"

#include <cerrno>
#include <fstream>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace pacer {

namespace fs = std::filesystem;

OutputFile::OutputFile(fs::path place) : place_(std::move(place)), aside_(place_) {
  std::error_code error;
  const fs::file_status there = fs::status(place_, error);
  if (place_.empty() || fs::is_directory(there)) fail(place_.empty() ? ENOENT : EISDIR);
  if (fs::exists(there) && !fs::is_regular_file(there)) return;
  if (fs::is_symlink(fs::symlink_status(place_, error)) && fs::exists(there)) {
    place_ = fs::canonical(place_, error);  // the link stays a link
    if (error) fail(error.value());
  }
  aside_ = place_.string() + ".part";
  if (place_.has_parent_path()) fs::create_directories(place_.parent_path(), error);
  if (error) fail(error.value());
  errno = 0;
  if (!std::ofstream(aside_, std::ios::binary | std::ios::trunc)) fail(errno);
}

OutputFile::~OutputFile() {
  std::error_code ignored;
  if (aside_ != place_) fs::remove(aside_, ignored);
}

void OutputFile::write(std::string_view bytes) const {
  errno = 0;
  std::ofstream out(aside_, std::ios::binary | std::ios::trunc);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!out) fail(errno);
}

void OutputFile::keep() {
  if (aside_ == place_) return;
  std::error_code error;
  fs::rename(aside_, place_, error);
  if (error) fail(error.value());
}

void OutputFile::fail(int error) const {
  const char* hint = error == ENOSPC || error == EDQUOT ? "; free some space and run again"
                                                        : "; name a file that can be written";
  throw std::runtime_error(place_.string() + ": cannot be written: " +
                           std::generic_category().message(error != 0 ? error : EIO) + hint);
}

}  // namespace pacer
