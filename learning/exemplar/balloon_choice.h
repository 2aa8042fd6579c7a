// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "core/frame.h"
#include "learning/exemplar/balloon_config.h"
#include "learning/exemplar/balloon_regions.h"

namespace pacer::exemplar {

/// The largest that looks like a balloon of those called `name`, with the parts that belong to it,
/// in a picture of `size`. `other` is the other balloon, which may hide some of it. Uses
/// Region::taken.
[[nodiscard]] std::optional<Blob> choose_balloon(std::span<Region> regions, Name name,
                                                 ImageSize size, const std::optional<Blob>& other,
                                                 const BalloonConfig& config);

}  // namespace pacer::exemplar
