// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <string_view>

namespace pacer {

/// What every learner is told beside its settings.
struct TrainingOptions {
  int jobs = 1;          ///< threads; the model does not depend on it
  std::string scenario;  ///< the text that the model keeps
  std::stop_token stop;  ///< when requested, training ends with TrainingStopped
  /// Hears the stage and how much of it is done, 0 to 1. Calls come one at a time, from any thread.
  std::function<void(std::string_view stage, double share)> progress;
};

/// Training was asked to end before it had a model.
struct TrainingStopped : std::runtime_error {
  TrainingStopped() : std::runtime_error("training was stopped") {}
};

}  // namespace pacer
