// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "core/marking.h"
#include "core/policy_model.h"
#include "core/random.h"
#include "core/training.h"
#include "learning/baselines/box_response.h"
#include "learning/baselines/detector.h"
#include "learning/baselines/origin.h"
#include "learning/baselines/training_report.h"
#include "learning/sealed_file.h"

namespace pacer::baselines {

/// The supervised baseline (6.2): a detector that was shown the target's boxes, and one linear map
/// from what it detects to the command.
struct SupervisedModel {
  Origin origin;
  WaldBoost detector;
  BoxDriving driving;

  static constexpr std::uint32_t kVersion = 2;
  static constexpr SealedKind kFile{"PACERSUP", kVersion, "a supervised model"};
};

[[nodiscard]] std::string to_bytes(const SupervisedModel& model);
/// Reads what to_bytes() wrote; `bytes` are not trusted. Throws as unsealed().
[[nodiscard]] SupervisedModel supervised_from_bytes(std::string_view bytes,
                                                    std::string_view source);

/// Drives by the surest detection in each frame, on its own.
class SupervisedPolicy final : public Policy {
 public:
  explicit SupervisedPolicy(std::shared_ptr<const SupervisedModel> model);

  /// Throws std::runtime_error when the frame's size is not the demonstration's. Marks the box.
  [[nodiscard]] Command act(const Observation& observation, Annotations& annotations) override;

 private:
  std::shared_ptr<const SupervisedModel> model_;
  Detector detector_;
  BoxResponse response_;
};

class SupervisedPolicyModel final : public PolicyModelOf<SupervisedModel> {
 public:
  using PolicyModelOf::PolicyModelOf;
  [[nodiscard]] std::string_view method() const override { return "supervised"; }
  [[nodiscard]] std::unique_ptr<Policy> make(const Random& random,
                                             std::unique_ptr<TargetPointer>) const override;
  [[nodiscard]] Command mean_command() const override { return model()->origin.mean; }
  [[nodiscard]] std::optional<double> frame_rate_hz() const override { return std::nullopt; }
  [[nodiscard]] GivenBoxes given_boxes() const override { return GivenBoxes::kInTraining; }
};

/// Learns one (docs/design/baselines.md). Reads the demonstration twice: for the detector, and for
/// what it detects. The same demonstration and random: the same model. A stop is heeded, but not
/// while OpenCV trains the detector. Throws as read_marked() and train_detector(), and UsageError
/// where the detector finds nothing.
[[nodiscard]] SupervisedModel train_supervised(const MarkedDemonstration& demonstration,
                                               const LossConfig& when_lost, const Random& random,
                                               const TrainingOptions& options,
                                               TrainingReport& report);

}  // namespace pacer::baselines
