// SPDX-License-Identifier: Apache-2.0
// Private to the module: what the lines of a sequence's annotation mean.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "core/box.h"
#include "dataset/sequence.h"

namespace pacer::dataset {

/// No sequence has more pictures: nine hours at 30 Hz.
inline constexpr std::size_t kMostPictures = 1'000'000;

/// The boxes of an annotation's text, one a line. What a line holds depends on the layout:
///
/// - OTB, GOT-10k: x,y,width,height, where the top-left pixel is (1, 1).
/// - TLD: x1,y1,x2,y2, the first and the last pixel of the target, likewise from (1, 1).
/// - VOT: x,y,width,height, where the top-left pixel is (0, 0): VOT's own rasteriser paints the
///   pixels x to x + width - 1 of an array that counts from 0. Or a polygon x1,y1,x2,y2,..., of
///   which the upright bounding box is taken; its corners are centres of pixels that belong to the
///   target, as the rasteriser has it. Or a mask "mx,y,width,height,runs...": runs of pixels off
///   and on in turn, row by row within that window; again the bounding box. Or 0: not annotated.
///
/// There is no box where a number is NaN, a side is zero or less (GOT-10k writes -1), or a mask or
/// polygon has no area. `file` is for the errors: std::runtime_error with the file and the line.
[[nodiscard]] std::vector<std::optional<Box>> parse_boxes(std::string_view text,
                                                          SequenceLayout layout,
                                                          std::string_view file);

/// GOT-10k's absence.label: a line is 1 where the target is absent, else 0. Fails likewise.
[[nodiscard]] std::vector<bool> parse_absence(std::string_view text, std::string_view file);

}  // namespace pacer::dataset
