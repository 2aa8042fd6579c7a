// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "core/command.h"
#include "core/frame.h"

namespace pacer {

/// A frame and what was done about it.
struct DemonstratedStep {
  const Frame* frame = nullptr;  ///< lives until the stream's next step; its `index` starts at 0
  Command command;               ///< what was sent, after limits
};

/// One demonstrated episode, read from its first step to its last.
class DemonstrationStream {
 public:
  virtual ~DemonstrationStream() = default;

  /// The next step; nullptr after the last. Lives until the next call.
  /// Throws std::runtime_error, naming the file, when the recording cannot be read.
  [[nodiscard]] virtual const DemonstratedStep* next() = 0;
};

/// How learning reads recorded episodes, without knowing how they are stored, and without any
/// column that the camera could not see.
class Demonstration {
 public:
  virtual ~Demonstration() = default;

  [[nodiscard]] virtual std::size_t episode_count() const = 0;
  [[nodiscard]] virtual double frame_rate_hz() const = 0;
  [[nodiscard]] virtual ImageSize image_size() const = 0;

  /// Identifies the recorded bytes; a model keeps it.
  [[nodiscard]] virtual std::string fingerprint() const = 0;

  /// Streams one episode. Streams of one demonstration may be read on several threads, one each.
  [[nodiscard]] virtual std::unique_ptr<DemonstrationStream> open(std::size_t episode) const = 0;
};

}  // namespace pacer
