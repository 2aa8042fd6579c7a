// SPDX-License-Identifier: Apache-2.0
#include "sim/radio_link.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/check.h"

namespace pacer::sim {

void RadioLinkConfig::validate() const {
  const auto share = [](const char* field, double value) {
    require(value >= 0.0 && value <= 1.0, std::string(field) + ": must lie in [0, 1]");
  };
  share("corrupted", corrupted);
  require(burst_frames >= 1.0, "burst_frames: a burst is at least one frame long");
  share("whole", whole);
  share("torn", torn);
  share("least_band", least_band);
  share("most_band", most_band);
  require(least_band <= most_band, "least_band: must not exceed most_band");
}

RadioLink::RadioLink(const RadioLinkConfig& config, ImageSize size, const Random& random)
    : config_(config), size_(size), random_(random) {
  bands_.reserve(2);
  row_.resize(static_cast<std::size_t>(size.width) * 3);
  disturbed_ = random_.chance(config.corrupted);  // as in the long run
}

std::span<const RowBand> RadioLink::transmit(Frame& frame) {
  // Leaving with probability q = 1 / burst and entering with p keeps the share p / (p + q). Where
  // that takes more than certain entering, bursts are longer.
  const double quiet = 1.0 - config_.corrupted;
  const bool often = config_.corrupted > config_.burst_frames * quiet;
  const double leave = often ? quiet / config_.corrupted : 1.0 / config_.burst_frames;
  const double enter = often ? 1.0 : leave * config_.corrupted / quiet;
  const bool now = disturbed_;
  disturbed_ = now ? !random_.chance(leave) : random_.chance(enter);
  bands_.clear();
  if (!now) return bands_;

  RowBand band{.first = 0, .last = size_.height};
  if (!random_.chance(config_.whole)) {
    const double share = random_.uniform(config_.least_band, config_.most_band);
    const int rows =
        std::clamp(static_cast<int>(std::lround(share * size_.height)), 1, size_.height);
    band.first =
        static_cast<int>(random_.below(static_cast<std::uint64_t>(size_.height - rows + 1)));
    band.last = band.first + rows;
    if (band.last < size_.height && random_.chance(config_.torn)) {
      bands_.push_back({.first = band.last, .last = size_.height});
      slip(frame, bands_.back());
    }
  }
  bands_.insert(bands_.begin(), band);
  snow(frame, band);
  return bands_;
}

void RadioLink::snow(Frame& frame, const RowBand& band) {
  const std::size_t stride = row_.size();
  for (int y = band.first; y < band.last; ++y) {
    std::uint8_t* pixel = frame.rgb.data() + static_cast<std::size_t>(y) * stride;
    std::uint64_t bits = 0;
    for (int x = 0; x < size_.width; ++x, pixel += 3, bits >>= 8U) {
      if (x % 8 == 0) bits = random_.next();
      std::memset(pixel, static_cast<int>(bits & 0xffU), 3);
    }
  }
}

void RadioLink::slip(Frame& frame, const RowBand& band) {
  const std::size_t stride = row_.size();
  const int quarter = std::max(1, size_.width / 4);
  const int from =
      quarter / 4 + static_cast<int>(random_.below(static_cast<std::uint64_t>(quarter)));
  const double slant = random_.uniform(-0.8, 0.8);  // pixels a row
  for (int y = band.first; y < band.last; ++y) {
    const int offset = from + static_cast<int>(std::lround(slant * (y - band.first)));
    const int wrapped = (offset % size_.width + size_.width) % size_.width;
    std::uint8_t* const row = frame.rgb.data() + static_cast<std::size_t>(y) * stride;
    std::memcpy(row_.data(), row, stride);
    const auto middle = row_.begin() + static_cast<std::ptrdiff_t>(wrapped) * 3;
    std::rotate_copy(row_.begin(), middle, row_.end(), row);
  }
}

}  // namespace pacer::sim
