// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "learning/tracking/tracker.h"

namespace pacer::tracking {

/// Trackers that people use today, from their libraries and with their default parameters, for
/// comparison only: OpenCV's Boosting (Grabner's Online-Boost), MIL, KCF, CSRT, MOSSE, MedianFlow
/// and TLD, dlib's correlation tracker, ViSP's Lucas-Kanade. Those are listed whose library was
/// there when this one was built.
///
/// A peer is given the whole pixels of the box that lie in the picture. Where they are too few for
/// it, and once its library has failed, it is lost until it is started again. What it reports is
/// found or lost: a confidence of 1 or 0.
///
/// Every seed gives the same tracks: OpenCV's draw from generators of the whole process, which are
/// lent to them as they are when a program starts. Run OpenCV's on one thread at a time.
[[nodiscard]] const std::vector<TrackerKind>& peers();

}  // namespace pacer::tracking
