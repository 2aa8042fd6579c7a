// SPDX-License-Identifier: Apache-2.0
#include "runs/tracking/tracking_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "runs/tracking/tracking_charts.h"
#include "runs/tracking/tracking_story.h"

namespace pacer {
namespace {

using report::Content;
using report::Text;

bool has_truth(const TrackingComparison& comparison) {
  return std::ranges::any_of(comparison.runs,
                             [](const ScoredRun& one) { return one.score.scored > 0; });
}

void add_tiles(Content& content, const TrackingComparison& comparison) {
  std::vector<TrackerSummary> summaries = summarise(comparison);
  if (std::ranges::any_of(summaries,
                          &TrackerSummary::whole)) {  // the others are not to be compared
    std::erase_if(summaries, [](const TrackerSummary& one) { return !one.whole(); });
  }
  const auto tile = [](const char* label, const TrackerSummary& one, std::string detail) {
    return report::Tile{.label = label, .value = one.name, .detail = std::move(detail)};
  };
  const auto best = [&](double TrackerSummary::*field) -> const TrackerSummary& {
    return *std::ranges::max_element(summaries, [field](const auto& a, const auto& b) {
      return (std::isnan(a.*field) ? -1.0 : a.*field) < (std::isnan(b.*field) ? -1.0 : b.*field);
    });
  };
  std::vector<report::Tile> tiles;
  if (has_truth(comparison)) {
    const TrackerSummary& surest = best(&TrackerSummary::success);
    const TrackerSummary& nearest = best(&TrackerSummary::precision);
    const TrackerSummary& longest = best(&TrackerSummary::held);
    tiles.push_back(tile("most success", surest, fmt::format("AUC {:.3f}", surest.success)));
    tiles.push_back(tile("most precise", nearest,
                         fmt::format("{:.1f} % within 20 px", 100.0 * nearest.precision)));
    tiles.push_back(
        tile("holds longest", longest, fmt::format("{:.1f} % of frames", 100.0 * longest.held)));
  }
  const TrackerSummary& fastest = best(&TrackerSummary::fps);
  if (!std::isnan(fastest.fps)) {
    tiles.push_back(tile("fastest", fastest, fmt::format("{:.0f} frames a second", fastest.fps)));
  }
  content.tiles(tiles);
}

/// Which colour is whose, above pictures.
Text legend(const TrackingComparison& comparison) {
  Text text = "Boxes: truth in white";
  for (const BoxStyle& style : styles_of(comparison)) {
    if (style.name == truth_style().name) continue;
    text += Text(", ") + Text::swatch(style.colour) + Text(style.name);
  }
  if (!comparison.peers.empty()) text += Text("; other people's trackers are dashed");
  return text;
}

void add_story(Content& content, const TrackingComparison& comparison, std::size_t target) {
  TrackingStory story;
  try {
    story = tell(comparison, target);
  } catch (const std::runtime_error& failure) {
    content.note(fmt::format("No pictures: {}", failure.what()), report::Verdict::kShort);
    return;
  }
  if (!story.error.empty()) {
    content.note(fmt::format("The pictures end early: {}", story.error), report::Verdict::kShort);
  }
  if (story.pictures.empty()) return;
  content.paragraph(legend(comparison));
  std::vector<report::Figure> figures;
  for (const KeyPicture& picture : story.pictures) {
    figures.push_back({.bytes = picture.jpg, .caption = picture.about});
  }
  content.gallery(figures);
  Content film;
  film.video({.bytes = {reinterpret_cast<const std::uint8_t*>(story.mp4.data()), story.mp4.size()},
              .caption = {},
              .poster = story.pictures.front().jpg});
  content.details("Picture by picture", film);
}

}  // namespace

void report_target(report::Page& page, const TrackingComparison& comparison, std::size_t target) {
  const TrackingTarget& which = comparison.targets[target];
  Content& content = page.section(which.name);
  const bool scored = std::ranges::any_of(comparison.runs, [&](const ScoredRun& one) {
    return one.run.target == which.name && one.score.scored > 0;
  });
  content.table(tracking_charts::target_table(comparison, target));
  if (scored) {
    content.chart({.spec = tracking_charts::error_plot(comparison, target),
                   .caption = "Distance of the box's centre from the true one. What leaves the "
                              "chart is lost."});
  }
  add_story(content, comparison, target);
}

void report_tracking(report::Page& page, const TrackingComparison& comparison) {
  const bool scored = has_truth(comparison);
  if (!comparison.whole) {
    page.lead().note(
        "Interrupted: trackers that were not shown every picture come last in the ranking, which "
        "says how many they saw. Run the command again for the whole comparison.",
        report::Verdict::kShort);
  }
  if (!comparison.runs.empty()) add_tiles(page.lead(), comparison);
  Content& ranking = page.section("Ranking");
  ranking.table(summary_table(comparison));
  ranking.paragraph(fmt::format(
      "Success is the area under OTB's success plot (21 thresholds of overlap), precision the "
      "share of pictures whose centre is within 20 px of the true one, both of one pass from the "
      "first truth on, means over sequences. Held: pictures until the centre lies outside the "
      "true box for most of the next {}. Failures: how often the overlap falls to nothing "
      "when the tracker is started again five pictures after each time, as VOT does. Speed: the "
      "tracker alone, from picture in memory to box, on one core; the median over sequences. "
      "Pictures without truth count nowhere.",
      TrackingScore::kLossWindow));
  ranking.paragraph(
      "AUC: area under the curve. OTB and VOT: the benchmarks whose measures these are. LP: linear "
      "predictor; LK: Lucas-Kanade; FLOCK, SMAT, MED: the thesis's ways to combine and re-learn "
      "them; CASCADE: ours beyond it. What each of the others is: pacer track --help.");
  if (scored) {
    const std::vector<report::Chart> plots = {
        {.spec = tracking_charts::success_plot(comparison), .caption = {}},
        {.spec = tracking_charts::precision_plot(comparison), .caption = {}}};
    page.section("Success and precision").charts(plots);
    if (comparison.targets.size() > 1) {
      page.section("By sequence")
          .chart({.spec = tracking_charts::success_map(comparison), .caption = {}});
    }
  }
  Content& speed = page.section("Speed");
  speed.table(tracking_charts::speed_table(comparison));
  if (scored) speed.chart({.spec = tracking_charts::speed_plot(comparison), .caption = {}});
  for (std::size_t target = 0; target < comparison.targets.size(); ++target) {
    report_target(page, comparison, target);
  }
}

}  // namespace pacer
