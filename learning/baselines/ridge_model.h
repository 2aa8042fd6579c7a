// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "core/policy_model.h"
#include "core/training.h"
#include "learning/baselines/origin.h"
#include "learning/baselines/picture_features.h"
#include "learning/baselines/ridge.h"
#include "learning/baselines/training_report.h"
#include "learning/sealed_file.h"

namespace pacer::baselines {

/// Ridge regression from a small grey picture, or histograms of its gradients, to the command.
struct RidgeModel {
  Origin origin;
  FeatureChoice features;
  double ridge = 0.0;  ///< see RegressionSums::fit
  LinearAction action;

  static constexpr std::uint32_t kVersion = 1;
  static constexpr SealedKind kFile{"PACERRDG", kVersion, "a ridge model"};
};

[[nodiscard]] std::string to_bytes(const RidgeModel& model);
/// Reads what to_bytes() wrote; `bytes` are not trusted. Throws as unsealed().
[[nodiscard]] RidgeModel ridge_from_bytes(std::string_view bytes, std::string_view source);

/// Always answers: it has no notion of a target, so none can be lost.
class RidgePolicy final : public Policy {
 public:
  explicit RidgePolicy(std::shared_ptr<const RidgeModel> model);

  /// Throws std::runtime_error when the frame's size is not the demonstration's.
  [[nodiscard]] Command act(const Observation& observation, Annotations& annotations) override;

 private:
  std::shared_ptr<const RidgeModel> model_;
  PictureFeatures features_;
};

class RidgePolicyModel final : public PolicyModelOf<RidgeModel> {
 public:
  using PolicyModelOf::PolicyModelOf;
  [[nodiscard]] std::string_view method() const override;
  [[nodiscard]] std::unique_ptr<Policy> make(const Random& random,
                                             std::unique_ptr<TargetPointer>) const override;
  [[nodiscard]] Command mean_command() const override { return model()->origin.mean; }
  [[nodiscard]] std::optional<double> frame_rate_hz() const override { return std::nullopt; }
};

/// Learns one, with the size of the picture and the ridge that predict held-out folds best
/// (docs/design/baselines.md). Reads the demonstration once. The same demonstration and kind: the
/// same model. Throws as Folds::read().
[[nodiscard]] RidgeModel train_ridge(const Demonstration& demonstration, PictureKind kind,
                                     const TrainingOptions& options, TrainingReport& report);

}  // namespace pacer::baselines
