// SPDX-License-Identifier: Apache-2.0
#include "sim/sequences/simulated_sequence.h"

#include <algorithm>
#include <array>

#include "core/check.h"
#include "core/random.h"
#include "sim/sequences/scenes.h"

namespace pacer::sim {
namespace {

constexpr Seconds kFramePeriod{0.04};

struct Entry {
  SimulatedSequence sequence;
  Scene (*scene)(const Random&);
};

const std::vector<Entry>& entries() {
  static const std::vector<Entry> all = {
      {{.name = "car-surveillance",
        .about = "a car turns into a yard and out of it, below a fixed camera; clouds pass",
        .size = {320, 240},
        .frames = 282},
       car_surveillance},
      {{.name = "face-hand",
        .about = "a face; a hand passes over it from 203 to 223, glasses come off at 364, light",
        .size = {640, 480},
        .frames = 1000},
       face_hand},
      {{.name = "runner",
        .about = "an athlete runs out of the bend and down the straight; camera pans and zooms",
        .size = {320, 240},
        .frames = 420},
       runner},
      {{.name = "head-motion",
        .about = "a head turns, nods and tilts; from 300 on a mug hides it for 100 frames",
        .size = {320, 240},
        .frames = 600},
       head_motion},
      {{.name = "camera-shake",
        .about =
            "a telephone's keys through a camera that is shaken from 280 on; blur, 37 px jumps",
        .size = {320, 240},
        .frames = 500},
       camera_shake},
  };
  return all;
}

}  // namespace

const std::vector<SimulatedSequence>& simulated_sequences() {
  static const std::vector<SimulatedSequence> all = [] {
    std::vector<SimulatedSequence> sequences;
    for (const Entry& entry : entries()) sequences.push_back(entry.sequence);
    return sequences;
  }();
  return all;
}

bool render_sequence(const SimulatedSequence& sequence, std::uint64_t seed,
                     const SequenceSink& sink) {
  const auto entry = std::ranges::find_if(
      entries(), [&sequence](const Entry& one) { return one.sequence.name == sequence.name; });
  check(entry != entries().end(), "what is rendered is one of simulated_sequences()");
  const Random random = Random(seed).fork(sequence.name);
  Stage stage(entry->scene(random), sequence.size, random);
  Frame frame;
  for (int i = 0; i < sequence.frames; ++i) {
    stage.expose(i, frame);
    frame.index = static_cast<std::uint64_t>(i);
    frame.time = kFramePeriod * i;
    if (!sink(frame, stage.truth())) return false;
  }
  return true;
}

}  // namespace pacer::sim
