// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/policy_model.h"
#include "core/training.h"
#include "learning/baselines/nearest.h"
#include "learning/baselines/origin.h"
#include "learning/baselines/small_picture.h"
#include "learning/baselines/training_report.h"
#include "learning/sealed_file.h"

namespace pacer::baselines {

/// Does what was done in the demonstrated frames that look most like this one: the mean of the
/// commands of the k nearest.
struct NearestModel {
  Origin origin;
  ImageSize size;  ///< of the small pictures
  int neighbours = 1;
  PictureTable pictures;
  std::vector<Command> commands;  ///< one a picture

  static constexpr std::uint32_t kVersion = 1;
  static constexpr SealedKind kFile{"PACERNNB", kVersion, "a nearest-neighbour model"};
};

[[nodiscard]] std::string to_bytes(const NearestModel& model);
/// Reads what to_bytes() wrote; `bytes` are not trusted. Throws as unsealed().
[[nodiscard]] NearestModel nearest_from_bytes(std::string_view bytes, std::string_view source);

/// Always answers: it has no notion of a target, so none can be lost.
class NearestPolicy final : public Policy {
 public:
  explicit NearestPolicy(std::shared_ptr<const NearestModel> model);

  /// Looks through all pictures; allocates nothing. Throws std::runtime_error when the frame's size
  /// is not the demonstration's.
  [[nodiscard]] Command act(const Observation& observation, Annotations& annotations) override;

 private:
  std::shared_ptr<const NearestModel> model_;
  SmallPicture small_;
  std::vector<std::int8_t> seen_;
  Nearest nearest_;
};

class NearestPolicyModel final : public PolicyModelOf<NearestModel> {
 public:
  using PolicyModelOf::PolicyModelOf;
  [[nodiscard]] std::string_view method() const override { return "nearest"; }
  [[nodiscard]] std::unique_ptr<Policy> make(const Random& random,
                                             std::unique_ptr<TargetPointer>) const override;
  [[nodiscard]] Command mean_command() const override { return model()->origin.mean; }
  [[nodiscard]] std::optional<double> frame_rate_hz() const override { return std::nullopt; }
};

/// Learns one, with the size of the pictures and the number of neighbours that predict held-out
/// folds best (docs/design/baselines.md). Chooses from, and keeps, `most_pictures` frames at most,
/// evenly thinned. The same demonstration: the same model. Throws as Folds::read().
[[nodiscard]] NearestModel train_nearest(const Demonstration& demonstration,
                                         const TrainingOptions& options, TrainingReport& report,
                                         std::size_t most_pictures = 20000);

}  // namespace pacer::baselines
