// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/response_peak.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

namespace pacer::tracking {
namespace {

constexpr int kSteps = 2;
constexpr double kLongest = 0.5;  // step, cells
constexpr std::size_t kHalf = kGrid / 2;
constexpr double kUnit = 2.0 * std::numbers::pi / static_cast<double>(kGrid);

/// A response at a point, with its first and second derivatives, a cell the unit.
struct Expansion {
  double value = 0.0;
  double x = 0.0, y = 0.0;
  double xx = 0.0, xy = 0.0, yy = 0.0;
};

double signed_index(std::size_t index) {
  const auto shift = static_cast<double>(index);
  return index < kHalf ? shift : shift - static_cast<double>(kGrid);
}

/// exp(i kUnit n at) for n = 0 to kHalf - 1, split into real and imaginary parts.
struct Phases {
  std::array<float, kHalf> re, im;
};
Phases phases(double at) {
  Phases of;
  const std::complex<double> turn = std::polar(1.0, kUnit * at);
  std::complex<double> phase = 1.0;
  for (std::size_t n = 0; n < kHalf; ++n, phase *= turn) {
    of.re[n] = static_cast<float>(phase.real());
    of.im[n] = static_cast<float>(phase.imag());
  }
  return of;
}

/// Sums over half the columns, since the response is real; the highest frequency, which has no
/// phase, is left out in both directions.
Expansion expand(const Plane& spectrum, double x, double y) {
  const Phases across = phases(x);
  const Phases down = phases(y);
  using Columns = std::array<float, kHalf>;
  Columns re{}, im{}, down_re{}, down_im{}, down_twice{};
  for (std::size_t r = 0; r < kGrid; ++r) {
    if (r == kHalf) continue;
    const auto k = static_cast<float>(signed_index(r));
    const std::size_t n = r < kHalf ? r : kGrid - r;
    const float row_re = down.re[n];
    const float row_im = r < kHalf ? down.im[n] : -down.im[n];
    for (std::size_t c = 0; c < kHalf; ++c) {
      const std::complex<float> value = spectrum[r * kGrid + c];
      const float turn_re = row_re * across.re[c] - row_im * across.im[c];
      const float turn_im = row_re * across.im[c] + row_im * across.re[c];
      const float part_re = value.real() * turn_re - value.imag() * turn_im;
      const float part_im = value.real() * turn_im + value.imag() * turn_re;
      re[c] += part_re;
      im[c] += part_im;
      down_re[c] += k * part_re;
      down_im[c] += k * part_im;
      down_twice[c] += k * k * part_re;
    }
  }
  Expansion sums;
  for (std::size_t c = 0; c < kHalf; ++c) {
    const double weight = (c == 0 ? 1.0 : 2.0) / static_cast<double>(kGrid * kGrid);
    const double l = static_cast<double>(c);
    sums.value += weight * static_cast<double>(re[c]);
    sums.x -= weight * kUnit * l * static_cast<double>(im[c]);
    sums.y -= weight * kUnit * static_cast<double>(down_im[c]);
    sums.xx -= weight * kUnit * kUnit * l * l * static_cast<double>(re[c]);
    sums.xy -= weight * kUnit * kUnit * l * static_cast<double>(down_re[c]);
    sums.yy -= weight * kUnit * kUnit * static_cast<double>(down_twice[c]);
  }
  return sums;
}

}  // namespace

Peak peak_of(const Plane& spectrum) {
  Plane plane = spectrum;
  RealPlane response;
  transform_back(plane, response);
  const auto best = static_cast<std::size_t>(std::ranges::max_element(response) - response.begin());
  Peak peak{.x = signed_index(best % kGrid), .y = signed_index(best / kGrid)};
  Expansion at = expand(spectrum, peak.x, peak.y);
  for (int step = 0; step < kSteps; ++step) {
    const double determinant = at.xx * at.yy - at.xy * at.xy;
    if (at.xx >= 0.0 || determinant <= 0.0) break;  // no top here
    const double x =
        peak.x + std::clamp((at.xy * at.y - at.yy * at.x) / determinant, -kLongest, kLongest);
    const double y =
        peak.y + std::clamp((at.xy * at.x - at.xx * at.y) / determinant, -kLongest, kLongest);
    const Expansion there = expand(spectrum, x, y);
    if (there.value < at.value) break;
    at = there;
    peak.x = x;
    peak.y = y;
  }
  peak.value = at.value;
  return peak;
}

double value_in_the_middle(const Plane& spectrum) { return expand(spectrum, 0.0, 0.0).value; }

}  // namespace pacer::tracking
