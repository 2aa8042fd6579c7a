// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/command.h"
#include "core/demonstration.h"
#include "core/frame.h"
#include "core/training.h"
#include "learning/byte_stream.h"

namespace pacer::baselines {

/// What every baseline's model keeps of the demonstration that it was learnt from.
struct Origin {
  ImageSize image_size;        ///< frames of another size are refused
  double frame_rate_hz = 0.0;  ///< of the demonstration
  std::string scenario;        ///< that it was recorded in, as text
  std::string fingerprint;     ///< of it
  Command mean;                ///< of its commands

  [[nodiscard]] static Origin of(const Demonstration& demonstration, const std::string& scenario);

  void write(ByteWriter& out) const;
  /// Throws std::runtime_error where it makes no sense.
  [[nodiscard]] static Origin read(ByteReader& in);

  /// Throws std::runtime_error, saying what to do, for a frame of another size.
  void require_size(const Frame& frame) const;
};

}  // namespace pacer::baselines
