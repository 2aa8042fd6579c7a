// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <opencv2/core.hpp>
#include <string>

#include "core/random.h"

/// Surfaces made in code, seeded: rich in detail at several scales, and nothing to download.
///
/// A picture is 8-bit RGB, top row first. A colour is RGB in [0, 255]. "Seamless" pictures repeat
/// without a visible edge. The same arguments give the same bytes.
namespace pacer::sim::texture {

using Colour = cv::Scalar;

/// `colour` a little lighter (amount > 0, 1: white) or darker (amount < 0, -1: black).
[[nodiscard]] Colour shade(const Colour& colour, double amount);
/// `colour` with each channel moved by a normal of this deviation: no two planks are alike.
[[nodiscard]] Colour vary(const Colour& colour, double deviation, Random& random);

/// A colour of this hue (degrees), saturation and value in [0, 1].
[[nodiscard]] Colour hsv(double hue, double saturation, double value);

/// Smooth seamless noise in about [-1, 1], CV_32F, with cells_x x cells_y features.
[[nodiscard]] cv::Mat noise(cv::Size size, int cells_x, int cells_y, Random& random);
/// Brightens and darkens `picture` by `amount` (of 255) where `field` is 1 and -1.
void modulate(cv::Mat& picture, const cv::Mat& field, double amount);

[[nodiscard]] cv::Mat plain(cv::Size size, const Colour& colour, double grain, Random random);
/// Grain along the picture's width, with knots.
[[nodiscard]] cv::Mat wood(cv::Size size, const Colour& colour, Random random);
/// Staggered planks along the width; seamless.
[[nodiscard]] cv::Mat parquet(cv::Size size, const Colour& colour, int rows, Random random);
/// Loops and a scattered motif; seamless.
[[nodiscard]] cv::Mat carpet(cv::Size size, const Colour& colour, const Colour& accent,
                             Random random);
/// A whole rug with borders and medallions.
[[nodiscard]] cv::Mat rug(cv::Size size, const Colour& colour, const Colour& accent, Random random);
/// `count` x `count` square tiles, worn; seamless.
[[nodiscard]] cv::Mat tiles(cv::Size size, const Colour& colour, const Colour& grout, int count,
                            Random random);
/// Cast concrete with stains, cracks and joints; seamless.
[[nodiscard]] cv::Mat concrete(cv::Size size, const Colour& colour, Random random);
/// One of several patterns; seamless.
[[nodiscard]] cv::Mat wallpaper(cv::Size size, const Colour& colour, const Colour& accent,
                                Random random);
[[nodiscard]] cv::Mat brick(cv::Size size, const Colour& colour, const Colour& mortar,
                            Random random);
/// Rough plaster with the marks of the trowel; seamless.
[[nodiscard]] cv::Mat plaster(cv::Size size, const Colour& colour, Random random);
/// Woven, plain, striped or checked; seamless.
[[nodiscard]] cv::Mat fabric(cv::Size size, const Colour& colour, const Colour& accent,
                             Random random);
/// Painted or brushed metal with scratches.
[[nodiscard]] cv::Mat metal(cv::Size size, const Colour& colour, Random random);

/// Adds `picture` to the model as a 2d texture and a material, both named `name`.
/// `repeat`: times a metre that the picture repeats on a plane; 0: once over the whole.
mjsMaterial& add_material(mjSpec& spec, const std::string& name, const cv::Mat& picture,
                          double repeat_x = 0.0, double repeat_y = 0.0);

}  // namespace pacer::sim::texture
