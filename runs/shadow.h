// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/drive.h"
#include "runs/match_gallery.h"
#include "runs/policy_source.h"

namespace pacer {

/// The teacher drove; what each model would have asked for on the same frames (Figure 6.15).
struct SignalTrace {
  std::vector<double> time_s;
  std::vector<Command> teacher;
  struct Model {
    std::string name;
    std::vector<Command> wanted;
  };
  std::vector<Model> models;
};

/// Lets models watch an episode that somebody else drives.
class Shadow final : public StepSink {
 public:
  /// Makes a policy of every source that is a model. `car` is the one that is driven, and must
  /// outlive it.
  Shadow(std::span<const PolicySource> sources, const Scenario& scenario, const sim::SimCar& car,
         const Random& random);

  [[nodiscard]] bool write(const Frame& frame, const Step& step) override;

  [[nodiscard]] const SignalTrace& trace() const noexcept { return trace_; }
  /// Of the first model of affordances; empty without one.
  [[nodiscard]] std::vector<MatchGallery::Picture> pictures() const;

 private:
  std::vector<std::unique_ptr<Policy>> models_;
  std::unique_ptr<MatchGallery> gallery_;
  SignalTrace trace_;
  Annotations ignored_;
  Command last_;
};

}  // namespace pacer
