// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <cstdint>
#include <vector>

#include "scenarios/scenario.h"

namespace pacer {

/// What moved a world at every step of a drive but the last, so that the very steps can be taken
/// again without the drivers who chose them.
class StepInputs {
 public:
  /// Of the episode that the teacher drives for Purpose::kCollect.
  [[nodiscard]] static StepInputs of_demonstration(const Scenario& scenario, std::uint32_t episode);

  /// How many steps they are for.
  [[nodiscard]] std::int64_t steps() const;
  /// Puts the inputs of `step` in place; what is left is one mj_step. Throws std::logic_error for a
  /// model with other bodies or motors than the drive's.
  void apply(const mjModel& model, std::int64_t step, mjData& data) const;
  /// Whether `data` is where the drive was after steps(), to the bit.
  [[nodiscard]] bool end_in(const mjModel& model, const mjData& data) const;

 private:
  static void see(const mjModel* model, mjData* data);  // MuJoCo's mjcb_control

  int motors_ = 0;
  int bodies_ = 0;
  std::vector<mjtNum> controls_;  // steps() rows of nu
  std::vector<mjtNum> forces_;    // steps() rows of 6 nbody
  std::vector<mjtNum> last_;      // qpos after all of them
  std::int64_t seen_ = 0;
};

}  // namespace pacer
