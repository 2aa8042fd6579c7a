// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "core/annotation.h"
#include "learning/tracking/flock.h"
#include "learning/tracking/smat.h"
#include "learning/tracking/target_template.h"

namespace pacer::tracking {

/// Marks the reference point of a member of the flock at `origin`.
void mark(const FlockMember& member, const Eigen::Vector2d& origin, Tone tone,
          Annotations& annotations);

/// Marks the disc from which a member's support is drawn, as Figure 4.15 does.
void mark_range(const FlockMember& member, const Eigen::Vector2d& origin, double support_range,
                Tone tone, Annotations& annotations);

/// Shows the medians of a model's components, by falling weight, as Figure 4.4 does.
void mark_aspects(const Smat& aspects, int matched, const TemplateGrid& grid,
                  Annotations& annotations);

}  // namespace pacer::tracking
