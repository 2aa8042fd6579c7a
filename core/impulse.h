// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/demonstration.h"
#include "core/policy.h"
#include "core/units.h"

namespace pacer {

/// How one impulse goes (thesis, 5.3.1: "each action starts and ends with the car stationary").
struct ImpulseConfig {
  Seconds move{0.40};    ///< that the command is held
  Seconds settle{0.72};  ///< from then on, until the car stands and a picture of that has come
  double brake = 1.0;    ///< stick below neutral meanwhile; with too little it rolls on

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("move_s", move);
    visit("settle_s", settle);
    visit("brake", brake);
  }
};

/// Drives by impulses: asks a policy while the car is at rest, does as it says for a set time,
/// stops, waits until the car stands again, and asks anew. Waits before the first question too:
/// nothing says that the car stands.
///
/// The policy sees only the frames on which it is asked. Its command is the impulse's, ahead only;
/// neutral is none: it is asked again on the next frame. The frame on which an impulse begins is
/// the one that the policy has seen.
class ImpulsePolicy final : public Policy {
 public:
  /// `policy` must outlive it.
  ImpulsePolicy(const ImpulseConfig& config, Policy& policy);

  /// The policy's marks on the frames that it saw; its points and its label through the impulse.
  [[nodiscard]] Command act(const Observation& observation, Annotations& annotations) override;
  [[nodiscard]] Driver driver() const override { return policy_.driver(); }

 private:
  ImpulseConfig config_;
  Policy& policy_;
  bool started_ = false;
  Seconds move_until_{}, rest_until_{};
  Command impulse_;
  std::vector<PointMark> points_;  // of the impulse under way
  std::string label_;
};

/// What is learnt from one impulse: what was seen at rest, and what was done about it.
struct ImpulseExemplar {
  const Frame* frame = nullptr;  ///< on which the impulse began; lives until the stream's next one
  Command command;               ///< the impulse's, limits past: the throttle that it rose to
};

/// The impulses of one recorded episode, in order: each a stretch of steps with throttle, taken
/// from its first step's frame and its last step's command. One that the recording's end cuts
/// short counts when its throttle had stopped rising.
class ImpulseStream {
 public:
  explicit ImpulseStream(std::unique_ptr<DemonstrationStream> episode);

  /// The next impulse; nullptr after the last. Lives until the next call. Throws as the episode's
  /// stream does.
  [[nodiscard]] const ImpulseExemplar* next();

  /// Of the episode, read so far.
  [[nodiscard]] std::uint64_t frames() const noexcept { return frames_; }

 private:
  std::unique_ptr<DemonstrationStream> episode_;
  std::uint64_t frames_ = 0;
  Frame frame_;
  ImpulseExemplar exemplar_;
};

}  // namespace pacer
