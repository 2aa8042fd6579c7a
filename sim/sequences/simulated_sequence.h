// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/box.h"
#include "core/frame.h"

namespace pacer::sim {

/// A tracking sequence that is rendered instead of filmed, after one of the thesis's (Table 4.3),
/// at 25 frames a second and with exact truth.
struct SimulatedSequence {
  std::string name;   ///< e.g. "camera-shake"
  std::string about;  ///< one line: what happens in it
  ImageSize size;
  int frames = 0;
};

/// All of them, in the thesis's order.
[[nodiscard]] const std::vector<SimulatedSequence>& simulated_sequences();

/// Takes a frame and where the target is in it, hidden or not; false: no more, please.
using SequenceSink = std::function<bool(const Frame& frame, const Box& truth)>;

/// Renders `sequence`, one of simulated_sequences(), frame by frame into `sink`. `seed` draws how
/// things look (surfaces, prints, the room, the sensor's noise); what happens is the same for every
/// seed. The same seed gives the same bytes on one machine.
///
/// The truth is the upright box about the target's outline, projected as it stands when the shutter
/// is half-way. Makes an OpenGL context of its own.
/// Throws std::runtime_error when there is none to be had. Returns false when the sink ended it.
bool render_sequence(const SimulatedSequence& sequence, std::uint64_t seed,
                     const SequenceSink& sink);

}  // namespace pacer::sim
