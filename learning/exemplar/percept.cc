// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/percept.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include "core/check.h"

namespace pacer::exemplar {
namespace {

/// How many rows there are above the first one of snow.
int rows_above_snow(const Frame& frame, double limit) noexcept {
  const int width = frame.size.width;
  if (width < 2) return frame.size.height;
  const auto most = static_cast<std::int64_t>(limit * (width - 1));
  const std::uint8_t* green = frame.rgb.data() + 1;
  for (int y = 0; y < frame.size.height; ++y, green += 3 * static_cast<std::ptrdiff_t>(width)) {
    std::int64_t sum = 0;
    for (int x = 1; x < width; ++x) sum += std::abs(green[3 * x] - green[3 * x - 3]);
    if (sum > most) return y;
  }
  return frame.size.height;
}

double mean_level(const Frame& frame) noexcept {
  std::uint64_t sum = 0;
  for (const std::uint8_t level : frame.rgb) sum += level;
  return static_cast<double>(sum) / std::max<double>(1.0, static_cast<double>(frame.rgb.size()));
}

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

constexpr std::int32_t kFree = -2, kGrowing = -1;

/// Whether a pixel has the colour of `shares`, whatever falls on it.
class SameColour {
 public:
  SameColour(const Eigen::Vector3d& shares, double spread, double noise)
      : shares_(shares.cast<float>()),
        spread_(static_cast<float>(spread)),
        noise_(static_cast<float>(noise)) {}

  bool operator()(const std::uint8_t* rgb) const noexcept {
    const auto r = static_cast<float>(rgb[0]), g = static_cast<float>(rgb[1]),
               b = static_cast<float>(rgb[2]);
    const float sum = r + g + b;
    const float dr = r - sum * shares_[0], dg = g - sum * shares_[1], db = b - sum * shares_[2];
    const float most = spread_ * sum + noise_;
    return dr * dr + dg * dg + db * db <= most * most && sum > 5.0F * noise_;
  }

 private:
  Eigen::Vector3f shares_;
  float spread_, noise_;
};

/// The ellipse about a blob, larger.
class Reach {
 public:
  Reach(const Blob& blob, double times) : x_(blob.centroid.x()), y_(blob.centroid.y()) {
    constexpr double kPixel = 1.0;  // a pixel's margin for the small
    const double xx = blob.xx * times * times + kPixel, yy = blob.yy * times * times + kPixel;
    const double xy = blob.xy * times * times;
    const double determinant = xx * yy - xy * xy;
    a_ = yy / determinant;
    b_ = -2.0 * xy / determinant;
    c_ = xx / determinant;
  }
  bool operator()(int x, int y) const noexcept {
    const double u = x - x_, v = y - y_;
    return a_ * u * u + b_ * u * v + c_ * v * v <= 4.0;  // two deviations: an ellipse's own rim
  }

 private:
  double x_, y_, a_, b_, c_;
};

}  // namespace

void BalloonConfig::validate() const {
  require(spread >= 0.0 && spread <= 1.0, "spread: must lie in [0, 1]");
  require(noise >= 0.0 && noise <= 50.0, "noise: must lie in [0, 50]");
  require(reach >= 1.0, "reach: must be at least 1");
  require(least_area >= 1.0, "least_area_px: must be at least 1");
  require(least_fill >= 0.0 && least_fill <= 1.0, "least_fill: must lie in [0, 1]");
  require(joint_fill >= 0.0 && joint_fill <= 1.0, "joint_fill: must lie in [0, 1]");
  require(longest >= 1.0, "longest: must be at least 1");
  require(shading >= -2.0 && shading <= 2.0, "shading: must lie in [-2, 2]");
  require(small_area >= 0.0, "small_area_px: must not be negative");
  require(small_shading >= -2.0 && small_shading <= 2.0, "small_shading: must lie in [-2, 2]");
  require(near_area >= 0.0, "near_area_px: must not be negative");
  require(lowest >= 0.0 && lowest <= 1.0, "lowest: must lie in [0, 1]");
  require(gap >= 0.0 && gap < 1.0, "gap: must lie in [0, 1)");
  require(interference > 0.0, "interference: must be positive");
}

void PerceptConfig::validate() const {
  PerceptConfig copy = *this;
  copy.fields([](const char* name, auto& section) {
    try {
      section.validate();
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(std::string(name) + "." + error.what());
    }
  });
}

Percept percept(const Balloons& balloons) noexcept {
  Percept values{};
  std::size_t at = 0;
  for (const std::optional<Blob>* one : {&balloons.red, &balloons.green}) {
    if (*one) {
      const Blob& blob = **one;
      const std::array<double, kBalloonValues> nine = {
          blob.area, blob.centroid.x(), blob.centroid.y(), blob.xx,       blob.xy,
          blob.yy,   blob.colour[0],    blob.colour[1],    blob.colour[2]};
      std::ranges::copy(nine, values.begin() + static_cast<std::ptrdiff_t>(at));
    }
    at += kBalloonValues;
  }
  return values;
}

Balloons balloons(const Percept& percept) noexcept {
  Balloons both;
  const double* nine = percept.data();
  for (std::optional<Blob>* one : {&both.red, &both.green}) {
    if (nine[0] > 0.0) {
      Blob& blob = one->emplace();
      blob.area = nine[0];
      blob.centroid = {nine[1], nine[2]};
      blob.xx = nine[3];
      blob.xy = nine[4];
      blob.yy = nine[5];
      blob.colour = {nine[6], nine[7], nine[8]};
    }
    nine += kBalloonValues;
  }
  return both;
}

void mark(const Balloons& balloons, Annotations& annotations) {
  if (balloons.red) mark(*balloons.red, Tone::kTarget, annotations);
  if (balloons.green) mark(*balloons.green, Tone::kNeutral, annotations);
}

BalloonFinder::BalloonFinder(const PerceptConfig& config)
    : config_(config), finder_(config.blobs), table_(config.colours) {
  config_.validate();
}

const Balloons& BalloonFinder::find(const Frame& frame) {
  blobs_ = finder_.find(frame);
  rows_ = rows_above_snow(frame, config_.balloons.interference);
  whole_ = rows_ == frame.size.height;
  level_ = mean_level(frame);
  const std::size_t pixels = finder_.labels().size();
  owners_.assign(pixels, kFree);
  front_.clear();
  front_.reserve(pixels);
  regions_.clear();
  regions_.reserve(pixels / static_cast<std::size_t>(config_.blobs.least_area) + 1);
  for (std::size_t i = 0; i < blobs_.size(); ++i) {
    const Name name = table_.nearest(blobs_[i].colour);
    if (name != Name::kNone) grow(frame, i, name);
  }
  balloons_.red = choose(Name::kRed, frame.size, {});
  balloons_.green = choose(Name::kGreen, frame.size, balloons_.red);
  if (!balloons_.red) balloons_.red = choose(Name::kRed, frame.size, balloons_.green);
  return balloons_;
}

/// Shading splits a ball into blobs and cuts its dark side off: what lies about the blob and has
/// its colour in another light is of it.
void BalloonFinder::grow(const Frame& frame, std::size_t seed, Name name) {
  const Blob& blob = blobs_[seed];
  const SameColour same(table_.shares(name), config_.balloons.spread, config_.balloons.noise);
  const Reach reach(blob, config_.balloons.reach);
  const int width = frame.size.width;
  const std::span<const std::int32_t> labels = finder_.labels();
  int left = static_cast<int>(blob.box.left()), top = static_cast<int>(blob.box.top());
  int right = left + static_cast<int>(blob.box.width) - 1;
  int bottom = std::min(top + static_cast<int>(blob.box.height), rows_) - 1;
  const auto visit = [&](std::int32_t at) {
    owners_[static_cast<std::size_t>(at)] = kGrowing;
    front_.push_back(at);
  };
  for (int y = top; y <= bottom; ++y) {
    for (int x = left; x <= right; ++x) {
      const std::int32_t at = y * width + x;
      if (labels[static_cast<std::size_t>(at)] == static_cast<std::int32_t>(seed) &&
          owners_[static_cast<std::size_t>(at)] == kFree &&
          same(frame.rgb.data() + 3 * static_cast<std::ptrdiff_t>(at))) {
        visit(at);
      }
    }
  }
  std::int32_t touched = kFree;  // an earlier region of the name
  while (!front_.empty()) {
    const std::int32_t at = front_.back();
    front_.pop_back();
    const int x = at % width, y = at / width;
    left = std::min(left, x);
    right = std::max(right, x);
    top = std::min(top, y);
    bottom = std::max(bottom, y);
    const auto ask = [&](std::int32_t other, int u, int v) {
      const std::int32_t owner = owners_[static_cast<std::size_t>(other)];
      if (owner >= 0 && regions_[static_cast<std::size_t>(owner)].name == name) {
        touched = std::max(touched, owner);
      }
      if (owner == kFree && reach(u, v) &&
          same(frame.rgb.data() + 3 * static_cast<std::ptrdiff_t>(other))) {
        visit(other);
      }
    };
    if (x > 0) ask(at - 1, x - 1, y);
    if (x + 1 < width) ask(at + 1, x + 1, y);
    if (y > 0) ask(at - width, x, y - 1);
    if (y + 1 < rows_) ask(at + width, x, y + 1);
  }
  // Whatever it comes to: what has been looked at is not looked at again.
  const auto index = static_cast<std::int32_t>(regions_.size());
  Region& region = regions_.emplace_back();
  region.name = name;
  for (int y = top; y <= bottom; ++y) {
    std::int32_t* const row = owners_.data() + static_cast<std::ptrdiff_t>(y) * width;
    for (int x = left; x <= right;) {
      const int first = x;
      for (; x <= right && row[x] == kGrowing; ++x) row[x] = index;
      region.sums.add_run(y, first, x,
                          frame.rgb.data() + 3 * (static_cast<std::ptrdiff_t>(y) * width + first));
      if (x == first) ++x;
    }
  }
  if (region.sums.area() > 0) region.blob = region.sums.blob(frame.size);
  region.named = region.sums.area() > 0 && table_.name(region.blob.colour) == name &&
                 region.blob.centroid.y() <= config_.balloons.lowest * frame.size.height &&
                 region.blob.colour.maxCoeff() >= table_.dimmest(name) * level_;
  if (touched < 0 || !region.named) return;
  Region& earlier = regions_[static_cast<std::size_t>(touched)];
  if (!earlier.named) return;
  region.sums.add(earlier.sums);
  region.blob = region.sums.blob(frame.size);
  earlier.named = false;  // its pixels are this one's
}

/// Whether a string, a table's leg or the other balloon may have cut one balloon into these two.
bool BalloonFinder::one_balloon(const Region& a, const Region& b, ImageSize size) const {
  Moments both = a.sums;
  both.add(b.sums);
  const Blob whole = both.blob(size);
  const Box &one = a.blob.box, &other = b.blob.box;
  // What lies between them, along the axis on which they are farther apart, and may be hidden.
  const double across = (whole.box.width - one.width - other.width) / whole.box.width;
  const double down = (whole.box.height - one.height - other.height) / whole.box.height;
  const double gap = std::max({across, down, 0.0});
  if (gap > config_.balloons.gap) return false;
  // What is cut in two by one edge has two plain parts, with edges of about the same length.
  constexpr double kPlain = 0.7;
  if (std::min(fill(a.blob), fill(b.blob)) < kPlain) return false;
  const double edge = across > down ? one.height / other.height : one.width / other.width;
  constexpr double kAlike = 0.4;
  if (std::min(edge, 1.0 / edge) < kAlike) return false;
  constexpr double kSeen = 0.28;  // of it all, at least
  const auto both_area = static_cast<double>(both.area());
  both.add_rectangle(between(one, other, across > down));
  return both_area >= kSeen * static_cast<double>(both.area()) &&
         fill(both.blob(size)) >= config_.balloons.joint_fill;
}

bool BalloonFinder::shaped(const Region& region, bool in_parts) const noexcept {
  constexpr double kRound = 0.96;  // fill of what has no corners
  const BalloonConfig& config = config_.balloons;
  const Blob& blob = region.blob;
  if (blob.area < config.least_area) return false;
  const bool cut = blob.cut.left || blob.cut.top || blob.cut.right || blob.cut.bottom;
  // Half of it seen, from near and below, a balloon is lit evenly.
  const bool near = blob.area >= config.near_area && (cut || fill(blob) >= kRound);
  const double shading = blob.area < config.small_area ? config.small_shading : config.shading;
  if (!near && region.sums.shading() < shading) return false;
  if (in_parts) return true;  // together they have the shape
  const double length =
      std::max(blob.box.width, blob.box.height) / std::min(blob.box.width, blob.box.height);
  return fill(blob) >= config.least_fill && (cut || length <= config.longest);
}

/// Whether `blob` is a crescent at the rim of the other balloon, which hides the rest of it.
bool BalloonFinder::peeps_out(const Region& region, const Blob& other) const noexcept {
  const Blob& blob = region.blob;
  constexpr double kRim = 1.35;  // ellipses of the other, that its middle lies within
  return blob.area >= config_.balloons.least_area && blob.area < other.area &&
         region.sums.shading() >= 0.0 &&
         Reach(other, kRim)(static_cast<int>(blob.centroid.x()),
                            static_cast<int>(blob.centroid.y()));
}

/// The largest that has the shape, with the parts that belong to it.
std::optional<Blob> BalloonFinder::choose(Name name, ImageSize size,
                                          const std::optional<Blob>& other) {
  std::optional<Blob> best;
  for (Region& region : regions_) region.taken = !region.named;
  for (;;) {
    Region* largest = nullptr;
    for (Region& region : regions_) {
      if (region.name == name && !region.taken &&
          (largest == nullptr || region.sums.area() > largest->sums.area())) {
        largest = &region;
      }
    }
    if (largest == nullptr) return best;
    largest->taken = true;
    Region whole = *largest;
    for (Region& part : regions_) {
      if (part.name != name || part.taken || !one_balloon(whole, part, size)) continue;
      part.taken = true;
      whole.sums.add(part.sums);
      whole.blob = whole.sums.blob(size);
      break;  // one thing hides it
    }
    const bool in_parts = whole.sums.area() > largest->sums.area();
    const bool behind = other && peeps_out(whole, *other);
    if ((behind || shaped(whole, in_parts)) && (!best || whole.blob.area > best->area))
      best = whole.blob;
  }
}

}  // namespace pacer::exemplar
