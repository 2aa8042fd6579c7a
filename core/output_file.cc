// SPDX-License-Identifier: Apache-2.0
#include "core/output_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace pacer {

namespace fs = std::filesystem;

namespace {

/// Tries whether a file can be made that is not there; 0, or the reason why not.
int reason_not_to_make(const fs::path& place) {
  const int made = ::open(place.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (made < 0) return errno;
  ::close(made);
  ::unlink(place.c_str());
  return 0;
}

/// Whether it is to be written to as it is: a device or a pipe, or a name that the system gives to
/// what somebody else has open, such as /dev/stdout.
bool is_stream(const fs::path& place) {
  std::error_code missing;
  const fs::file_status there = fs::status(place, missing);
  if (fs::exists(there) && !fs::is_regular_file(there)) return true;
  const auto first = place.is_absolute() ? *std::next(place.begin()) : fs::path();
  return first == "dev" || first == "proc";
}

}  // namespace

OutputFile::OutputFile(fs::path place) : place_(std::move(place)), aside_(place_) {
  std::error_code error;
  if (place_.empty()) fail(ENOENT);
  if (fs::is_directory(place_, error)) fail(EISDIR);
  if (is_stream(place_)) {
    const bool there = fs::exists(fs::symlink_status(place_, error));
    if (const int reason = there ? 0 : reason_not_to_make(place_); reason != 0) fail(reason);
    return;
  }
  if (fs::is_symlink(place_, error) && fs::exists(place_, error)) {
    place_ = fs::canonical(place_);  // the link stays a link
  }
  error.clear();
  for (fs::path above = place_.parent_path(); !above.empty() && !fs::exists(above, error);
       above = above.parent_path()) {
    ++made_;
  }
  error.clear();
  if (place_.has_parent_path()) fs::create_directories(place_.parent_path(), error);
  if (error) fail(error.value());
  aside_ = place_.string() + "." + std::to_string(::getpid()) + ".part";
  errno = 0;
  if (!std::ofstream(aside_, std::ios::binary | std::ios::trunc)) fail(errno);
}

OutputFile::~OutputFile() {
  std::error_code error;
  if (aside_ != place_) fs::remove(aside_, error);
  fs::path above = place_;
  for (; made_ > 0 && !error; --made_) {  // until one holds something else
    above = above.parent_path();
    fs::remove(above, error);
  }
}

void OutputFile::write(std::string_view bytes) const {
  errno = 0;
  // What others have written to a stream before us stays.
  std::ofstream out(aside_,
                    std::ios::binary | (aside_ == place_ ? std::ios::app : std::ios::trunc));
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!out) fail(errno);
}

void OutputFile::keep() {
  if (aside_ == place_) return;
  const int written = ::open(aside_.c_str(), O_RDONLY | O_CLOEXEC);
  const bool safe = written >= 0 && ::fsync(written) == 0;  // the bytes before the name
  const int reason = errno;
  if (written >= 0) ::close(written);
  if (!safe) fail(reason);
  std::error_code error;
  fs::rename(aside_, place_, error);
  if (error) fail(error.value());
  made_ = 0;
}

void OutputFile::fail(int error) const {
  const char* hint = error == ENOSPC || error == EDQUOT ? "; free some space and run again"
                                                        : "; name a file that can be written";
  throw std::runtime_error(place_.string() + ": cannot be written: " +
                           std::generic_category().message(error != 0 ? error : EIO) + hint);
}

}  // namespace pacer
