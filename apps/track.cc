// SPDX-License-Identifier: Apache-2.0
#include "apps/track.h"

#include <fmt/format.h>

#include <memory>
#include <opencv2/core/mat.hpp>
#include <set>

#include "apps/terminal_progress.h"
#include "core/check.h"
#include "core/version.h"
#include "learning/tracking/peers/peers.h"
#include "runs/tracking/choose_trackers.h"
#include "runs/tracking/live_view.h"
#include "runs/tracking/results_file.h"
#include "runs/tracking/tracking_film.h"
#include "runs/tracking/tracking_report.h"
#include "runs/tracking/tracking_story.h"

namespace pacer {
namespace {

using tracking::TrackerKind;

std::vector<TrackerKind> every_tracker() {
  std::vector<TrackerKind> all = tracking::trackers();
  all.insert(all.end(), tracking::peers().begin(), tracking::peers().end());
  return all;
}

/// The number of a camera: `camera:0`, or `0` where no file is called so.
std::optional<int> camera_number(const std::string& source) {
  constexpr std::string_view kCamera = "camera:";
  const bool named = source.starts_with(kCamera);
  const std::string digits = named ? source.substr(kCamera.size()) : source;
  const bool number = !digits.empty() && digits.size() <= 4 &&
                      digits.find_first_not_of("0123456789") == std::string::npos;
  if (named && !number) throw UsageError(source + ": want a camera's number, as in camera:0");
  std::error_code error;
  if (!number || (!named && std::filesystem::exists(source, error))) return std::nullopt;
  return std::stoi(digits);
}

void print(const ScoredRun& one) {
  const auto& [run, score] = one;
  fmt::print("{} on {}: {} pictures", run.tracker, run.target, run.tracks.size());
  if (run.update_s > 0.0) fmt::print(", {:.0f} a second", run.fps());
  fmt::print("\n");
  if (score.scored == 0) return;
  fmt::print("success {:.3f}, precision {:.3f}; held for {} of {} pictures; {} failures\n",
             score.success, score.precision, score.frames_held, score.scored, run.failures.size());
}

/// Notes on trackers that threw; throws where nothing was tracked, where the pictures ended early,
/// or where a person ended it.
void finish(const TrackingComparison& comparison) {
  const TrackingRun* broken = nullptr;
  std::set<std::string> partly;  // annotated, and said to be
  for (const auto& [run, score] : comparison.runs) {
    if (score.scored > 0 && score.scored < run.pictures && partly.insert(run.target).second) {
      fmt::print(stderr, "note: {}: {} of {} pictures have a box; only these are scored\n",
                 run.target, score.scored, run.pictures);
    }
    if (!run.sequence_error.empty()) broken = &run;
    if (run.tracker_error.empty()) continue;
    if (run.tracks.empty()) {
      fmt::print(stderr, "note: {} on {}: not started: {}\n", run.tracker, run.target,
                 run.tracker_error);
    } else {
      fmt::print(stderr, "note: {} on {}: lost after {} pictures, since it threw: {}\n",
                 run.tracker, run.target, run.tracks.size(), run.tracker_error);
    }
  }
  if (!comparison.whole) {
    fmt::print(stderr, "interrupted: what was tracked until then is kept\n");
    throw Unfinished{};
  }
  if (broken == nullptr) return;
  throw std::runtime_error(fmt::format("{}: {}; what was tracked until then is kept",
                                       broken->target, broken->sequence_error));
}

}  // namespace

void TrackCommand::run(const std::stop_token& stop) const {
  if (!common.set.empty()) {
    throw UsageError("--set: tracking has no scenario; every tracker has one set of parameters");
  }
  keep_apart({sources.begin(), sources.end()}, {out, video, report, common.json});
  const Kinds kinds = choose_trackers(trackers, every_tracker());
  std::optional<Box> typed;
  if (!box.empty()) typed = parse_box(box);
  const std::optional<int> camera =
      sources.size() == 1 ? camera_number(sources.front()) : std::nullopt;
  if (camera) {
    run_camera(*camera, kinds, typed, stop);
  } else {
    run_recorded(kinds, typed, stop);
  }
}

std::uint64_t TrackCommand::seed() const { return common.seed.value_or(Scenario{}.seed); }

std::vector<TrackingTarget> TrackCommand::targets(std::optional<Box> typed) const {
  std::vector<dataset::Sequence> sequences;
  for (const std::string& source : sources) {
    for (dataset::Sequence& one : dataset::find_sequences(source)) {
      sequences.push_back(std::move(one));
    }
  }
  if (draw) {
    if (sequences.size() != 1) throw UsageError("--draw: wants one sequence");
    cv::Mat first;
    if (!dataset::read_pictures(sequences.front())->next(first)) {
      throw std::runtime_error(sequences.front().path.string() + ": has no picture");
    }
    typed = draw_box(first);
    if (!typed) throw std::runtime_error("no box was drawn");
  }
  std::vector<TrackingTarget> found = targets_of(sequences, typed);
  std::set<std::string> names;
  for (const TrackingTarget& target : found) {
    if (names.insert(target.name).second) continue;
    throw UsageError(target.name + ": two sequences have this name; rename a folder");
  }
  return found;
}

void TrackCommand::run_recorded(const Kinds& kinds, const std::optional<Box>& typed,
                                const std::stop_token& stop) const {
  const std::vector<TrackingTarget> found = targets(typed);
  if (!video.empty() && found.size() != 1) {
    throw UsageError(fmt::format("--video: films one target; these are {}", found.size()));
  }
  const bool single = kinds.size() * found.size() == 1;
  const ResultFiles results(out, !single);
  results.try_one(kinds.front().name, found.front().name);

  TrackingOptions options{.seed = seed(), .robustness = robustness};
  std::optional<TrackerFilm> film;
  if (single && !video.empty()) {
    film.emplace(video, film_rate(found.front().sequence), kinds.front().name, found.front().first,
                 found.front().truth);
    options.watch = film->watch();
  }
  RunControl control = common.control(stop);
  TerminalProgress progress;
  control.progress = progress.callback();
  std::string unwritten;  // why; scores and report are not lost for it
  TrackingComparison comparison =
      compare_trackers(kinds, found, options, control, [&](const ScoredRun& one) {
        try {
          results.write(one.run);
        } catch (const std::runtime_error& failure) {
          if (unwritten.empty()) unwritten = failure.what();
        }
      });
  for (const TrackerKind& peer : tracking::peers()) comparison.peers.push_back(peer.name);
  progress.finish();
  if (film) film->close();
  if (!single && !video.empty()) film_trackers(comparison, 0, video, stop);

  const TrackingRun* const only = single ? &comparison.runs.front().run : nullptr;
  if (only != nullptr && only->tracks.empty() && !only->tracker_error.empty()) {
    if (typed) throw UsageError("--box: " + only->tracker_error);
    throw std::runtime_error(fmt::format("{}: {}", only->target, only->tracker_error));
  }
  tell(comparison, unwritten);
}

void TrackCommand::tell(const TrackingComparison& comparison, const std::string& unwritten) const {
  if (comparison.trackers.size() * comparison.targets.size() == 1) {
    print(comparison.runs.front());
  } else {
    fmt::print("{}\n", report::markdown(summary_table(comparison)));
  }
  if (!report.empty()) {
    report::Page page("Tracking", fmt::format("Trackers: {}, targets: {}; pacer {}, seed {}.",
                                              comparison.trackers.size(), comparison.targets.size(),
                                              kVersion, seed()));
    report_tracking(page, comparison);
    page.write(report);
    fmt::print("{}: the report; open it in a browser\n", report.string());
  }
  const bool tracked = std::ranges::any_of(
      comparison.runs, [](const ScoredRun& one) { return !one.run.tracks.empty(); });
  for (const auto& [path, what] : {std::pair(video, "video"), {out, "results"}}) {
    if (path.empty() || (path == out && !unwritten.empty())) continue;
    if (tracked) {
      fmt::print("{}: the {}\n", path.string(), what);
    } else {
      fmt::print("{}: not written, since nothing was tracked\n", path.string());
    }
  }
  common.write_json({{"seed", seed()},
                     {"default_tracker", tracking::trackers().front().name},
                     {"trackers", to_json(comparison)}});
  if (!unwritten.empty()) throw std::runtime_error(unwritten);
  finish(comparison);
}

void TrackCommand::run_camera(int number, const Kinds& kinds, const std::optional<Box>& typed,
                              const std::stop_token& stop) const {
  if (kinds.size() != 1) throw UsageError("--tracker: a camera is followed by one at a time");
  if (!report.empty()) throw UsageError("--report: a camera has no truth to be scored against");
  const ResultFiles results(out, false);
  const std::string name = fmt::format("camera-{}", number);
  results.try_one(kinds.front().name, name);
  bool window = true;
  try {
    require_display();
  } catch (const std::runtime_error&) {  // then a box and something to write will do
    window = false;
    if (!typed || (video.empty() && out.empty())) throw;
  }
  constexpr int kRate = 25;
  std::optional<TrackerFilm> film;
  if (!video.empty()) film.emplace(video, kRate, kinds.front().name);
  const TrackWatch watch = film ? film->watch() : TrackWatch{};
  const std::unique_ptr<dataset::PictureSource> camera = dataset::open_camera(number);
  TrackingComparison comparison;
  comparison.trackers = {kinds.front().name};
  comparison.targets.emplace_back().name = name;
  comparison.runs.push_back(
      {.run = window ? track_live(kinds.front(), *camera, typed, seed(), watch, stop)
                     : run_tracker(kinds.front(), *camera, *typed, {.seed = seed(), .watch = watch},
                                   stop),
       .score = {}});
  if (film) film->close();
  comparison.runs.front().run.target = name;  // whole: a camera's end is when a person says so
  results.write(comparison.runs.front().run);
  tell(comparison);
}

void add_track(CLI::App& app, const std::stop_token& stop) {
  auto options = std::make_shared<TrackCommand>();
  CLI::App* command =
      app.add_subcommand("track", "Follow a target through pictures, and compare trackers");
  command
      ->add_option("SEQUENCE", options->sources,
                   "Sequences (OTB, VOT, GOT-10k, TLD), folders of them or of pictures, videos; "
                   "or camera:0")
      ->required();
  command->add_option("--tracker", options->trackers,
                      "Trackers by name, or all (default: the first)");
  const CLI::Validator is_box(
      [](const std::string& text) {
        try {
          (void)parse_box(text);
          return std::string();
        } catch (const std::invalid_argument& error) {
          return std::string(error.what());
        }
      },
      "");
  CLI::Option* box =
      command
          ->add_option("--box", options->box,
                       "Where the target is in the first picture, x,y,width,height in pixels, the "
                       "top-left one being 1,1, as in OTB's files and in the results (default: "
                       "where the sequence's truth says)")
          ->check(is_box);
  command->add_flag("--draw", options->draw, "Draw the box in a window")->excludes(box);
  command
      ->add_option("--out", options->out,
                   "File of the boxes, in OTB's form; where there are several results, folder "
                   "of TRACKER/SEQUENCE.txt")
      ->check([](const std::string& text) { return text.empty() ? "names no file" : ""; });
  command
      ->add_option("--video", options->video,
                   "File of a film (mp4): boxes, truth, and what a single tracker makes of it")
      ->check(film_file());
  command->add_option("--report", options->report, "File of the report (HTML)")
      ->check(writable_file());
  command->add_flag("--robustness", options->robustness,
                    "Start elsewhere in time and place, too: OTB's TRE and SRE, 32 more runs");
  options->common.add_to(*command);
  std::string known;
  for (const TrackerKind& kind : every_tracker()) {
    known += fmt::format("\n  {:<18}{}", kind.name, kind.about);
  }
  command->footer("Trackers:" + known +
                  "\nExample: pacer track sequences/Dudek --tracker all --report out/dudek.html");
  command->callback([options, stop] { options->run(stop); });
}

}  // namespace pacer
