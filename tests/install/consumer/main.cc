// SPDX-License-Identifier: Apache-2.0
#include <iostream>

#include "core/channels.h"
#include "learning/affordance/train.h"
#include "scenarios/scenario.h"

int main(int, char** argv) {
  const pacer::Scenario scenario = pacer::load_scenario(argv[1]);
  const pacer::Pulses pulses = scenario.channels.encode({.steering = 0.0, .throttle = 0.0});
  std::cout << scenario.name << ": straight on is " << pacer::microseconds(pulses.steering)
            << " us, " << scenario.affordance.actions.types << " action types\n";
}
