// SPDX-License-Identifier: Apache-2.0
#include "runs/tracking/picture_chunks.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace pacer {
namespace {

/// How many of the sequence's pictures need not be read, since they are listed.
std::size_t listed_before(const TrackingTarget& target) {
  return std::min(target.first, target.sequence.pictures.size());
}

std::unique_ptr<dataset::PictureSource> read_from(const TrackingTarget& target) {
  dataset::Sequence rest = target.sequence;
  const auto first = rest.pictures.begin();
  rest.pictures.erase(first, first + static_cast<std::ptrdiff_t>(listed_before(target)));
  return dataset::read_pictures(rest);
}

}  // namespace

PictureChunks::PictureChunks(const TrackingTarget& target)
    : own_(read_from(target)), source_(*own_), read_(listed_before(target)) {
  try {  // a video's pictures have to be decoded, to come past them
    while (read_ < target.first && source_.next(image_)) ++read_;
  } catch (const std::runtime_error& failure) {
    error_ = failure.what();
  }
}

std::span<const tracking::Picture> PictureChunks::next(std::size_t most) {
  constexpr std::size_t kMostBytes = 128U << 20U;
  constexpr std::size_t kBytesAPixel = 4;  // grey and colour
  std::size_t count = 0;
  while (count < most && error_.empty()) {
    if (chunk_.size() == count) chunk_.emplace_back();
    if (!read(chunk_[count])) break;
    ++count;
    const auto pixels = static_cast<std::size_t>(size_.area());
    if ((count + 1) * pixels * kBytesAPixel > kMostBytes) break;
  }
  return {chunk_.data(), count};
}

bool PictureChunks::read(tracking::Picture& picture) try {
  if (!source_.next(image_)) return false;
  ++read_;
  tracking::to_picture(image_, picture);
  const cv::Size size = picture.grey.size();
  if (size_.empty()) size_ = size;
  if (size == size_) return true;
  error_ = fmt::format("picture {} is {} x {} pixels, those before it {} x {}", read_, size.width,
                       size.height, size_.width, size_.height);
  return false;
} catch (const std::invalid_argument& failure) {
  error_ = fmt::format("picture {}: {}", read_, failure.what());
  return false;
} catch (const std::runtime_error& failure) {
  error_ = failure.what();
  return false;
}

}  // namespace pacer
