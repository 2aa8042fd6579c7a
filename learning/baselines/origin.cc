// SPDX-License-Identifier: Apache-2.0
#include "learning/baselines/origin.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "learning/sealed_file.h"

namespace pacer::baselines {

Origin Origin::of(const Demonstration& demonstration, const std::string& scenario) {
  return {.image_size = demonstration.image_size(),
          .frame_rate_hz = demonstration.frame_rate_hz(),
          .scenario = scenario,
          .fingerprint = demonstration.fingerprint(),
          .mean = {}};
}

void Origin::write(ByteWriter& out) const {
  out.value(static_cast<std::int32_t>(image_size.width));
  out.value(static_cast<std::int32_t>(image_size.height));
  out.value(frame_rate_hz);
  out.text(scenario);
  out.text(fingerprint);
  out.value(mean.steering);
  out.value(mean.throttle);
}

Origin Origin::read(ByteReader& in) {
  constexpr int kMostSide = 1 << 14;  // pixels
  Origin origin;
  origin.image_size.width = in.value<std::int32_t>();
  origin.image_size.height = in.value<std::int32_t>();
  for (const int side : {origin.image_size.width, origin.image_size.height}) {
    sane(side > 0 && side <= kMostSide, "image size");
  }
  origin.frame_rate_hz = in.value<double>();
  sane(std::isfinite(origin.frame_rate_hz) && origin.frame_rate_hz > 0.0, "frame rate");
  origin.scenario = in.text();
  origin.fingerprint = in.text();
  origin.mean.steering = in.value<double>();
  origin.mean.throttle = in.value<double>();
  sane(std::abs(origin.mean.steering) <= 1.0 && std::abs(origin.mean.throttle) <= 1.0,
       "mean command");
  return origin;
}

void Origin::require_size(const Frame& frame) const {
  if (frame.size == image_size) return;
  throw std::runtime_error(
      fmt::format("a picture of {} x {}, and the model was learnt from {} x {}; train it on "
                  "pictures of this size",
                  frame.size.width, frame.size.height, image_size.width, image_size.height));
}

}  // namespace pacer::baselines
