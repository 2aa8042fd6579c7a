// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/frame.h"
#include "learning/exemplar/model.h"

namespace pacer {

/// A hierarchy as a picture: on top the actions, as its tree cuts them up, with the action models
/// of three groups (Figure 5.6 of the thesis); below, level by level, what each node has seen, its
/// exemplars' balloons on top of one another, and what it does about it, its actions as arrows
/// (Figures 5.7 and 5.8). What decides the action lies together; what does not is spread.
[[nodiscard]] Frame draw_hierarchy(const exemplar::Model& model);

}  // namespace pacer
