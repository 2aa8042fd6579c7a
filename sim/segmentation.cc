// SPDX-License-Identifier: Apache-2.0
#include "sim/segmentation.h"

#include <algorithm>

#include "core/check.h"
#include "sim/motion_blur.h"

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

/// Index of the tile of the motion field that holds a pixel.
std::size_t tile_of(int x, int y, int across) {
  return static_cast<std::size_t>(y / MotionBlur::kTileHeight * across +
                                  x / MotionBlur::kTileWidth);
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
  for (int y = 0; y < size_.height; ++y) {
    for (int x = 0; x < size_.width; ++x) {
      sources_.emplace_back(lens.source({x, y}).cast<float>());
    }
  }
}

const BalloonSights& Segmentation::look(const mjModel& model, mjData& data, Renderer& renderer,
                                        std::span<const RowBand> covered,
                                        std::span<const Eigen::Vector2f> field) {
  check(renderer.size() == size_, "the segmentation is of pictures of the lens's size");
  renderer.render_flat(model, data, colours_, kRest, flat_);
  sights_ = {};
  const int across = (size_.width + MotionBlur::kTileWidth - 1) / MotionBlur::kTileWidth;
  const Eigen::Array2f last(size_.width - 1, size_.height - 1);
  std::size_t pixel = 0;
  for (int y = 0; y < size_.height; ++y) {
    const bool spoilt = std::ranges::any_of(
        covered, [y](const RowBand& band) { return y >= band.first && y < band.last; });
    if (spoilt) ++sights_.spoilt_rows;
    for (int x = 0; x < size_.width; ++x, ++pixel) {
      Eigen::Vector2f source = sources_[pixel];
      if (!field.empty()) source += 0.5F * field[tile_of(x, y, across)];
      const Eigen::Array2i nearest =
          (source.array() + 0.5F).max(0.0F).min(last).cast<int>();  // rounds
      const Label label = label_of(flat_.rgb.data() +
                                   std::ptrdiff_t{3} * (nearest.y() * size_.width + nearest.x()));
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
