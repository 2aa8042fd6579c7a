// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <array>
#include <string>

#include "core/random.h"
#include "sim/livery.h"

namespace pacer::sim {

/// What a figure takes up that stands in the lead vehicle's place, in its chassis's frame.
constexpr LeadShell kPersonOutline{
    .rear = -0.065, .front = 0.055, .half_width = 0.062, .bottom = 0.0, .roof = 0.30};

/// Puts a walking figure (models/person.xml) on `chassis`, which carries it and is no longer drawn.
/// Its clothes are printed all over, and differ from side to side; colours and the size of what is
/// printed are drawn from `config`, as a lead vehicle's livery is. All its names begin with
/// `prefix`; once a model.
void add_person(mjSpec& spec, mjsBody& chassis, const std::string& prefix, const Random& random,
                const LiveryConfig& config);

/// Moves the legs and arms of a figure that add_person put into a model, as fast as it goes.
class Gait {
 public:
  /// Finds the joints in `model`, which must outlive it.
  Gait(const mjModel& model, const std::string& prefix);

  /// Sets the controls for one time step: once before each mj_step or mj_step2. `speed` along the
  /// figure's axis, m/s.
  void step(mjData& data, double speed) noexcept;

 private:
  struct Side {
    int hip, knee, shoulder;  // actuators
    double ahead;             // turns of the stride that it is ahead of the left side
  };
  double time_step_;
  std::array<Side, 2> sides_;
  double phase_ = 0.0;  // of the stride, in turns
  double reach_ = 0.0;  // of the stride, 0 standing to 1
};

}  // namespace pacer::sim
