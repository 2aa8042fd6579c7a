// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <cstdint>

#include "core/random.h"
#include "core/range.h"

namespace pacer::sim {

/// How the lead vehicle looks. A scenario has one lead: the same in every episode, taught or
/// driven.
struct LiveryConfig {
  std::uint64_t design = 1;     ///< which livery is drawn from the ranges; one number, one livery
  Range hue{0.0, 360.0};        ///< of the paint, degrees
  Range element{0.013, 0.018};  ///< metres: the small printed things, and with them how far away
                                ///< they can be told apart
  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("design", design);
    visit("hue_deg", hue);
    visit("element_m", element);
  }
};

/// The lead vehicle's shell, metres in its chassis's frame (x ahead, y left, z up, origin on the
/// floor midway between the axles): a van, longer and taller than the chassis that it hides.
struct LeadShell {
  double rear = -0.205, front = 0.21;   ///< x
  double half_width = 0.095;            ///< y
  double bottom = 0.045, roof = 0.168;  ///< z
};

/// Puts the body shell of a delivery van on `chassis`, printed all over, and different from every
/// side. It adds no mass and touches nothing. Names begin with `lead_`; once a model.
void dress_lead(mjSpec& spec, mjsBody& chassis, const Random& random,
                const LiveryConfig& config = {});

}  // namespace pacer::sim
