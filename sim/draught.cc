// SPDX-License-Identifier: Apache-2.0
#include "sim/draught.h"

#include <cmath>
#include <numbers>

namespace pacer::sim {

Draught::Draught(const mjModel& model, double force, const Random& random) {
  for (const char* const name : {"red_balloon", "green_balloon"}) {
    const int body = mj_name2id(&model, mjOBJ_BODY, name);
    if (body < 0) continue;
    Random draw = random.fork(name);
    for (const int axis : {0, 1}) {
      Push push{.body = body, .axis = axis, .force = {}, .frequency = {}, .phase = {}};
      for (std::size_t wave = 0; wave < 2; ++wave) {
        push.force.at(wave) = 0.5 * force * draw.uniform(0.3, 1.0);
        push.frequency.at(wave) = draw.uniform(0.5, 2.0);
        push.phase.at(wave) = draw.uniform(0.0, 2.0 * std::numbers::pi);
      }
      pushes_.push_back(push);
    }
  }
}

void Draught::blow(mjData& data) const noexcept {
  for (const Push& push : pushes_) {
    double force = 0.0;
    for (std::size_t wave = 0; wave < 2; ++wave) {
      force += push.force[wave] * std::sin(push.frequency[wave] * data.time + push.phase[wave]);
    }
    data.xfrc_applied[6 * push.body + push.axis] = force;
  }
}

}  // namespace pacer::sim
