// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/box.h"
#include "learning/tracking/tracker.h"
#include "runs/tracking/tracking_run.h"

namespace pacer {

/// Results in OTB's form: a line a picture, `x,y,width,height` in pixels, the top-left one being
/// 1,1; `NaN,NaN,NaN,NaN` for each of the `first` pictures before the tracker started. Eight
/// digits: a thousandth of a pixel, however large the picture.
[[nodiscard]] std::string results_text(std::size_t first, std::span<const tracking::Track> tracks);

/// Where the results of runs go: one file, or a folder with TRACKER/TARGET.txt for each.
class ResultFiles {
 public:
  /// One run's results go into the file `out` unless that is a folder, those of `several` into a
  /// folder; nowhere where it is empty. Throws UsageError for several results and one file.
  ResultFiles(std::filesystem::path out, bool several);

  /// Whether the results of this tracker on this target could be written, tried before the work.
  /// Throws std::runtime_error, naming the file, where not.
  void try_one(const std::string& tracker, const std::string& target) const;
  /// Writes them, whole or not at all; a run without a track leaves no file. Throws like try_one().
  void write(const TrackingRun& run) const;

 private:
  [[nodiscard]] std::filesystem::path place(const std::string& tracker,
                                            const std::string& target) const;

  std::filesystem::path out_;
  bool folder_ = false;
};

}  // namespace pacer
