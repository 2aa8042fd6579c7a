// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>

#include "learning/tracking/tracker.h"

namespace pacer::tracking {

/// The thesis's seventh tracker, Semi-Online-Boost (Grabner, Leistner and Bischof, "Semi-Supervised
/// On-Line Boosting for Robust Tracking", ECCV 2008). The first picture alone is labelled: it
/// trains a prior classifier, which stays as it is, and starts an on-line one, which learns from
/// every later picture what the prior lets it. The on-line classifier is sought in twice the
/// target's size; where it says no everywhere the target is lost, nothing is learnt, and the next
/// picture is searched whole.
///
/// It follows position, not size, of the part of the box that lies in the first picture; that part
/// stays in the picture. A target of a single pixel, and one that leaves no background, is lost
/// from the start. The confidence is the on-line classifier's margin.
[[nodiscard]] std::unique_ptr<Tracker> make_semi_online_boost(std::uint64_t seed);

}  // namespace pacer::tracking
