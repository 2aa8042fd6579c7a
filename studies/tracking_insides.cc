// SPDX-License-Identifier: Apache-2.0
#include "studies/tracking_insides.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <numeric>
#include <optional>

#include "core/check.h"
#include "runs/report/charts.h"
#include "runs/report/picture.h"
#include "runs/tracking/picture_chunks.h"
#include "runs/tracking/tracking_film.h"
#include "studies/materials.h"
#include "studies/tracking_claims.h"
#include "studies/tracking_clusters.h"

namespace pacer {
namespace {

/// Pictures of one tracker at work that make a figure of the thesis.
struct InsideFigure {
  std::string heading;
  std::string tracker;
  std::string sequence;
  std::vector<std::size_t> drawn;
  std::string about;
  bool with_clusters = false;  ///< of the target's templates, too: Figure 4.5
  bool with_speed = false;     ///< along the sequence, LP-MED's too: Figure 4.11
};

const std::vector<InsideFigure>& figures() {
  static const std::string aspects =
      "Below each picture the median templates of LP-SMAT's components, by falling weight; the one "
      "with the bull's-eye is this picture's. ";
  static const std::vector<InsideFigure> all = {
      {.heading = "Figure 4.4: aspects of a head",
       .tracker = "LP-SMAT",
       .sequence = "head-motion",
       .drawn = {100, 350},
       .about = aspects + "From side, front and behind a mug."},
      {.heading = "Figure 4.9: aspects of a car",
       .tracker = "LP-SMAT",
       .sequence = "car-surveillance",
       .drawn = {0, 141, 281},
       .about = aspects + "In the first, a middle and the last picture."},
      {.heading = "Figure 4.12: aspects of Dudek",
       .tracker = "LP-SMAT",
       .sequence = "Dudek",
       .drawn = {213, 240, 370, 420},
       .about = aspects + "While the hand is before the face and after; while the glasses come off "
                          "and after.",
       .with_speed = true},
      {.heading = "Figure 4.12: aspects of a face",
       .tracker = "LP-SMAT",
       .sequence = "face-hand",
       .drawn = {213, 240, 366, 420},
       .about = aspects + "While the hand is before the face and after; while the glasses come off "
                          "and after.",
       .with_speed = true},
      {.heading = "Figure 4.15: predictors replaced",
       .tracker = "LP-MED",
       .sequence = "head-motion",
       .drawn = {60, 120, 150, 350},
       .about = "LP-MED's predictors as points; with the range of their support the one that did "
                "worst in this picture, and the one that was learnt from it.",
       .with_clusters = true}};
  return all;
}

/// The floating average of a second, frames a second.
report::Series rate_series(const std::string& name, const std::vector<double>& update_s) {
  constexpr std::size_t kWindow = 25;
  constexpr std::size_t kMost = 300;  // points that a chart can show
  report::Series series{.name = name, .x = {}, .y = {}};
  const std::size_t step = std::max<std::size_t>(1, (update_s.size() + kMost - 1) / kMost);
  for (std::size_t end = kWindow; end <= update_s.size(); end += step) {
    const auto last = update_s.begin() + static_cast<std::ptrdiff_t>(end);
    const double sum = std::accumulate(last - static_cast<std::ptrdiff_t>(kWindow), last, 0.0);
    series.x.push_back(static_cast<double>(end + 1));
    series.y.push_back(static_cast<double>(kWindow) / sum);
  }
  return series;
}

std::optional<Box> truth_at(const TrackingTarget& target, std::size_t at) {
  return at < target.truth.size() ? target.truth[at] : std::nullopt;
}

void add_rates(const ScoredRun& boosting, const std::vector<report::Series>& series,
               report::Page& page) {
  std::vector<std::string> names;
  for (const report::Series& one : series) names.push_back(one.name);
  const double mark = boosting.run.fps();
  const report::Axis rate = {.title = "frames a second", .unit = "logarithmic", .log = true};
  page.section("Figure 4.11: speed along " + boosting.run.target)
      .chart(
          {.spec = report::line_chart(series, {.title = "picture"}, rate, report::Palette(names),
                                      {}, {&mark, 1}),
           .caption = fmt::format("Floating averages of 25 pictures, alone on one core. The level "
                                  "is Boosting's mean, {:.0f} frames a second.",
                                  mark)});
}

}  // namespace

TrackerInsides look_inside(const std::string& name, const TrackingTarget& target,
                           const std::vector<std::size_t>& drawn, std::uint64_t seed,
                           const std::stop_token& stop, const InsideWatch& watch) {
  using Clock = std::chrono::steady_clock;
  constexpr std::size_t kChunk = 64;
  const auto& kinds = tracking::trackers();
  const auto kind = std::ranges::find(kinds, name, &tracking::TrackerKind::name);
  check(kind != kinds.end(), "a tracker of ours is looked into");
  const std::unique_ptr<tracking::Tracker> tracker = kind->make(seed);
  const OneCore core;
  TrackerInsides insides;
  TrackerDrawing drawing(name, /*with_truth=*/true);
  drawing.expect_patches();
  Annotations marks;
  PictureChunks chunks(target);
  std::size_t at = 0;
  for (auto chunk = chunks.next(kChunk); !chunk.empty(); chunk = chunks.next(kChunk)) {
    for (const tracking::Picture& picture : chunk) {
      if (stop.stop_requested()) throw StudyStopped();
      tracking::Track track{.box = target.box, .confidence = 1.0};
      const Clock::time_point start = Clock::now();
      if (at == 0) {
        tracker->start(picture, target.box);
      } else {
        track = tracker->update(picture);
        insides.update_s.push_back(std::chrono::duration<double>(Clock::now() - start).count());
      }
      const std::size_t number = target.first + at;
      watch(number, picture);
      if (std::ranges::find(drawn, at) != drawn.end()) {
        marks.clear();
        tracker->annotate(marks);
        insides.shots.push_back(
            {.at = number,
             .jpg = report::encode_jpeg(
                 drawing.draw(number, picture.bgr, track, marks, truth_at(target, number)))});
      }
      ++at;
    }
  }
  return insides;
}

void add_insides(const TrackingComparison& comparison, std::uint64_t seed,
                 const std::stop_token& stop, report::Page& page) {
  for (const InsideFigure& figure : figures()) {
    const auto target =
        std::ranges::find(comparison.targets, figure.sequence, &TrackingTarget::name);
    if (target == comparison.targets.end()) continue;
    ClusteredTemplates clusters(target->box);
    const TrackerInsides insides =
        look_inside(figure.tracker, *target, figure.drawn, seed, stop,
                    [&](std::size_t at, const tracking::Picture& picture) {
                      const std::optional<Box> truth = truth_at(*target, at);
                      if (figure.with_clusters && truth) clusters.add(picture.grey, *truth);
                    });
    std::vector<report::Figure> shots;
    for (const TrackerInsides::Shot& shot : insides.shots) shots.push_back({.bytes = shot.jpg});
    page.section(figure.heading).paragraph(figure.about).gallery(shots);
    if (figure.with_clusters) clusters.add_to(page);

    const ScoredRun* const boosting = find_run(comparison, figure.sequence, "Boosting");
    if (boosting == nullptr || !figure.with_speed) continue;
    add_rates(*boosting,
              {rate_series("LP-SMAT", insides.update_s),
               rate_series("LP-MED", look_inside("LP-MED", *target, {}, seed, stop).update_s)},
              page);
  }
}

}  // namespace pacer
