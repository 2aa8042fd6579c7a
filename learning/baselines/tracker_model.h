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
#include "learning/baselines/origin.h"
#include "learning/baselines/training_report.h"
#include "learning/sealed_file.h"
#include "learning/tracking/tracker.h"

namespace pacer::baselines {

/// A tracker, started on the target in the first frame in which it is seen, and one linear map from
/// where it says that the target is to the command.
struct TrackerModel {
  Origin origin;
  std::string tracker;  ///< that the map is fitted to, one of tracking::trackers()
  BoxDriving driving;

  static constexpr std::uint32_t kVersion = 2;
  static constexpr SealedKind kFile{"PACERTRK", kVersion, "a tracker model"};
};

[[nodiscard]] std::string to_bytes(const TrackerModel& model);
/// Reads what to_bytes() wrote; `bytes` are not trusted. Throws as unsealed().
[[nodiscard]] TrackerModel tracker_from_bytes(std::string_view bytes, std::string_view source);

/// Follows one target through frames.
class FrameTracker {
 public:
  /// By the tracker of that `name`, one of tracking::trackers().
  FrameTracker(std::string_view name, const Random& random);

  void start(const Frame& frame, const Box& target);
  /// Where the target is; nothing while the tracker says that it is lost.
  [[nodiscard]] std::optional<Box> update(const Frame& frame);

 private:
  const tracking::Picture& picture_of(const Frame& frame);

  std::unique_ptr<tracking::Tracker> tracker_;
  tracking::Picture picture_;
};

/// Waits for its target to be pointed at, and answers until then as if it had lost it.
class TrackerPolicy final : public Policy {
 public:
  /// `pointer` is not null.
  TrackerPolicy(std::shared_ptr<const TrackerModel> model, const Random& random,
                std::unique_ptr<TargetPointer> pointer);

  /// Throws std::runtime_error when the frame's size is not the demonstration's. Marks the box.
  [[nodiscard]] Command act(const Observation& observation, Annotations& annotations) override;

 private:
  std::shared_ptr<const TrackerModel> model_;
  std::unique_ptr<TargetPointer> pointer_;
  FrameTracker tracker_;
  BoxResponse response_;
  bool started_ = false;
};

class TrackerPolicyModel final : public PolicyModelOf<TrackerModel> {
 public:
  using PolicyModelOf::PolicyModelOf;
  [[nodiscard]] std::string_view method() const override { return "tracker"; }
  /// Throws UsageError where `pointer` is null.
  [[nodiscard]] std::unique_ptr<Policy> make(const Random& random,
                                             std::unique_ptr<TargetPointer> pointer) const override;
  [[nodiscard]] Command mean_command() const override { return model()->origin.mean; }
  [[nodiscard]] std::optional<double> frame_rate_hz() const override { return std::nullopt; }
  [[nodiscard]] GivenBoxes given_boxes() const override { return GivenBoxes::kAtTheStart; }
};

/// Learns the map (docs/design/baselines.md) from where the default tracker of `pacer track` says
/// that the target is in the demonstration; it is started anew where it is wrong. The same
/// demonstration and random: the same model. Throws as read_marked().
[[nodiscard]] TrackerModel train_tracker(const MarkedDemonstration& demonstration,
                                         const LossConfig& when_lost, const Random& random,
                                         const TrainingOptions& options, TrainingReport& report);

}  // namespace pacer::baselines
