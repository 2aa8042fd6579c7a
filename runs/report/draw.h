// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "core/annotation.h"
#include "core/command.h"
#include "core/frame.h"

namespace pacer::report {

/// What the strip above a video's picture tells about one step.
struct Hud {
  Command sent;                         ///< after the limits: the bars
  std::optional<Command> wanted = {};   ///< what the policy asked for: a white tick
  std::optional<Command> teacher = {};  ///< what the teacher would have done: a green triangle
  std::string caption = {};             ///< e.g. "learned, episode 3, 12.4 s"
};

/// Draws `annotations` over `frame`, magnified `scale` (1 to 8) times, into `into`, whose memory is
/// kept. Every mark has a dark rim, so that it reads on any background; tones are colours: white
/// (neutral), green (matched), orange (target), grey (ignored). Patches stand in a row along its
/// bottom. Marks that are not finite or far outside are left out. Throws std::invalid_argument for
/// a frame whose bytes do not fit its size.
void draw(const Frame& frame, const Annotations& annotations, Frame& into, int scale = 2);

/// The same with a strip above it, clear of a player's controls, that shows steering (left is left)
/// and throttle. Width and height come out even, as video encoders ask.
void draw(const Frame& frame, const Annotations& annotations, const Hud& hud, Frame& into,
          int scale = 2);

/// Size of a picture with a strip: what a video of frames of `size` is opened with.
[[nodiscard]] ImageSize drawn_size(ImageSize size, int scale = 2);

}  // namespace pacer::report
