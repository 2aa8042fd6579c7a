// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/blobs.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <stdexcept>

#include "core/check.h"

namespace pacer::exemplar {
namespace {

constexpr int kTop = 8;      // cells: the pyramid ends where no side is longer
constexpr int kSteady = 32;  // added to red + green + blue, so that the colour of the dark is quiet
constexpr int kPurest = 128;  // a share of colour of all

/// kPurest / (sum + kSteady), times 2^16, for every sum of three bytes.
constexpr auto kShares = [] {
  std::array<int, 3 * 255 + 1> shares{};
  for (int sum = 0; sum < static_cast<int>(shares.size()); ++sum) {
    shares[static_cast<std::size_t>(sum)] = (kPurest << 16) / (sum + kSteady);
  }
  return shares;
}();

std::uint8_t shifted(int share) noexcept { return static_cast<std::uint8_t>(share + 128); }

}  // namespace

void BlobConfig::validate() const {
  require(homogeneous >= 1 && homogeneous <= 255, "homogeneous: must lie in [1, 255]");
  require(pixel >= 1 && pixel <= 255, "pixel: must lie in [1, 255]");
  require(joined >= 0 && joined <= 255, "joined: must lie in [0, 255]");
  require(shaded >= 0 && shaded <= 255, "shaded: must lie in [0, 255]");
  require(least_area >= 1, "least_area_px: must be at least 1");
}

BlobFinder::BlobFinder(const BlobConfig& config) : config_(config) { config_.validate(); }

int BlobFinder::colour_distance(const Cell& a, const Cell& b) noexcept {
  return std::abs(a.red_green - b.red_green) + std::abs(a.blue_yellow - b.blue_yellow);
}

int BlobFinder::distance(const Cell& a, const Cell& b) noexcept {
  return std::abs(a.light - b.light) + colour_distance(a, b);
}

void BlobFinder::resize(ImageSize size) {
  if (size == size_) return;
  size_ = size;
  levels_.clear();
  std::size_t cells = 0;
  for (int width = size.width, height = size.height;;) {
    Level& level = levels_.emplace_back();
    level.width = width;
    level.height = height;
    const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    level.cells.resize(count);
    if (levels_.size() > 1) {
      level.regions.resize(count);
      cells += count;
      if (std::max(width, height) <= kTop) break;
    }
    width = (width + 1) / 2;
    height = (height + 1) / 2;
  }
  const std::size_t pixels = levels_.front().cells.size();
  labels_.resize(pixels);
  parents_.reserve(cells);
  indices_.reserve(cells);
  renumbered_.reserve(cells);
  sums_.reserve(cells);
  moments_.reserve(cells);
  blobs_.reserve(cells);
}

std::span<const Blob> BlobFinder::find(const Frame& frame) {
  if (frame.size.width < 0 || frame.size.height < 0 ||
      frame.rgb.size() != 3 * static_cast<std::size_t>(frame.size.width) *
                              static_cast<std::size_t>(frame.size.height)) {
    throw std::invalid_argument("a frame's bytes do not fit its size");
  }
  blobs_.clear();
  moments_.clear();
  if (frame.rgb.empty()) {
    labels_.clear();
    size_ = {};
    return {};
  }
  resize(frame.size);
  measure(frame);
  for (std::size_t i = 1; i < levels_.size(); ++i) summarise(levels_[i - 1], levels_[i]);

  parents_.clear();
  std::ranges::fill(levels_.back().regions, kNone);
  for (std::size_t i = levels_.size() - 1; i >= 1; --i) {
    if (i + 1 < levels_.size()) inherit(levels_[i + 1], levels_[i]);
    join(levels_[i]);
  }
  inherit_pixels(levels_[1]);
  gather(frame);
  return blobs_;
}

/// Colours as they are told apart here.
void BlobFinder::measure(const Frame& frame) {
  const std::uint8_t* rgb = frame.rgb.data();
  for (Cell& cell : levels_.front().cells) {
    const int red = rgb[0], green = rgb[1], blue = rgb[2];
    rgb += 3;
    const int sum = red + green + blue;
    const int share = kShares[static_cast<std::size_t>(sum)];
    cell.light = static_cast<std::uint8_t>((sum * 21846) >> 16);
    cell.red_green = shifted(((red - green) * share) >> 16);
    cell.blue_yellow = shifted(((2 * blue - red - green) * share) >> 17);
    cell.sure = 1;
  }
}

/// A cell is the mean of those of its four parts that agree, where most do.
void BlobFinder::summarise(const Level& fine, Level& coarse) const {
  const int limit = config_.homogeneous;
  for (int y = 0; y < coarse.height; ++y) {
    for (int x = 0; x < coarse.width; ++x) {
      std::array<const Cell*, 4> parts{};
      int there = 0, sure = 0;
      for (int v = 2 * y; v < std::min(2 * y + 2, fine.height); ++v) {
        for (int u = 2 * x; u < std::min(2 * x + 2, fine.width); ++u) {
          const Cell& part = fine.cells[static_cast<std::size_t>(v * fine.width + u)];
          ++there;
          if (part.sure != 0) parts[static_cast<std::size_t>(sure++)] = &part;
        }
      }
      int most = 0;
      std::uint32_t agreeing = 0;
      for (int i = 0; i < sure && most < sure; ++i) {
        int count = 0;
        std::uint32_t with = 0;
        for (int j = 0; j < sure; ++j) {
          const bool near = distance(*parts[static_cast<std::size_t>(i)],
                                     *parts[static_cast<std::size_t>(j)]) <= limit;
          count += near ? 1 : 0;
          with |= (near ? 1U : 0U) << static_cast<unsigned>(j);
        }
        if (count > most) {
          most = count;
          agreeing = with;
        }
      }
      Cell& cell = coarse.cells[static_cast<std::size_t>(y * coarse.width + x)];
      cell = {};
      if (2 * most <= there) continue;
      int light = most / 2, red_green = most / 2, blue_yellow = most / 2;  // rounds
      for (int j = 0; j < sure; ++j) {
        if ((agreeing >> static_cast<unsigned>(j) & 1U) == 0) continue;
        const Cell& part = *parts[static_cast<std::size_t>(j)];
        light += part.light;
        red_green += part.red_green;
        blue_yellow += part.blue_yellow;
      }
      cell = {.light = static_cast<std::uint8_t>(light / most),
              .red_green = static_cast<std::uint8_t>(red_green / most),
              .blue_yellow = static_cast<std::uint8_t>(blue_yellow / most),
              .sure = 1};
    }
  }
}

/// The region of the nearest four coarse cells that is closest in colour, the own one's where it is
/// close enough.
template <class Close>
static std::int32_t nearest_region(int x, int y, int width, int height, const std::int32_t* regions,
                                   int limit, const Close& distance) {
  const int px = x / 2, py = y / 2;
  const std::size_t own = static_cast<std::size_t>(py * width + px);
  if (regions[own] >= 0 && distance(own) <= limit) return regions[own];
  const int qx = px + (x % 2 != 0 ? 1 : -1), qy = py + (y % 2 != 0 ? 1 : -1);
  const bool beside = qx >= 0 && qx < width, below = qy >= 0 && qy < height;
  std::int32_t best = BlobFinder::kNone;
  int least = limit + 1;
  const auto look = [&](int u, int v) {
    const std::size_t at = static_cast<std::size_t>(v * width + u);
    if (regions[at] < 0) return;
    const int apart = distance(at);
    if (apart < least) {
      least = apart;
      best = regions[at];
    }
  };
  if (beside) look(qx, py);
  if (below) look(px, qy);
  if (beside && below) look(qx, qy);
  return best;
}

void BlobFinder::inherit(const Level& coarse, Level& fine) {
  std::size_t at = 0;
  for (int y = 0; y < fine.height; ++y) {
    for (int x = 0; x < fine.width; ++x, ++at) {
      const Cell& cell = fine.cells[at];
      fine.regions[at] = kNone;
      if (cell.sure == 0) continue;
      fine.regions[at] = nearest_region(
          x, y, coarse.width, coarse.height, coarse.regions.data(), config_.homogeneous,
          [&](std::size_t of) { return distance(cell, coarse.cells[of]); });
    }
  }
}

void BlobFinder::inherit_pixels(const Level& coarse) {
  const Level& fine = levels_.front();
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(parents_.size()); ++i) {
    parents_[static_cast<std::size_t>(i)] = root(i);
  }
  std::size_t at = 0;
  for (int y = 0; y < fine.height; ++y) {
    for (int x = 0; x < fine.width; ++x, ++at) {
      const Cell& cell = fine.cells[at];
      const std::int32_t region =
          nearest_region(x, y, coarse.width, coarse.height, coarse.regions.data(), config_.pixel,
                         [&](std::size_t of) { return distance(cell, coarse.cells[of]); });
      labels_[at] = region < 0 ? kNone : parents_[static_cast<std::size_t>(region)];
    }
  }
}

/// What no coarser cell explains is a new region; neighbours that are alike are of one region.
void BlobFinder::join(Level& level) {
  std::size_t at = 0;
  const auto width = static_cast<std::size_t>(level.width);
  const auto first_new = static_cast<std::int32_t>(parents_.size());
  for (int y = 0; y < level.height; ++y) {
    for (int x = 0; x < level.width; ++x, ++at) {
      if (level.cells[at].sure == 0) continue;
      if (level.regions[at] < 0) {
        level.regions[at] = static_cast<std::int32_t>(parents_.size());
        parents_.push_back(level.regions[at]);
      }
      const auto meet = [&](std::size_t other) {
        if (level.cells[other].sure == 0 || level.regions[other] == level.regions[at]) return;
        if (distance(level.cells[at], level.cells[other]) > config_.joined) return;
        // Two that coarser cells explain are joined by shading alone: a ramp from one colour to
        // another would do it else.
        if (std::max(level.regions[other], level.regions[at]) < first_new &&
            colour_distance(level.cells[at], level.cells[other]) > config_.shaded) {
          return;
        }
        unite(level.regions[at], level.regions[other]);
      };
      if (x > 0) meet(at - 1);
      if (y > 0) meet(at - width);
    }
  }
}

std::int32_t BlobFinder::root(std::int32_t region) noexcept {
  auto at = static_cast<std::size_t>(region);
  while (parents_[at] != static_cast<std::int32_t>(at)) {
    parents_[at] = parents_[static_cast<std::size_t>(parents_[at])];  // halves the way
    at = static_cast<std::size_t>(parents_[at]);
  }
  return static_cast<std::int32_t>(at);
}

void BlobFinder::unite(std::int32_t a, std::int32_t b) noexcept {
  a = root(a);
  b = root(b);
  parents_[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
}

/// Moments run by run, over the pixels themselves.
void BlobFinder::gather(const Frame& frame) {
  indices_.assign(parents_.size(), kNone);
  sums_.clear();
  const auto width = static_cast<std::size_t>(size_.width);
  for (int y = 0; y < size_.height; ++y) {
    const std::size_t row = static_cast<std::size_t>(y) * width;
    for (int x = 0; x < size_.width;) {
      const std::int32_t region = labels_[row + static_cast<std::size_t>(x)];
      int end = x + 1;
      while (end < size_.width && labels_[row + static_cast<std::size_t>(end)] == region) ++end;
      if (region >= 0) {
        std::int32_t& index = indices_[static_cast<std::size_t>(region)];
        if (index < 0) {
          index = static_cast<std::int32_t>(sums_.size());
          sums_.emplace_back();
        }
        sums_[static_cast<std::size_t>(index)].add_run(
            y, x, end, frame.rgb.data() + 3 * (row + static_cast<std::size_t>(x)));
      }
      x = end;
    }
  }
  // Regions in the order of their first pixels keep it when the small ones go.
  std::int32_t kept = 0;
  renumbered_.assign(sums_.size(), kNone);
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    if (sums_[i].area() < config_.least_area) continue;
    renumbered_[i] = kept++;
    moments_.push_back(sums_[i]);
    blobs_.push_back(sums_[i].blob(size_));
  }
  for (std::int32_t& index : indices_) {
    if (index >= 0) index = renumbered_[static_cast<std::size_t>(index)];
  }
  for (std::int32_t& label : labels_) {
    if (label >= 0) label = indices_[static_cast<std::size_t>(label)];
  }
}

}  // namespace pacer::exemplar
