// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "core/random.h"
#include "sim/texture.h"

/// Printed, painted and lit things made in code, seeded; conventions as in sim/texture.h.
namespace pacer::sim::print {

using texture::Colour;

/// A bright colour of any hue.
[[nodiscard]] Colour bright(Random& random);
/// A made-up word in capitals.
[[nodiscard]] std::string word(Random& random);
/// `text`, as large as fits `box`.
void write(cv::Mat& picture, const std::string& text, const cv::Rect& box, const Colour& ink);

/// A framed painting: a landscape, a still life of shapes, or strokes.
[[nodiscard]] cv::Mat painting(cv::Size size, Random random);
/// A poster with a title, a figure and small print.
[[nodiscard]] cv::Mat poster(cv::Size size, Random random);
/// A row of books on a shelf, spines out.
[[nodiscard]] cv::Mat books(cv::Size size, Random random);
/// A row of ring binders with labels.
[[nodiscard]] cv::Mat binders(cv::Size size, Random random);
/// A cardboard box's side: tape, a printed brand, a bar code.
[[nodiscard]] cv::Mat carton(cv::Size size, Random random);
/// A box, tin or toy in colours: a product's front.
[[nodiscard]] cv::Mat product(cv::Size size, Random random);
/// A desktop with windows, text and a chart.
[[nodiscard]] cv::Mat screen(cv::Size size, Random random);
[[nodiscard]] cv::Mat keyboard(cv::Size size, Random random);
/// Diagrams, notes and sticky squares on white.
[[nodiscard]] cv::Mat whiteboard(cv::Size size, Random random);
/// Tools on a perforated board.
[[nodiscard]] cv::Mat pegboard(cv::Size size, const Colour& colour, Random random);
/// What a window shows: frame, sky, houses, trees.
[[nodiscard]] cv::Mat window(cv::Size size, Random random);
/// A panelled door with its handle.
[[nodiscard]] cv::Mat door(cv::Size size, const Colour& colour, Random random);
/// The front of a chest of drawers or cupboard.
[[nodiscard]] cv::Mat drawers(cv::Size size, const Colour& colour, int columns, int rows,
                              Random random);
/// Open shelves with things on them; `full` in [0, 1].
[[nodiscard]] cv::Mat shelf(cv::Size size, const Colour& colour, double full, Random random);
/// Leaves, dense.
[[nodiscard]] cv::Mat leaves(cv::Size size, Random random);

}  // namespace pacer::sim::print
