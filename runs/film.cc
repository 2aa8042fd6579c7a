// SPDX-License-Identifier: Apache-2.0
#include "runs/film.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <iterator>
#include <system_error>

#include "runs/report/draw.h"

namespace pacer {

TemporaryFile::TemporaryFile(const std::string& suffix) {
  std::string name = (std::filesystem::temp_directory_path() / "pacer-XXXXXX").string() + suffix;
  const int fd = ::mkstemps(name.data(), static_cast<int>(suffix.size()));
  if (fd < 0) throw std::system_error(errno, std::generic_category(), name);
  ::close(fd);
  path_ = name;
}

TemporaryFile::~TemporaryFile() {
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

std::string TemporaryFile::bytes() const {
  std::ifstream stream(path_, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

Film::Film(const std::filesystem::path& file, int rate_hz, Seconds longest, std::string title)
    : file_(file), rate_hz_(rate_hz), longest_(longest), title_(std::move(title)) {}

bool Film::write(const Frame& frame, const Step& step) {
  if (frame.time > longest_) return true;
  report::draw(frame, step.annotations,
               {.sent = step.sent,
                .wanted = step.wanted,
                .caption = fmt::format("{}, {:.1f} s", title_, frame.time.count())},
               drawn_);
  if (!encoder_) {
    encoder_.emplace(file_.path(), drawn_.size, rate_hz_,
                     dataset::VideoSettings{
                         .preset = "veryfast", .quality = 27, .key_frame_every = rate_hz_ * 2});
  }
  encoder_->write(drawn_);
  constexpr Seconds kStillAt{5.0};
  if (still_.rgb.empty() || frame.time <= kStillAt) still_ = drawn_;
  return true;
}

void Film::close() {
  if (!encoder_) return;
  encoder_->close();
  file_.keep();
}

}  // namespace pacer
