// SPDX-License-Identifier: Apache-2.0
#include "sim/sequences/head.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pacer::sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using std::numbers::pi;

const Vector3d kHalf(0.094, 0.074, 0.115);  // metres: of the skull
constexpr double kFullness = 0.78;          // below 1: boxier than an ellipsoid
constexpr double kCloser = 0.55;            // how much denser the face is in s than the back

/// The azimuth (0 ahead, to the left) at s, and back.
double azimuth(double s) {
  const double u = 2.0 * s - 1.0;
  return pi * (kCloser * u + (1.0 - kCloser) * u * u * u);
}
double s_of(double phi) {
  double u = phi / pi;
  for (int i = 0; i < 12; ++i) {
    u -= (kCloser * u + (1.0 - kCloser) * u * u * u - phi / pi) /
         (kCloser + 3.0 * (1.0 - kCloser) * u * u);
  }
  return 0.5 * (u + 1.0);
}

double bell(double x, double width) { return std::exp(-0.5 * x * x / (width * width)); }
/// 0 below `low`, 1 above `high`, smooth.
double rise(double x, double low, double high) {
  const double u = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return u * u * (3.0 - 2.0 * u);
}

/// What the cross-section at height z is, as shares of the skull's: how long and how wide.
Vector2d section(double t) {
  const double round = std::pow(std::max(std::sin(pi * t), 0.0), kFullness);
  const double z = kHalf.z() * std::cos(pi * t);
  const double jaw = 1.0 - 0.25 * rise(-z, 0.01, 0.105);
  return {round * (1.0 - 0.10 * rise(-z, 0.0, 0.1)), round * jaw};
}

/// How far the face stands out ahead of the smooth skull at (y, z).
double relief(double y, double z, Expression expression) {
  const double side = std::abs(y);
  double ahead = 0.0;
  // The nose: its bridge rises to the tip and ends below it at once.
  const double down = std::clamp((0.018 - z) / 0.046, 0.0, 1.0);
  const double length = rise(z, -0.037, -0.027) * (1.0 - rise(z, 0.014, 0.026));
  ahead += 0.027 * (0.25 + 0.75 * down) * length * bell(y, 0.0065 + 0.0035 * down);
  ahead += 0.007 * bell(side - 0.012, 0.006) * bell(z + 0.027, 0.007);   // its wings
  ahead -= 0.009 * bell(side - 0.032, 0.012) * bell(z - 0.013, 0.009);   // the eyes' sockets
  ahead += 0.003 * bell(side - 0.032, 0.009) * bell(z - 0.012, 0.006);   // the eyes in them
  ahead += 0.0045 * bell(side - 0.026, 0.022) * bell(z - 0.034, 0.008);  // the brow
  ahead += 0.004 * bell(side - 0.047, 0.013) * bell(z + 0.016, 0.014);   // the cheekbones
  ahead += 0.006 * bell(y, 0.019) * bell(z + 0.057, 0.006);              // the lips
  ahead += 0.006 * bell(y, 0.019) * bell(z + 0.070, 0.005);
  ahead -= 0.004 * bell(y, 0.022) * bell(z + 0.082, 0.005);
  ahead += 0.008 * bell(y, 0.020) * bell(z + 0.097, 0.010);  // the chin
  if (expression == Expression::kSmile) {
    ahead += 0.006 * bell(side - 0.042, 0.011) * bell(z + 0.030, 0.012);
    ahead -= 0.004 * bell(side - 0.031, 0.006) * bell(z + 0.055, 0.008);
  }
  if (expression == Expression::kTalk) ahead -= 0.010 * bell(y, 0.014) * bell(z + 0.066, 0.008);
  return ahead;
}

}  // namespace

double Head::hair_at(double s, double t, double edge) const {
  const double side = std::abs(azimuth(s));
  const double z = kHalf.z() * std::cos(pi * t);
  // Height at which the hair ends: over the forehead, down to the sides, into the neck.
  const double forehead = 0.062 + 0.005 * std::cos(5.0 * side);
  const double beside = look_.side_hairline;
  const double neck = std::min(-0.075, beside - 0.01);
  const double ends = forehead + (beside - forehead) * rise(side, 0.65, 1.15) +
                      (neck - beside) * rise(side, 1.45, 1.9);
  return rise(z - ends, -edge, edge);
}

Vector3d Head::at(double s, double t, Expression expression) const {
  const double phi = azimuth(s);
  const Vector2d shares = section(t);
  const double z = kHalf.z() * std::cos(pi * t);
  Vector3d point(kHalf.x() * shares.x() * std::cos(phi), kHalf.y() * shares.y() * std::sin(phi), z);
  point.x() += 0.022 * rise(-z, 0.02, 0.115);  // the jaw is ahead of the neck
  if (std::cos(phi) > 0.0) {
    point.x() += relief(point.y(), z, expression) * rise(std::cos(phi), 0.0, 0.4);
    if (expression == Expression::kTalk) point.z() -= 0.010 * rise(-z, 0.062, 0.085);
  }
  const Vector3d out(shares.x() * std::cos(phi), shares.y() * std::sin(phi), std::cos(pi * t));
  constexpr double kSlope = 0.02;  // metres over which hair rises from the skin
  return point + look_.hair_depth * hair_at(s, t, kSlope) * out.normalized();
}

Vector2d Head::on_picture(double y, double z) const {
  const double t = std::acos(std::clamp(z / kHalf.z(), -1.0, 1.0)) / pi;
  const double sine = std::clamp(y / (kHalf.y() * section(t).y()), -1.0, 1.0);
  return {s_of(std::asin(sine)), t};
}

std::vector<Vector3d> Head::outline() const {
  std::vector<Vector3d> points;
  for (int row = 0; row <= 24; ++row) {
    for (int column = 0; column < 32; ++column) {
      points.push_back(at(column / 32.0, row / 24.0, Expression::kNeutral));
    }
  }
  return points;
}

std::vector<Vector3d> Head::face_outline() const {
  std::vector<Vector3d> points;
  for (double phi = -1.2; phi <= 1.201; phi += 0.1) {
    for (double z = -0.108; z <= 0.0421; z += 0.01) {
      points.push_back(at(s_of(phi), std::acos(z / kHalf.z()) / pi, Expression::kNeutral));
    }
  }
  return points;
}

void Head::add_to(Shape& shape, Expression expression, const Skin& skin, const Skin& ear,
                  int columns, int rows) const {
  shape.surface(
      columns, rows, [&](double s, double t) { return at(s, t, expression); }, skin);
  for (const double side : {-1.0, 1.0}) {
    // An ear: a flat bowl that leans back, its rim ahead of its middle.
    const Vector3d middle(-0.012, side * 0.076, 0.0);
    shape.surface(
        10, 10,
        [&](double s, double t) -> Vector3d {
          const double around = 2.0 * pi * s;
          const double out = std::sin(pi * t);
          const Vector3d ball(0.017 * out * std::cos(around), 0.007 * out * std::sin(around),
                              0.031 * std::cos(pi * t));
          return middle +
                 Vector3d(ball.x() - 0.2 * ball.z(), ball.y() + side * 0.25 * -ball.x(), ball.z());
        },
        ear);
  }
}

}  // namespace pacer::sim
