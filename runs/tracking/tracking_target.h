// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/box.h"
#include "dataset/sequence.h"

namespace pacer {

/// One target of one sequence: what a tracker is run on.
struct TrackingTarget {
  std::string name;  ///< the sequence's, with ".1" and so on where it has several
  dataset::Sequence sequence;
  std::vector<std::optional<Box>> truth;  ///< one a picture from the first; empty: none
  std::size_t first = 0;                  ///< the picture that trackers start on
  Box box;                                ///< where it is there
};

/// The targets of `sequences`. With `box` each sequence has one target, which is there in the first
/// picture (its truth is kept where the sequence has one target); without, a target starts where
/// its truth does. Throws UsageError for a sequence in which nothing is annotated.
[[nodiscard]] std::vector<TrackingTarget> targets_of(
    const std::vector<dataset::Sequence>& sequences, const std::optional<Box>& box);

/// A box as OTB writes it, `x,y,width,height` in pixels, the top-left one being 1,1. Throws
/// std::invalid_argument, saying what is wrong with it.
[[nodiscard]] Box parse_box(const std::string& text);

}  // namespace pacer
