// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>

#include "core/annotation.h"
#include "learning/tracking/medoidshift.h"
#include "learning/tracking/smat.h"
#include "learning/tracking/target_template.h"

namespace pacer::tracking {

/// Marks the reference point of a predictor, or with a radius its r_sp, as Figure 4.15 does.
void mark_predictor(const Eigen::Vector2d& at, double radius, Tone tone, Annotations& annotations);

/// Shows the medians of a model's components, by falling weight, as Figure 4.4 does.
void mark_aspects(const Smat& aspects, int matched, const TemplateGrid& grid,
                  Annotations& annotations);

/// Shows the modes of the largest clusters, and the one of the point `newest`. `templates` has the
/// points' templates in their order.
void mark_aspects(const Medoidshift& clusters, std::size_t newest, const TemplateGrid& grid,
                  std::span<const std::uint8_t> templates, Annotations& annotations);

}  // namespace pacer::tracking
