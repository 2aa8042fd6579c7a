// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "core/drive.h"
#include "learning/affordance/policy.h"
#include "sim/sim_car.h"
#include "studies/study.h"

namespace pacer {

/// Does `trial(index)` for each index below `count` in worker processes; what they return, in
/// order. It does not depend on how many workers there are. Throws StudyStopped.
[[nodiscard]] std::vector<nlohmann::json> run_trials(
    const StudyContext& context, std::uint32_t count, std::string_view what,
    const std::function<nlohmann::json(std::uint32_t index)>& trial);

/// `model` with another response; what was learnt stays.
[[nodiscard]] std::shared_ptr<const affordance::Model> responding(
    const affordance::Model& model, const affordance::ResponseConfig& response);

/// Counts the frames in which the car's own speed controller is told to drive: the pulse lies
/// above its dead zone.
class DrivenFrames final : public StepSink {
 public:
  /// `car` must outlive it.
  explicit DrivenFrames(const sim::SimCar& car) : car_(car) {}

  [[nodiscard]] bool write(const Frame&, const Step& step) override {
    count(step.pulses);
    return true;
  }
  void count(const Pulses& pulses) {
    const sim::Receiver& receiver = car_.world().car().speed_controller().receiver();
    ++frames_;
    if (receiver.decode(pulses.throttle) > 0.0) ++driven_;
  }

  [[nodiscard]] std::uint64_t frames() const noexcept { return frames_; }
  [[nodiscard]] std::uint64_t driven() const noexcept { return driven_; }

 private:
  const sim::SimCar& car_;
  std::uint64_t frames_ = 0;
  std::uint64_t driven_ = 0;
};

}  // namespace pacer
