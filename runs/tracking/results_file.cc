// SPDX-License-Identifier: Apache-2.0
#include "runs/tracking/results_file.h"

#include <fmt/format.h>

#include <system_error>
#include <utility>

#include "core/check.h"
#include "core/output_file.h"

namespace pacer {
std::string results_text(std::size_t first, std::span<const tracking::Track> tracks) {
  std::string text;
  for (std::size_t i = 0; i < first; ++i) text += "NaN,NaN,NaN,NaN\n";
  for (const tracking::Track& track : tracks) {
    const Box& box = track.box;
    if (is_proper(box)) {
      text += fmt::format("{:.8g},{:.8g},{:.8g},{:.8g}\n", box.left() + 1.0, box.top() + 1.0,
                          box.width, box.height);
    } else {
      text += "NaN,NaN,NaN,NaN\n";
    }
  }
  return text;
}

ResultFiles::ResultFiles(std::filesystem::path out, bool several) : out_(std::move(out)) {
  if (out_.empty()) return;
  std::error_code error;
  const bool there = std::filesystem::exists(out_, error);
  folder_ = several || std::filesystem::is_directory(out_, error);
  if (folder_ && there && !std::filesystem::is_directory(out_, error)) {
    throw UsageError(out_.string() + ": is a file; several results want a folder");
  }
}

std::filesystem::path ResultFiles::place(const std::string& tracker,
                                         const std::string& target) const {
  return folder_ ? out_ / tracker / (target + ".txt") : out_;
}

void ResultFiles::try_one(const std::string& tracker, const std::string& target) const {
  if (!out_.empty()) const OutputFile tried(place(tracker, target));
}

void ResultFiles::write(const TrackingRun& run) const {
  if (out_.empty() || run.tracks.empty()) return;
  OutputFile file(place(run.tracker, run.target));
  file.write(results_text(run.first, run.tracks));
  file.keep();
}

}  // namespace pacer
