// SPDX-License-Identifier: Apache-2.0
#include "sim/lens.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/check.h"
#include "sim/chassis.h"

namespace pacer::sim {
namespace {

constexpr double kMargin = 3.0;  // pixels beyond the picture that blur may reach into

}  // namespace

void LensConfig::validate() const {
  view_angle.validate("view_angle_deg", 20.0, 100.0);
  distortion.validate("distortion", -0.12, 0.12);
}

Lens::Lens(const LensConfig& config, ImageSize size, const Random& random) : size_(size) {
  Random angle = random.fork("view_angle");
  Random bulge = random.fork("distortion");
  k1_ = config.distortion.draw(bulge);
  focal_ = 0.5 * size.width / std::tan(0.5 * radians(config.view_angle.draw(angle)));
  centre_ = {0.5 * (size.width - 1), 0.5 * (size.height - 1)};

  // The rendered picture must hold the source of the whole border.
  rendered_focal_ = std::numeric_limits<double>::infinity();
  const auto hold = [this](double x, double y) {
    const Eigen::Vector3d ideal = ray({x, y});
    for (const int axis : {0, 1}) {
      const double reach = std::abs(ideal[axis]);
      if (reach > 0.0)
        rendered_focal_ = std::min(rendered_focal_, (centre_[axis] - kMargin) / reach);
    }
  };
  for (int x = 0; x < size.width; ++x) hold(x, 0.0);
  for (int y = 0; y < size.height; ++y) hold(0.0, y);
}

Eigen::Vector2d Lens::distort(const Eigen::Vector2d& ideal) const noexcept {
  const Eigen::Vector2d offset = ideal - centre_;
  return centre_ + offset * (1.0 + k1_ * offset.squaredNorm() / (focal_ * focal_));
}

Eigen::Vector2d Lens::project(const Eigen::Vector3d& point) const noexcept {
  return distort(centre_ + focal_ / point.z() * point.head<2>());
}

Eigen::Vector3d Lens::ray(const Eigen::Vector2d& pixel) const noexcept {
  const Eigen::Vector2d seen = (pixel - centre_) / focal_;
  const double target = seen.norm();
  double r = target;  // solves r (1 + k1 r^2) = target by Newton's steps
  for (int i = 0; i < 8; ++i) {
    r -= (r * (1.0 + k1_ * r * r) - target) / std::max(0.1, 1.0 + 3.0 * k1_ * r * r);
  }
  const double scale = target > 0.0 ? r / target : 1.0;
  return {seen.x() * scale, seen.y() * scale, 1.0};
}

double Lens::rendered_fovy() const noexcept {
  return 2.0 * std::atan(0.5 * size_.height / rendered_focal_) / radians(1.0);
}

Eigen::Vector2d Lens::source(const Eigen::Vector2d& pixel) const noexcept {
  return centre_ + rendered_focal_ * ray(pixel).head<2>();
}

}  // namespace pacer::sim
