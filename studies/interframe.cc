// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/check.h"
#include "runs/worker_pool.h"
#include "sim/sequences/simulated_sequence.h"
#include "studies/chapter3.h"
#include "studies/drawing.h"
#include "studies/materials.h"
#include "studies/studies.h"

namespace pacer {
namespace {

using chapter3::Three;
using Eigen::Vector2d;

constexpr int kTemplate = 40;  // pixels a side, as Figure 3.5 has it
constexpr int kSearched = 40;  // pixels either way, Figure 3.6
constexpr std::uint64_t kFlocks = 50;

/// Two neighbouring frames, and where the target is in them.
struct Pair {
  cv::Mat1b before, after;
  Vector2d from, to;
};

cv::Mat1b grey_of(const Frame& frame) {
  const cv::Mat rgb(frame.size.height, frame.size.width, CV_8UC3,
                    const_cast<std::uint8_t*>(frame.rgb.data()));  // NOLINT: only read
  cv::Mat1b grey;
  cv::cvtColor(rgb, grey, cv::COLOR_RGB2GRAY);
  return grey;
}

Vector2d position(const nlohmann::json& place) {
  return {place.at(0).get<double>(), place.at(1).get<double>()};
}

/// Frames 374 and 375 of the simulated camera shake, rendered in a process of its own.
Pair shaken_pair(const StudyContext& context) {
  constexpr std::uint64_t kBefore = 374;
  const auto& all = sim::simulated_sequences();
  const auto shake = std::ranges::find(all, "camera-shake", &sim::SimulatedSequence::name);
  check(shake != all.end(), "the camera shake is one of the simulated sequences");

  Pair pair;
  pair.before.create(shake->size.height, shake->size.width);
  pair.after.create(shake->size.height, shake->size.width);
  const std::uint32_t only = 0;
  const bool whole = run_in_workers(
      1, {&only, 1},
      [&](std::uint32_t) {
        std::string bytes;
        nlohmann::json places = nlohmann::json::array();
        std::uint64_t number = 0;
        (void)sim::render_sequence(*shake, context.scenario.seed,
                                   [&](const Frame& frame, const Box& truth) {
                                     if (number >= kBefore) {
                                       const cv::Mat1b grey = grey_of(frame);
                                       bytes.append(grey.datastart, grey.dataend);
                                       places.push_back(nlohmann::json::array({truth.x, truth.y}));
                                     }
                                     return ++number <= kBefore + 1;
                                   });
        return places.dump() + '\n' + bytes;
      },
      [&](std::uint32_t, const std::string& text) {
        const std::size_t line = text.find('\n');
        const auto places = nlohmann::json::parse(text.substr(0, line));
        pair.from = position(places.at(0));
        pair.to = position(places.at(1));
        const auto* const bytes = reinterpret_cast<const std::uint8_t*>(text.data()) + line + 1;
        std::copy_n(bytes, pair.before.total(), pair.before.begin());
        std::copy_n(bytes + pair.before.total(), pair.after.total(), pair.after.begin());
      },
      context.control.stop);
  if (!whole) throw StudyStopped();
  return pair;
}

/// The L2 distance of the template to the picture after, at every offset of kSearched pixels.
struct Surface {
  cv::Mat1f distance;
  Vector2d lowest;  ///< where in the picture
};

Surface surface_of(const Pair& pair, cv::Point from) {
  const tracking::TemplateGrid grid(kTemplate, kTemplate, kTemplate * kTemplate);
  std::vector<std::uint8_t> wanted(grid.length());
  std::vector<std::uint8_t> seen(grid.length());
  grid.extract(pair.before, from, wanted.data());
  Surface surface;
  surface.distance.create(2 * kSearched + 1, 2 * kSearched + 1);
  for (int y = -kSearched; y <= kSearched; ++y) {
    for (int x = -kSearched; x <= kSearched; ++x) {
      grid.extract(pair.after, from + cv::Point(x, y), seen.data());
      surface.distance(y + kSearched, x + kSearched) =
          static_cast<float>(tracking::distance(wanted, seen));
    }
  }
  cv::Point lowest;
  cv::minMaxLoc(surface.distance, nullptr, nullptr, &lowest, nullptr);
  surface.lowest = {from.x + lowest.x - kSearched, from.y + lowest.y - kSearched};
  return surface;
}

/// Figure 3.5's marks.
void mark(Drawing& drawing, const Vector2d& corner, const Vector2d& from, const Vector2d& truth,
          const std::vector<Vector2d>& found) {
  drawing.cross(from - corner, kBlue)
      .cross(truth - corner, kWhite, 26)
      .circle(found[Three::kLk] - corner, kRed)
      .saltire(found[Three::kLp] - corner, kYellow)
      .star(found[Three::kLpFlock] - corner, kGreen);
}

void draw(const Pair& pair, const Surface& surface, cv::Point from,
          const std::vector<Vector2d>& found, report::Page& page) {
  const Vector2d start(from.x, from.y);
  const Vector2d truth = start + pair.to - pair.from;
  constexpr int kScale = 2;
  constexpr int kSurfaceScale = 10;
  Drawing before(pair.before, kScale);
  before.square(start, 0.5 * kTemplate, kWhite).cross(start, kBlue);
  Drawing after(pair.after, kScale);
  after.square(start, kSearched, kWhite);
  mark(after, Vector2d::Zero(), start, truth, found);
  Drawing cost = Drawing::of_surface(surface.distance, kSurfaceScale);
  mark(cost, start - Vector2d(kSearched, kSearched), start, truth, found);

  const std::vector<std::uint8_t> first = before.png();
  const std::vector<std::uint8_t> second = after.png();
  const std::vector<std::uint8_t> third = cost.png();
  const std::vector<report::Figure> frames = {
      {.bytes = first,
       .caption = "Frame 374: the reference point, and the template of 40 x 40 pixels."},
      {.bytes = second, .caption = "Frame 375, and the part that the cost surface is of."}};
  page.section("Figure 3.5: one jump")
      .paragraph(
          "Blue cross: where the target was. White cross: where it is, as the simulation knows. "
          "Red circle: Lucas-Kanade. Yellow cross: a single predictor. Green star: the flock.")
      .gallery(frames);
  page.section("Figure 3.6: the cost surface")
      .figure({.bytes = third,
               .caption = "L2 distance of the template to frame 375 at every place of the "
                          "rectangle, low is dark."});
}

/// Flocks that differ by their random numbers, on the same jump.
struct Trial {
  double support_range = 0.0;   ///< r_sp
  std::vector<Vector2d> first;  ///< what the first of them, its LP and Lucas-Kanade say
  ErrorCurve errors;            ///< of each of the three, over all flocks
};

Trial try_jump(const Pair& pair, cv::Point from, double support_range, const Random& random) {
  tracking::PredictorConfig config = chapter3::predictor_config();
  config.support_range = support_range;
  config.training_range = 40.0;  // the jump has to lie within it
  const Vector2d start(from.x, from.y);
  const Vector2d truth = start + pair.to - pair.from;
  Trial trial{.support_range = support_range, .first = {}, .errors = ErrorCurve(Three::kCount)};
  std::vector<Vector2d> found(Three::kCount);
  for (std::uint64_t i = 0; i < kFlocks; ++i) {
    Three three(config, kTemplate, random.fork("flock", i));
    three.learn(pair.before, from);
    three.estimate(pair.after, start, found);
    if (i == 0) trial.first = found;
    for (std::size_t e = 0; e < found.size(); ++e) trial.errors[e].add((found[e] - truth).norm());
  }
  return trial;
}

report::Table table_of(const std::vector<Trial>& trials) {
  report::Table table;
  table.columns = {{.heading = "r_sp", .unit = "px", .decimals = 0},
                   {.heading = "LP, mean error", .unit = "px", .decimals = 1},
                   {.heading = "LPs that land", .unit = "%", .decimals = 0, .scale = 100.0},
                   {.heading = "flock, mean error", .unit = "px", .decimals = 1},
                   {.heading = "flocks that land", .unit = "%", .decimals = 0, .scale = 100.0},
                   {.heading = "Lucas-Kanade, error", .unit = "px", .decimals = 1}};
  for (const Trial& trial : trials) {
    const ErrorTally& lp = trial.errors[Three::kLp];
    const ErrorTally& flock = trial.errors[Three::kLpFlock];
    table.rows.push_back({.cells = {trial.support_range, lp.mean(), lp.success(), flock.mean(),
                                    flock.success(), trial.errors[Three::kLk].mean()}});
  }
  return table;
}

}  // namespace

/// Figures 3.5 and 3.6: a jump of 37 pixels, with blur.
StudyResult study_interframe(const StudyContext& context, report::Page& page) {
  const Pair pair = shaken_pair(context);
  const cv::Point from(cvRound(pair.from.x()), cvRound(pair.from.y()));
  const Vector2d jump = pair.to - pair.from;
  const Vector2d truth = Vector2d(from.x, from.y) + jump;
  const Random random = Random(context.scenario.seed).fork("interframe");
  std::vector<Trial> trials;
  for (const double range : {20.0, 30.0, 40.0}) {
    trials.push_back(try_jump(pair, from, range, random));
  }
  const Surface surface = surface_of(pair, from);

  const Trial& wide = trials.back();
  const double lk_error = (wide.first[Three::kLk] - truth).norm();
  const double lp_error = (wide.first[Three::kLp] - truth).norm();
  const double flock_error = (wide.first[Three::kLpFlock] - truth).norm();
  const double surface_error = (surface.lowest - truth).norm();
  const double over_lp = wide.errors[Three::kLpFlock].mean() / wide.errors[Three::kLp].mean();
  StudyResult result;
  result.figures = {{"jump_px", jump.norm()},
                    {"jump_right_px", jump.x()},
                    {"jump_down_px", jump.y()},
                    {"lk_error_px", lk_error},
                    {"lp_error_px", lp_error},
                    {"flock_error_px", flock_error},
                    {"surface_minimum_error_px", surface_error},
                    {"flocks", kFlocks},
                    {"flocks_landed", wide.errors[Three::kLpFlock].success()},
                    {"lps_landed", wide.errors[Three::kLp].success()},
                    {"flock_error_over_lp", over_lp}};
  for (const Trial& trial : trials) {
    const std::string name = fmt::format("r_sp_{:g}", trial.support_range);
    result.figures["mean_flock_error_px"][name] = trial.errors[Three::kLpFlock].mean();
    result.figures["mean_lp_error_px"][name] = trial.errors[Three::kLp].mean();
  }
  result.claims = {
      at_least("jump_px", "3.1.5: the target jumps 37 px", jump.norm(), 36.5),
      at_most("flock_error_px", "Figure 3.5: the flock lands, within 5 px", flock_error,
              ConvergenceTest::kSuccess),
      at_least("lk_error_px", "Figure 3.5: Lucas-Kanade does not", lk_error,
               ConvergenceTest::kSuccess),
      at_most("surface_minimum_error_px", "Figure 3.6: the lowest cost is at the true place",
              surface_error, ConvergenceTest::kSuccess),
      at_most("flock_error_over_lp", "Figure 3.5: the flock does better than a single predictor",
              over_lp, 1.0)};
  draw(pair, surface, from, wide.first, page);
  page.section("Other flocks, other supports")
      .paragraph(fmt::format(
          "{} flocks of {} that differ by their random numbers, and their first predictors; k = "
          "100, N = 150 and r_tr = 40 px, which the jump has to lie within. The thesis does not "
          "say "
          "with which settings it made its figure. With a support of 20 px, as in 3.2.1, little of "
          "what a predictor saw is still in its sight after 37 px; the figures above are of r_sp = "
          "40 px.",
          kFlocks, chapter3::kFlock))
      .table(table_of(trials));
  return result;
}

}  // namespace pacer
