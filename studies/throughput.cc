// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "runs/collect.h"
#include "runs/worker_pool.h"
#include "studies/bare_loop.h"
#include "studies/materials.h"
#include "studies/studies.h"

namespace pacer {
namespace {

/// A folder for recordings that are only timed; gone afterwards.
class ScratchFolder {
 public:
  explicit ScratchFolder(std::filesystem::path path) : path_(std::move(path)) {
    std::filesystem::remove_all(path_);
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Records `episodes` episodes anew with `jobs` workers.
CollectReport timed_collect(const StudyContext& context, std::uint64_t episodes, int jobs) {
  std::filesystem::create_directories(context.cache);
  const ScratchFolder scratch(context.cache / "throughput");
  RunControl control = context.control;
  control.jobs = jobs;
  const CollectReport report =
      collect(context.scenario, Purpose::kCollect, episodes, scratch.path(), control);
  if (!report.whole) throw StudyStopped();
  return report;
}

/// The bare loop over the rooms of the first `episodes` episodes, in a process of its own as a
/// worker is.
double bare_frames_a_second(const StudyContext& context, std::uint32_t episodes,
                            std::uint64_t frames_each) {
  std::vector<std::uint32_t> indices(episodes);
  for (std::uint32_t i = 0; i < episodes; ++i) indices[i] = i;
  double seconds = 0.0;
  run_in_workers(
      1, indices,
      [&](std::uint32_t episode) {
        const Random random = context.scenario.episode_random(Purpose::kCollect, episode);
        return nlohmann::json(
                   bare_loop_frames_a_second(context.scenario.simulated_for(Purpose::kCollect),
                                             random.fork("car"), frames_each))
            .dump();
      },
      [&](std::uint32_t, const std::string& result) {
        seconds += static_cast<double>(frames_each) / nlohmann::json::parse(result).get<double>();
      },
      context.control.stop);
  return static_cast<double>(frames_each * episodes) / seconds;
}

}  // namespace

/// What recording costs beside a loop that only simulates and draws.
StudyResult study_throughput(const StudyContext& context, report::Page& page) {
  constexpr std::uint32_t kEpisodes = 4;
  const double frames_each =
      context.scenario.simulated.duration.count() * context.scenario.simulated.camera.frame_rate_hz;

  double bare = 0.0;
  CollectReport one;
  {
    const OneCore one_core;
    bare = bare_frames_a_second(context, kEpisodes, static_cast<std::uint64_t>(frames_each));
    one = timed_collect(context, kEpisodes, 1);
  }
  const CollectReport free_one = timed_collect(context, kEpisodes, 1);
  const CollectReport two = timed_collect(context, kEpisodes, 2);

  StudyContext brief = context;  // one worker, a thousand frames, then twenty thousand
  constexpr double kBriefFrames = 1000.0;
  brief.scenario.simulated.duration =
      Seconds{kBriefFrames / context.scenario.simulated.camera.frame_rate_hz};
  const CollectReport thousand = timed_collect(brief, 1, 1);
  const CollectReport twenty_thousand = timed_collect(brief, 20, 1);

  const auto rate = [](const CollectReport& report) {
    return static_cast<double>(report.frames) / report.seconds;
  };
  const double over_bare = rate(one) / bare;
  const double two_over_one = rate(two) / rate(free_one);
  const double growth = twenty_thousand.worker_peak_mb - thousand.worker_peak_mb;

  StudyResult result;
  result.figures = {{"bare_frames_per_s", bare},
                    {"collect_frames_per_s", rate(one)},
                    {"collect_over_bare", over_bare},
                    {"one_worker_frames_per_s", rate(free_one)},
                    {"two_workers_frames_per_s", rate(two)},
                    {"two_workers_over_one", two_over_one},
                    {"worker_peak_mb", twenty_thousand.worker_peak_mb},
                    {"worker_peak_growth_mb", growth}};
  result.claims = {
      at_least("collect_over_bare", "recording costs a third of drawing at most", over_bare, 0.75),
      at_least("two_workers_over_one", "workers scale", two_over_one, 1.7),
      at_most("worker_peak_mb", "a worker is small", twenty_thousand.worker_peak_mb, 400.0),
      at_most("worker_peak_growth_mb", "memory does not grow with the recording", growth, 5.0)};
  page.section("Frames a second")
      .paragraph(fmt::format("One core: the bare loop {:.0f}, collect {:.0f}. Two cores: one "
                             "worker {:.0f}, two {:.0f}.",
                             bare, rate(one), rate(free_one), rate(two)));
  return result;
}

}  // namespace pacer
