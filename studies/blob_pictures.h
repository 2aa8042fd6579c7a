// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/frame.h"
#include "learning/exemplar/percept.h"
#include "runs/report/picture.h"

namespace pacer {

/// Adds a row of Figure 5.10 to `tiles`: `frame` with `caption`, its blobs, its percept, as
/// `finder` has them.
void add_stages(const Frame& frame, const std::string& caption, exemplar::BalloonFinder& finder,
                std::vector<report::Tiled>& tiles);

}  // namespace pacer
