// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>

#include "core/frame.h"
#include "core/random.h"
#include "sim/exposure.h"
#include "sim/lens.h"
#include "sim/motion_blur.h"
#include "sim/radio_link.h"
#include "sim/renderer.h"
#include "sim/segmentation.h"
#include "sim/sensor.h"
#include "sim/visibility.h"
#include "sim/world.h"

namespace pacer::sim {

/// The camera on the car, its picture's way to us included.
struct CameraConfig {
  int width = 320;              ///< pixels
  int height = 240;             ///< pixels
  double frame_rate_hz = 25.0;  ///< pictures a second
  Range delay{0.08, 0.10};      ///< seconds from shutter to look(); rounded up to a time step
  LensConfig lens;
  ExposureConfig exposure;
  RadioLinkConfig link;
  RenderConfig render;

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("width_px", width);
    visit("height_px", height);
    visit("frame_rate_hz", frame_rate_hz);
    visit("delay_s", delay);
    visit("lens", lens);
    visit("exposure", exposure);
    visit("link", link);
    visit("render", render);
  }

  [[nodiscard]] ImageSize size() const noexcept { return {.width = width, .height = height}; }
};

/// Takes pictures: what is rendered goes through blur, lens, exposure, noise and the radio link.
class Camera {
 public:
  /// `lens` is the one that the world's camera was made for. One OpenGL context each.
  Camera(const CameraConfig& config, const Lens& lens, const World& world, const Random& random);

  /// A picture of the world as World::observe() left it, into `out`'s size and pixels.
  /// Returns the rows that the radio link spoilt; lives until the next call.
  [[nodiscard]] std::span<const RowBand> take(World& world, Frame& out);

  /// What the picture that take() has just taken shows of the balloons; `spoilt` is what take()
  /// returned. Costs another rendering. The world must not have moved on; lives until the next
  /// call.
  [[nodiscard]] const BalloonSights& balloons(World& world, std::span<const RowBand> spoilt);

  /// How points get into the pictures.
  [[nodiscard]] PictureGeometry geometry() const;

 private:
  Lens lens_;
  Seconds period_;
  Renderer renderer_;
  MotionBlur blur_;
  Exposure exposure_;
  Sensor sensor_;
  RadioLink link_;
  std::optional<Segmentation> segmentation_;  // made when first asked for
  Frame rendered_;
};

}  // namespace pacer::sim
