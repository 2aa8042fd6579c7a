// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "apps/command.h"
#include "runs/tracking/compare_trackers.h"

namespace pacer {

/// `pacer track` as it was asked for.
struct TrackCommand {
  CommonOptions common;
  std::vector<std::string> sources;
  std::vector<std::string> trackers;
  std::string box;
  bool draw = false;
  bool robustness = false;
  std::filesystem::path out;
  std::filesystem::path video;
  std::filesystem::path report;

  void run(const std::stop_token& stop) const;

 private:
  using Kinds = std::vector<tracking::TrackerKind>;

  [[nodiscard]] std::uint64_t seed() const;
  [[nodiscard]] std::vector<TrackingTarget> targets(std::optional<Box> typed) const;
  void run_recorded(const Kinds& kinds, const std::optional<Box>& typed,
                    const std::stop_token& stop) const;
  void run_camera(int number, const Kinds& kinds, const std::optional<Box>& typed,
                  const std::stop_token& stop) const;
  /// Prints and writes what was found, then what went wrong.
  /// `unwritten`: why a result was not written; empty: all were.
  void tell(const TrackingComparison& comparison, const std::string& unwritten = {}) const;
};

}  // namespace pacer
