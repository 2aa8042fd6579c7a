// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/balloon_regions.h"

#include <algorithm>
#include <cmath>

namespace pacer::exemplar {
namespace {

constexpr std::int32_t kFree = -3, kGrowing = -2, kTooSmall = -1;
constexpr std::int32_t kEdge = -10;  // less the index of the region at whose edge it is
constexpr double kStep = 0.12;       // shares, between what is of one colour and another
constexpr float kContrast = 20.0F;   // grey levels

/// Whether a pixel has about a thing's colour, whatever falls on it.
class SameColour {
 public:
  SameColour(const ColourTable::Line& line, double spread, double noise)
      : shares_((line.start + 0.5 * line.way).cast<float>()),
        spread_(static_cast<float>(spread)),
        noise_(static_cast<float>(noise)) {}

  bool operator()(const std::uint8_t* rgb) const noexcept {
    auto r = static_cast<float>(rgb[0]);
    const auto g = static_cast<float>(rgb[1]), b = static_cast<float>(rgb[2]);
    // Too bright for the camera, as red rubber may be: as red as the rest of it says.
    constexpr float kClipped = 252.0F, kOver = 1.6F;
    if (r >= kClipped) {
      r = std::clamp((g + b) * shares_[0] / (1.0F - shares_[0]), r, kOver * kClipped);
    }
    const float sum = r + g + b;
    const float dr = r - sum * shares_[0], dg = g - sum * shares_[1], db = b - sum * shares_[2];
    const float most = spread_ * sum + noise_;
    return dr * dr + dg * dg + db * db <= most * most && sum > 5.0F * noise_;
  }

 private:
  Eigen::Vector3f shares_;
  float spread_, noise_;
};

Eigen::Vector3f colour_at(const Frame& frame, std::int32_t at) noexcept {
  const std::uint8_t* const rgb = frame.rgb.data() + 3 * static_cast<std::ptrdiff_t>(at);
  return {static_cast<float>(rgb[0]), static_cast<float>(rgb[1]), static_cast<float>(rgb[2])};
}

double mean_level(const Frame& frame) noexcept {
  std::uint64_t sum = 0;
  for (const std::uint8_t level : frame.rgb) sum += level;
  return static_cast<double>(sum) / std::max<double>(1.0, static_cast<double>(frame.rgb.size()));
}

}  // namespace

std::span<Region> RegionGrower::grow(const Frame& frame, const BlobFinder& finder,
                                     std::span<const Blob> blobs, int rows) {
  rows_ = rows;
  level_ = mean_level(frame);
  const std::size_t pixels = finder.labels().size();
  owners_.assign(pixels, kFree);
  front_.clear();
  front_.reserve(pixels);
  regions_.clear();
  regions_.reserve(pixels / static_cast<std::size_t>(config_.least_part));
  // Those of the very colour first, lest a wall of bricks takes a balloon before it in.
  for (const bool mixed : {false, true}) {
    for (std::size_t i = 0; i < blobs.size(); ++i) {
      const Name name =
          mixed ? table_.nearest(blobs[i].colour) : table_.name(blobs[i].colour, blobs[i].area);
      if (name != Name::kNone) grow_blob(frame, finder, blobs[i], i, name);
    }
  }
  grow_loose(frame, Name::kRed);
  grow_loose(frame, Name::kGreen);
  trace(frame);
  return regions_;
}

void RegionGrower::visit(std::int32_t at) {
  owners_[static_cast<std::size_t>(at)] = kGrowing;
  front_.push_back(at);
}

/// From the pixels in front_ to all about them that belong, and keeps what that comes to.
template <class Belongs>
void RegionGrower::flood(const Frame& frame, Name name, Extent extent, bool corners,
                         const Belongs& belongs) {
  const int width = frame.size.width;
  std::int32_t touched = kFree;  // an earlier region of the name
  while (!front_.empty()) {
    const std::int32_t at = front_.back();
    front_.pop_back();
    const int x = at % width, y = at / width;
    extent.left = std::min(extent.left, x);
    extent.right = std::max(extent.right, x);
    extent.top = std::min(extent.top, y);
    extent.bottom = std::max(extent.bottom, y);
    const auto ask = [&](std::int32_t other, int u, int v) {
      const std::int32_t owner = owners_[static_cast<std::size_t>(other)];
      if (owner >= 0 && regions_[static_cast<std::size_t>(owner)].name == name) {
        touched = std::max(touched, owner);
      }
      if (owner == kFree && belongs(other, u, v)) visit(other);
    };
    if (x > 0) ask(at - 1, x - 1, y);
    if (x + 1 < width) ask(at + 1, x + 1, y);
    if (y > 0) ask(at - width, x, y - 1);
    if (y + 1 < rows_) ask(at + width, x, y + 1);
    if (!corners) continue;
    if (x > 0 && y > 0) ask(at - width - 1, x - 1, y - 1);
    if (x + 1 < width && y > 0) ask(at - width + 1, x + 1, y - 1);
    if (x > 0 && y + 1 < rows_) ask(at + width - 1, x - 1, y + 1);
    if (x + 1 < width && y + 1 < rows_) ask(at + width + 1, x + 1, y + 1);
  }
  keep(frame, name, extent, touched);
}

/// Shading splits a ball into blobs and cuts its dark side off: what lies about the blob and has
/// its colour in another light is of it.
void RegionGrower::grow_blob(const Frame& frame, const BlobFinder& finder, const Blob& blob,
                             std::size_t index, Name name) {
  const SameColour same(table_.line(name), config_.spread, config_.noise);
  const Reach reach(blob, config_.reach);
  const auto pixel = [&](std::int32_t at) {
    return frame.rgb.data() + 3 * static_cast<std::ptrdiff_t>(at);
  };
  Extent extent;
  extent.left = static_cast<int>(blob.box.left());
  extent.top = static_cast<int>(blob.box.top());
  extent.right = extent.left + static_cast<int>(blob.box.width) - 1;
  extent.bottom = std::min(extent.top + static_cast<int>(blob.box.height), rows_) - 1;
  for (int y = extent.top; y <= extent.bottom; ++y) {
    for (int x = extent.left; x <= extent.right; ++x) {
      const std::int32_t at = y * frame.size.width + x;
      if (finder.labels()[static_cast<std::size_t>(at)] == static_cast<std::int32_t>(index) &&
          owners_[static_cast<std::size_t>(at)] == kFree && same(pixel(at))) {
        visit(at);
      }
    }
  }
  flood(frame, name, extent, false,
        [&](std::int32_t at, int x, int y) { return reach(x, y) && same(pixel(at)); });
}

/// What is too narrow for a robust cell has no blob: slivers at the picture's edge, crescents
/// behind the other balloon.
void RegionGrower::grow_loose(const Frame& frame, Name name) {
  const SameColour same(table_.line(name), config_.spread, config_.noise);
  const std::uint8_t* rgb = frame.rgb.data();
  std::int32_t at = 0;
  for (int y = 0; y < rows_; ++y) {
    for (int x = 0; x < frame.size.width; ++x, ++at, rgb += 3) {
      if (owners_[static_cast<std::size_t>(at)] != kFree || !same(rgb)) continue;
      visit(at);
      flood(frame, name, {x, y, x, y}, true, [&](std::int32_t other, int, int) {
        return same(frame.rgb.data() + 3 * static_cast<std::ptrdiff_t>(other));
      });
    }
  }
}

/// Whatever it comes to: what has been looked at is not looked at again.
void RegionGrower::keep(const Frame& frame, Name name, const Extent& extent, std::int32_t touched) {
  const int width = frame.size.width;
  const auto index = static_cast<std::int32_t>(regions_.size());
  Region region;
  region.name = name;
  for (int y = extent.top; y <= extent.bottom; ++y) {
    std::int32_t* const row = owners_.data() + static_cast<std::ptrdiff_t>(y) * width;
    for (int x = extent.left; x <= extent.right;) {
      const int first = x;
      for (; x <= extent.right && row[x] == kGrowing; ++x) row[x] = index;
      region.sums.add_run(y, first, x,
                          frame.rgb.data() + 3 * (static_cast<std::ptrdiff_t>(y) * width + first));
      if (x == first) ++x;
    }
  }
  if (region.sums.area() < config_.least_part) {
    for (int y = extent.top; y <= extent.bottom; ++y) {
      std::int32_t* const row = owners_.data() + static_cast<std::ptrdiff_t>(y) * width;
      std::replace(row + extent.left, row + extent.right + 1, index, kTooSmall);
    }
    return;
  }
  region.blob = region.sums.blob(frame.size);
  region.light = region.blob.colour.maxCoeff() / level_;
  const bool placed = region.blob.centroid.y() <= config_.lowest * frame.size.height &&
                      (region.sums.bottom() < rows_ - 1 || rows_ == frame.size.height ||
                       region.sums.shading() >= config_.snow_shading) &&
                      region.light >= table_.dimmest(name);
  region.named = placed && table_.name(region.blob.colour, region.blob.area) == name;
  region.nearly = placed && !region.named &&
                  table_.name(region.blob.colour, region.blob.area, config_.stained) == name;
  if (touched >= 0 && region.named) {
    Region& earlier = regions_[static_cast<std::size_t>(touched)];
    if (earlier.named) {
      region.sums.add(earlier.sums);
      region.blob = region.sums.blob(frame.size);
      earlier.named = false;  // its pixels are this one's
      earlier.into = index;
    }
  }
  regions_.push_back(region);
}

/// The region that a pixel counts for, or below 0.
std::int32_t RegionGrower::owner(std::int32_t at) const {
  std::int32_t index = owners_[static_cast<std::size_t>(at)];
  if (index <= kEdge) return kEdge - index;
  while (index >= 0 && regions_[static_cast<std::size_t>(index)].into >= 0) {
    index = regions_[static_cast<std::size_t>(index)].into;
  }
  return index;
}

/// Finds the outlines of what is named, and gives it the pixels at its edge.
void RegionGrower::trace(const Frame& frame) {
  for (Region& region : regions_) region.whole = region.sums;
  const int width = frame.size.width;
  std::int32_t at = 0;
  for (int y = 0; y < rows_; ++y) {
    for (int x = 0; x < width; ++x, ++at) {
      if (owners_[static_cast<std::size_t>(at)] < 0) continue;
      const std::int32_t index = owner(at);
      const Region& region = regions_[static_cast<std::size_t>(index)];
      if (!region.named && !region.nearly) continue;
      if (x > 0) look_across(frame, index, x, y, -1, 0);
      if (x + 1 < width) look_across(frame, index, x, y, 1, 0);
      if (y > 0) look_across(frame, index, x, y, 0, -1);
      if (y + 1 < rows_) look_across(frame, index, x, y, 0, 1);
    }
  }
  for (Region& region : regions_) {
    if (!region.named && !region.nearly) continue;
    const Eigen::Vector3d colour = region.blob.colour;  // an edge has some of what is beyond it
    region.blob = region.whole.blob(frame.size);
    region.blob.colour = colour;
  }
}

/// From a pixel of a region to its neighbour, where that is not of it.
void RegionGrower::look_across(const Frame& frame, std::int32_t index, int x, int y, int dx,
                               int dy) {
  const int width = frame.size.width;
  const std::int32_t at = y * width + x, way = dy * width + dx, edge = at + way;
  if (owner(edge) == index) return;
  const auto inside = [&](int u, int v) { return u >= 0 && v >= 0 && u < width && v < rows_; };
  const auto owned = [&](std::int32_t pixel) {
    return owners_[static_cast<std::size_t>(pixel)] >= 0 && owner(pixel) == index;
  };
  const auto is_other = [&](std::int32_t pixel, Name name) {
    const std::int32_t other = owner(pixel);
    if (other < 0) return false;
    const Region& region = regions_[static_cast<std::size_t>(other)];
    return region.named && region.name != name;
  };
  // The edge itself is mixed: colours are compared beyond it and, where there is room, behind it.
  const std::int32_t beyond = inside(x + 2 * dx, y + 2 * dy) ? edge + way : edge;
  const std::int32_t behind = inside(x - dx, y - dy) && owned(at - way) ? at - way : at;
  const Eigen::Vector3f in = colour_at(frame, behind), out = colour_at(frame, beyond);

  Region& region = regions_[static_cast<std::size_t>(index)];
  ++region.outline.sides;
  if (table_.apart(out.cast<double>(), region.name) > kStep) ++region.outline.steps;
  if (is_other(beyond, region.name)) ++region.outline.shared;

  std::int32_t& holder = owners_[static_cast<std::size_t>(edge)];
  if (holder <= kEdge) return;
  if (holder >= 0 && regions_[static_cast<std::size_t>(owner(edge))].named) return;
  const Eigen::Vector3f all = in - out;
  if (all.squaredNorm() < kContrast * kContrast) return;
  if ((colour_at(frame, edge) - out).dot(all) < 0.5F * all.squaredNorm()) return;
  holder = kEdge - index;
  region.whole.add_run(y + dy, x + dx, x + dx + 1,
                       frame.rgb.data() + 3 * static_cast<std::ptrdiff_t>(edge));
}

}  // namespace pacer::exemplar
