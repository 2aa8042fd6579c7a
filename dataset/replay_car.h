// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/car.h"
#include "dataset/reader.h"

namespace pacer::dataset {

/// A recorded episode driven again: its frames in order, whatever is sent. Its signal columns are
/// the recorded ones.
class ReplayCar final : public Car {
 public:
  /// The dataset must live as long as the car. Throws like EpisodeReader.
  ReplayCar(const Dataset& dataset, std::size_t episode);

  /// Throws std::runtime_error, naming the file, when the recording cannot be read.
  [[nodiscard]] const Frame* look() override;
  void send(const Pulses&) override {}  // the past cannot be steered
  [[nodiscard]] std::span<const SignalColumn> signal_columns() const override { return columns_; }
  [[nodiscard]] SignalValues signals() const override { return values_; }

 private:
  std::vector<SignalColumn> columns_;
  EpisodeReader reader_;
  std::vector<float> values_;
};

}  // namespace pacer::dataset
