// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/balloon_choice.h"

#include <algorithm>
#include <cmath>

namespace pacer::exemplar {
namespace {

/// The pixels between two boxes, left and right of each other or else above and below, as high or
/// as wide as they are in the mean.
PixelRectangle between(const Box& a, const Box& b, bool across) {
  const auto span = [](double a_low, double a_size, double b_low, double b_size) {
    const double low = std::min(a_low + a_size, b_low + b_size), high = std::max(a_low, b_low);
    return std::pair{static_cast<int>(low), static_cast<int>(high)};
  };
  const auto mean = [](double a_low, double a_size, double b_low, double b_size) {
    return std::pair{static_cast<int>(std::lround(0.5 * (a_low + b_low))),
                     static_cast<int>(std::lround(0.5 * (a_low + a_size + b_low + b_size)))};
  };
  const auto [left, right] = across ? span(a.left(), a.width, b.left(), b.width)
                                    : mean(a.left(), a.width, b.left(), b.width);
  const auto [top, bottom] = across ? mean(a.top(), a.height, b.top(), b.height)
                                    : span(a.top(), a.height, b.top(), b.height);
  return {.left = left, .top = top, .right = right, .bottom = bottom};
}

/// Whether a string, a table's leg or the other balloon may have cut one balloon into these two.
bool one_balloon(const Region& a, const Region& b, ImageSize size, const BalloonConfig& config) {
  Moments both = a.sums;
  both.add(b.sums);
  const Blob whole = both.blob(size);
  const Box &one = a.blob.box, &other = b.blob.box;
  // What lies between them, along the axis on which they are farther apart, and may be hidden.
  const double across = (whole.box.width - one.width - other.width) / whole.box.width;
  const double down = (whole.box.height - one.height - other.height) / whole.box.height;
  const double gap = std::max({across, down, 0.0});
  if (gap > config.gap) return false;
  constexpr double kRound = 0.97;  // fill of what nothing hides
  if (std::max(fill(a.blob), fill(b.blob)) > kRound) return false;
  // What is cut in two by one edge has two plain parts, with edges of about the same length.
  constexpr double kPlain = 0.8;
  if (std::min(fill(a.blob), fill(b.blob)) < kPlain) return false;
  if (std::min({one.width, one.height, other.width, other.height}) < 2.0) return false;
  const double edge = across > down ? one.height / other.height : one.width / other.width;
  constexpr double kAlike = 0.4;
  if (std::min(edge, 1.0 / edge) < kAlike) return false;
  constexpr double kSeen = 0.18;  // of it all, at least
  const auto both_area = static_cast<double>(both.area());
  both.add_rectangle(between(one, other, across > down));
  return both_area >= kSeen * static_cast<double>(both.area()) &&
         fill(both.blob(size)) >= config.joint_fill;
}

/// Whether what is seen of one thing, in one part or in two, may be a balloon.
bool shaped(const Moments& sums, const Blob& blob, bool in_parts, const BalloonConfig& config) {
  if (blob.area < config.least_area) return false;
  const bool cut = blob.cut.left || blob.cut.top || blob.cut.right || blob.cut.bottom;
  // Half of it seen, from near and below, a balloon is lit evenly.
  const bool near = blob.area >= config.near_area && cut;
  const double shading =
      blob.area < config.tiny_area && !cut ? config.tiny_shading : config.shading;
  if (!near && sums.shading() < shading) return false;
  if (in_parts) return true;  // together they have the shape
  const double length =
      std::max(blob.box.width, blob.box.height) / std::min(blob.box.width, blob.box.height);
  const double least = blob.area < config.small_area ? config.small_fill : config.least_fill;
  return fill(blob) >= least && (cut || length <= config.longest);
}

/// The same of what looks out behind the other balloon, which may be all of its dark underside.
bool shaped_behind(const Moments& sums, const BalloonConfig& config) {
  constexpr double kFaint = 40.0;  // pixels
  constexpr double kUnderside = -0.4;
  const auto area = static_cast<double>(sums.area());
  if (area < config.least_behind) return false;
  return sums.shading() >= (area < kFaint ? config.behind_shading : kUnderside);
}

/// Whether a region lies at the rim of the other balloon, which may hide the rest of it.
bool peeps_out(const Region& region, const Blob& other, const BalloonConfig& config) {
  constexpr double kCrescent = 0.45;  // fill
  return region.blob.area < other.area && fill(region.blob) >= kCrescent &&
         Reach(other, config.rim)(region.blob.centroid.x(), region.blob.centroid.y());
}

}  // namespace

std::optional<Blob> choose_balloon(std::span<Region> regions, Name name, ImageSize size,
                                   const std::optional<Blob>& other, const BalloonConfig& config) {
  std::optional<Blob> best;
  for (Region& region : regions) region.taken = !region.named || region.name != name;
  for (;;) {
    Region* largest = nullptr;
    for (Region& region : regions) {
      if (!region.taken && (largest == nullptr || region.sums.area() > largest->sums.area())) {
        largest = &region;
      }
    }
    if (largest == nullptr) return best;
    largest->taken = true;
    const bool behind = other && peeps_out(*largest, *other, config);
    Moments sums = largest->sums;
    bool in_parts = false;
    for (Region& part : regions) {
      if (part.taken) continue;
      if (behind && peeps_out(part, *other, config)) {
        part.taken = true;
        sums.add(part.sums);
      } else if (!in_parts && one_balloon(*largest, part, size, config)) {
        in_parts = part.taken = true;  // one thing hides it
        sums.add(part.sums);
      }
    }
    const Blob whole = sums.blob(size);
    const bool balloon =
        behind ? shaped_behind(sums, config) : shaped(sums, whole, in_parts, config);
    if (balloon && (!best || whole.area > best->area)) best = whole;
  }
}

}  // namespace pacer::exemplar
