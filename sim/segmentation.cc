// SPDX-License-Identifier: Apache-2.0
#include "sim/segmentation.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"

namespace pacer::sim {
namespace {

// Each in a channel of its own, so that an edge between two is told by the larger share.
constexpr Rgb kRedBalloon{255, 0, 0};
constexpr Rgb kGreenBalloon{0, 255, 0};
constexpr Rgb kRest{0, 0, 255};

/// Paints the hull and what else has its colour (the knot) of the balloon called `name`.
void paint(const mjModel& model, const char* name, Rgb colour, std::vector<Rgb>& colours) {
  const int hull = mj_name2id(&model, mjOBJ_GEOM, name);
  if (hull < 0) return;
  const float* const rubber = model.geom_rgba + 4L * hull;
  for (int geom = 0; geom < model.ngeom; ++geom) {
    if (model.geom_bodyid[geom] == model.geom_bodyid[hull] &&
        std::equal(rubber, rubber + 4, model.geom_rgba + 4L * geom)) {
      colours[static_cast<std::size_t>(geom)] = colour;
    }
  }
}

Label label_of(const std::uint8_t* rgb) {
  constexpr std::uint8_t kHalf = 128;
  return rgb[0] >= kHalf ? Label::kRed : rgb[1] >= kHalf ? Label::kGreen : Label::kOther;
}

/// Counts one more pixel.
void add(int x, int y, bool covered, BalloonSight& sight) {
  if (covered) {
    ++sight.covered;
    return;
  }
  const Eigen::Vector2d pixel(x, y);
  sight.low = sight.pixels == 0 ? pixel : sight.low.cwiseMin(pixel);
  sight.high = sight.pixels == 0 ? pixel : sight.high.cwiseMax(pixel);
  sight.centroid += pixel;  // a sum, for the time being
  ++sight.pixels;
}

}  // namespace

Segmentation::Segmentation(const mjModel& model, const Lens& lens)
    : size_(lens.size()), colours_(static_cast<std::size_t>(model.ngeom), kRest) {
  paint(model, "red_balloon", kRedBalloon, colours_);
  paint(model, "green_balloon", kGreenBalloon, colours_);
  const std::size_t pixels =
      static_cast<std::size_t>(size_.width) * static_cast<std::size_t>(size_.height);
  labels_.resize(pixels);
  sources_.reserve(pixels);
  const auto nearest = [](double at, int size) {
    return static_cast<std::uint32_t>(std::clamp<long>(std::lround(at), 0, size - 1));
  };
  for (int y = 0; y < size_.height; ++y) {
    for (int x = 0; x < size_.width; ++x) {
      const Eigen::Vector2d source = lens.source({x, y});
      sources_.push_back(nearest(source.y(), size_.height) *
                             static_cast<std::uint32_t>(size_.width) +
                         nearest(source.x(), size_.width));
    }
  }
}

const BalloonSights& Segmentation::look(const mjModel& model, mjData& data, Renderer& renderer,
                                        std::span<const RowBand> covered) {
  check(renderer.size() == size_, "the segmentation is of pictures of the lens's size");
  renderer.render_flat(model, data, colours_, kRest, flat_);
  sights_ = {};
  std::size_t pixel = 0;
  for (int y = 0; y < size_.height; ++y) {
    const bool spoilt = std::ranges::any_of(
        covered, [y](const RowBand& band) { return y >= band.first && y < band.last; });
    if (spoilt) ++sights_.spoilt_rows;
    for (int x = 0; x < size_.width; ++x, ++pixel) {
      const Label label = label_of(flat_.rgb.data() + std::size_t{3} * sources_[pixel]);
      labels_[pixel] = label;
      if (label == Label::kOther) continue;
      add(x, y, spoilt, label == Label::kRed ? sights_.red : sights_.green);
    }
  }
  for (BalloonSight* sight : {&sights_.red, &sights_.green}) {
    if (sight->pixels > 0) sight->centroid /= sight->pixels;
  }
  return sights_;
}

}  // namespace pacer::sim
