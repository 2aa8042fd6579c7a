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
  Moments both = a.whole;
  both.add(b.whole);
  const Blob whole = both.blob(size);
  const Box &one = a.blob.box, &other = b.blob.box;
  // What lies between them, along the axis on which they are farther apart, and may be hidden.
  const double across = (whole.box.width - one.width - other.width) / whole.box.width;
  const double down = (whole.box.height - one.height - other.height) / whole.box.height;
  const double gap = std::max({across, down, 0.0});
  if (gap > config.gap) return false;
  constexpr double kLong = 1.75;  // length over width of two parts and what is between
  if (std::max(whole.box.width, whole.box.height) >
      kLong * std::min(whole.box.width, whole.box.height)) {
    return false;
  }
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

/// What may be one balloon, in one part or in several.
struct Candidate {
  Moments sums;   // of what is surely it
  Moments whole;  // with its edge
  double step = 0.0, light = 0.0;
  bool in_parts = false;

  explicit Candidate(const Region& region)
      : sums(region.sums),
        whole(region.whole),
        step(region.outline.step_share()),
        light(region.light) {}

  void add(const Region& part) {
    const auto area = static_cast<double>(whole.area());
    const auto more = static_cast<double>(part.whole.area());
    step = (area * step + more * part.outline.step_share()) / (area + more);
    sums.add(part.sums);
    whole.add(part.whole);
  }
};

/// Whether a thing of its size may be where it is: the farther away, and the smaller, the nearer
/// is a balloon to the horizon.
bool placed(const Blob& blob, ImageSize size, const BalloonConfig& config) {
  const double above = config.horizon * size.height - blob.centroid.y();
  return above <= config.highest * std::max(blob.box.width, blob.box.height);
}

/// Whether what is about it is of another colour, as it is about a balloon: next to a brick is
/// another brick. What is large, or well shaded, may hang before a thing of its colour.
bool apart(const Candidate& candidate, const Blob& blob, const BalloonConfig& config) {
  constexpr double kLarge = 400.0;  // pixels
  if (blob.area >= kLarge) return true;
  const bool beside = blob.cut.left || blob.cut.right;
  return (blob.area >= config.small_area || candidate.step >= config.small_step) &&
         candidate.step + 0.5 * candidate.sums.shading() >=
             (beside ? config.side_clear : config.clear);
}

/// Whether what is seen of one thing may be a balloon.
bool shaped(const Candidate& candidate, const Blob& blob, const BalloonConfig& config) {
  if (blob.area < config.least_area) return false;
  const double shading = candidate.sums.shading();
  const bool cut = blob.cut.left || blob.cut.top || blob.cut.right || blob.cut.bottom;
  const bool beside = blob.cut.left || blob.cut.right;
  // Half of it seen, from near and below, a balloon is lit evenly; so is the side of one.
  const bool near = blob.area >= config.near_area && cut;
  constexpr double kPlain = 0.85;  // fill
  // A balloon is higher than wide, the front of a box or a book is not.
  const bool wide = blob.box.width > 1.25 * blob.box.height;
  const double least_shading = blob.area < config.tiny_area && !cut
                                   ? (wide ? config.wide_shading : config.tiny_shading)
                               : beside && fill(blob) >= kPlain ? config.side_shading
                                                                : config.shading;
  if (!near && shading < least_shading) return false;
  const double length =
      std::max(blob.box.width, blob.box.height) / std::min(blob.box.width, blob.box.height);
  constexpr double kParts = 55.0;                      // pixels
  if (candidate.in_parts) return blob.area >= kParts;  // together they have the shape
  const double least = blob.area < config.small_area ? config.small_fill : config.least_fill;
  return fill(blob) >= least && (cut || length <= config.longest);
}

/// The same of what looks out behind the other balloon, which may be all of its dark underside.
bool shaped_behind(const Candidate& candidate, const Blob& blob, const BalloonConfig& config) {
  constexpr double kFaint = 40.0;  // pixels
  constexpr double kUnderside = -0.5;
  constexpr double kDark = 0.95;      // of the picture's mean level
  constexpr double kScattered = 0.2;  // fill
  constexpr double kStep = 0.65;      // share of its outline
  constexpr double kLarge = 400.0;    // pixels
  if (blob.area < config.least_behind || fill(blob) < kScattered ||
      (blob.area < kLarge && candidate.step < kStep)) {
    return false;
  }
  const double shading = candidate.sums.shading();
  if (shading < 0.0 && blob.area < config.small_area && candidate.light > kDark) return false;
  return shading >= (blob.area < kFaint ? config.behind_shading : kUnderside);
}

/// Whether a region lies at the rim of the other balloon, which may hide the rest of it. A small
/// one shares an edge with it.
bool peeps_out(const Region& region, const Blob& other, const BalloonConfig& config) {
  constexpr double kShared = 0.18;  // of its outline
  const double shared = region.outline.shared_share();
  if (region.blob.area < config.small_area && shared < kShared) return false;
  // A thin crescent bends about the other; it shares almost half of its outline with it.
  constexpr double kThin = 0.3, kThinFill = 0.25, kFill = 0.45;
  return region.blob.area < other.area &&
         fill(region.blob) >= (shared >= kThin ? kThinFill : kFill) &&
         Reach(other, config.rim)(region.blob.centroid.x(), region.blob.centroid.y());
}

/// Whether what looks out on two sides of the other balloon may be one that is behind it, and hence
/// not much larger.
bool no_wider(const Candidate& candidate, const Region& part, const Blob& other) {
  constexpr double kMost = 1.1;
  const double width = std::max(candidate.whole.right(), part.whole.right()) -
                       std::min(candidate.whole.left(), part.whole.left()) + 1;
  const double height = std::max(candidate.whole.bottom(), part.whole.bottom()) -
                        std::min(candidate.whole.top(), part.whole.top()) + 1;
  return width <= kMost * other.box.width && height <= kMost * other.box.height;
}

}  // namespace

std::optional<Blob> choose_balloon(std::span<Region> regions, Name name, ImageSize size,
                                   const std::optional<Blob>& other, const BalloonConfig& config) {
  std::optional<Blob> best;
  for (Region& region : regions) {
    region.taken = region.name != name || !(region.named || region.nearly);
  }
  for (;;) {
    Region* largest = nullptr;
    for (Region& region : regions) {
      if (!region.taken && (largest == nullptr || region.blob.area > largest->blob.area)) {
        largest = &region;
      }
    }
    if (largest == nullptr) return best;
    largest->taken = true;
    const bool behind = other && peeps_out(*largest, *other, config);
    if (!behind && !largest->named) continue;
    Candidate candidate(*largest);
    for (Region& part : regions) {
      if (part.taken) continue;
      if (behind && peeps_out(part, *other, config) && no_wider(candidate, part, *other)) {
        part.taken = true;
        candidate.add(part);
      } else if (!candidate.in_parts && one_balloon(*largest, part, size, config)) {
        candidate.in_parts = part.taken = true;  // one thing hides it
        candidate.add(part);
      }
    }
    Blob blob = candidate.whole.blob(size);
    blob.colour = candidate.sums.blob(size).colour;  // an edge has some of what is beyond it
    const bool balloon =
        placed(blob, size, config) &&
        (behind ? shaped_behind(candidate, blob, config)
                : apart(candidate, blob, config) && shaped(candidate, blob, config));
    if (balloon && (!best || blob.area > best->area)) best = blob;
  }
}

}  // namespace pacer::exemplar
