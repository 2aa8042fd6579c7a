// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <numeric>
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

/// The bare loop over the first `episodes` episodes' drives, in a process of its own as a worker
/// is.
double bare_frames_a_second(const StudyContext& context, std::uint32_t episodes) {
  std::vector<std::uint32_t> indices(episodes);
  std::iota(indices.begin(), indices.end(), 0U);
  double seconds_a_frame = 0.0;
  const bool whole = run_in_workers(
      1, indices,
      [&](std::uint32_t episode) {
        const Random random = context.scenario.episode_random(Purpose::kCollect, episode);
        return nlohmann::json(bare_loop_frames_a_second(
                                  context.scenario.simulated_for(Purpose::kCollect),
                                  random.fork("car"),
                                  StepInputs::of_demonstration(context.scenario, episode)))
            .dump();
      },
      [&](std::uint32_t, const std::string& result) {
        seconds_a_frame += 1.0 / nlohmann::json::parse(result).get<double>() / episodes;
      },
      context.control.stop);
  if (!whole) throw StudyStopped();
  return 1.0 / seconds_a_frame;
}

/// The most memory a worker held for `episodes` episodes of `frames` frames.
double peak_mb(const StudyContext& context, std::uint64_t episodes, double frames) {
  StudyContext brief = context;
  brief.scenario.simulated.duration =
      Seconds{frames / context.scenario.simulated.camera.frame_rate_hz};
  return timed_collect(brief, episodes, 1).worker_peak_mb;
}

}  // namespace

/// What recording costs beside a loop that only simulates and draws.
StudyResult study_throughput(const StudyContext& context, report::Page& page) {
  constexpr std::uint32_t kEpisodes = 4;

  double bare = 0.0;
  CollectReport one;
  {
    const OneCore one_core;
    bare = bare_frames_a_second(context, kEpisodes);
    one = timed_collect(context, kEpisodes, 1);
  }
  // One, two, two, one: a machine that grows slower meanwhile is no worse for either.
  double seconds_of_one = 0.0;
  double seconds_of_two = 0.0;
  std::uint64_t frames = 0;
  for (const bool two_first : {false, true}) {
    for (const bool two : {two_first, !two_first}) {
      const CollectReport report = timed_collect(context, kEpisodes, two ? 2 : 1);
      (two ? seconds_of_two : seconds_of_one) += report.seconds;
      if (two) frames += report.frames;
    }
  }
  const double rate_of_one = static_cast<double>(frames) / seconds_of_one;
  const double rate_of_two = static_cast<double>(frames) / seconds_of_two;

  // The same twenty rooms in one worker, looked at for 1,000 frames in all and for 20,000.
  constexpr std::uint64_t kRooms = 20;
  const double peak_of_thousand = peak_mb(context, kRooms, 50.0);
  const double peak = peak_mb(context, kRooms, 1000.0);

  const double rate = static_cast<double>(one.frames) / one.seconds;
  const double over_bare = rate / bare;
  const double two_over_one = rate_of_two / rate_of_one;
  const double growth = peak - peak_of_thousand;

  StudyResult result;
  result.figures = {{"bare_frames_per_s", bare},
                    {"collect_frames_per_s", rate},
                    {"collect_over_bare", over_bare},
                    {"one_worker_frames_per_s", rate_of_one},
                    {"two_workers_frames_per_s", rate_of_two},
                    {"two_workers_over_one", two_over_one},
                    {"worker_peak_mb", peak},
                    {"worker_peak_growth_mb", growth}};
  result.claims = {
      at_least("collect_over_bare", "recording takes a third longer than drawing alone, at most",
               over_bare, 0.75),
      at_least("two_workers_over_one", "workers scale", two_over_one, 1.7),
      at_most("worker_peak_mb", "a worker is small", peak, 400.0),
      at_most("worker_peak_growth_mb", "memory does not grow with the recording", growth, 5.0)};
  page.section("Frames a second")
      .paragraph(fmt::format("One core: the bare loop {:.0f}, collect {:.0f}. Two cores: one "
                             "worker {:.0f}, two {:.0f}.",
                             bare, rate, rate_of_one, rate_of_two))
      .paragraph(
          fmt::format("The bare loop takes the very physics steps that were recorded. Memory: "
                      "{} rooms in one worker, {:.0f} MB after 50 frames of each, {:.0f} MB "
                      "after 1,000.",
                      kRooms, peak_of_thousand, peak));
  return result;
}

}  // namespace pacer
