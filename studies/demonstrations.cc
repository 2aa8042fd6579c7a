// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <span>
#include <string>
#include <vector>

#include "dataset/reader.h"
#include "runs/report/charts.h"
#include "studies/materials.h"
#include "studies/straight_line.h"
#include "studies/studies.h"

namespace pacer {
namespace {

/// The lead's pose in the picture, as a detector would give it, and what the teacher did: a value
/// a frame.
struct Poses {
  std::vector<double> x, y, width, height;  // pixels; x and y of its box's middle
  std::vector<double> steering, throttle;   // stick

  void add(std::span<const double> box, std::span<const double> action) {
    x.push_back(0.5 * (box[0] + box[2]));
    y.push_back(0.5 * (box[1] + box[3]));
    width.push_back(box[2] - box[0]);
    height.push_back(box[3] - box[1]);
    steering.push_back(action[0]);
    throttle.push_back(action[1]);
  }
  [[nodiscard]] std::size_t count() const { return x.size(); }
};

/// Frames that show something of the lead, and those that do not, whose pose is null (6.2).
struct Demonstrated {
  Poses seen;
  Poses unseen;
};

Demonstrated demonstrated(const dataset::Dataset& drives) {
  Demonstrated all;
  constexpr std::array<double, 4> kNull{};
  for (std::size_t episode = 0; episode < drives.episodes().size(); ++episode) {
    dataset::EpisodeReader reader(drives, episode,
                                  {"action", "privileged.lead_box", "privileged.lead_visible"},
                                  dataset::EpisodeReader::Frames::kLeave);
    while (const dataset::RecordedStep* step = reader.next()) {
      const auto action = step->values.first(2);
      const bool seen = step->values[6] > 0.0;
      (seen ? all.seen : all.unseen)
          .add(seen ? step->values.subspan(2, 4) : std::span<const double>(kNull), action);
    }
  }
  return all;
}

using Column = std::vector<double> Poses::*;

/// One value against another, of every fifth frame: neighbours say the same.
report::Chart scatter(const Demonstrated& all, Column x, const report::Axis& x_axis, Column y,
                      const report::Axis& y_axis, const std::string& caption) {
  constexpr std::size_t kEvery = 5;
  const std::vector<std::string> names = {"in view", "not in view"};
  std::vector<report::Cloud> clouds;
  for (const Poses* poses : {&all.seen, &all.unseen}) {
    report::Cloud& cloud =
        clouds.emplace_back(report::Cloud{.name = names[clouds.size()], .x = {}, .y = {}});
    for (std::size_t i = 0; i < poses->count(); i += kEvery) {
      cloud.x.push_back((poses->*x)[i]);
      cloud.y.push_back((poses->*y)[i]);
    }
  }
  return {.spec = report::scatter_chart(clouds, x_axis, y_axis, report::Palette(names)),
          .caption = caption};
}

void add_page(const Demonstrated& all, const StraightLine& turn, report::Page& page) {
  const report::Axis x{.title = "horizontal position", .unit = "px"};
  const report::Axis y{.title = "vertical position", .unit = "px"};
  const report::Axis width{.title = "width", .unit = "px"};
  const report::Axis height{.title = "height", .unit = "px"};
  const std::vector<report::Chart> poses = {
      scatter(all, &Poses::x, x, &Poses::y, y, "Where the lead is in the picture."),
      scatter(all, &Poses::x, x, &Poses::height, height, "Where, and how large."),
      scatter(all, &Poses::y, y, &Poses::height, height, "The nearer, the lower and the larger."),
      scatter(
          all, &Poses::width, width, &Poses::height, height,
          "Width and height; the picture's edge cuts boxes, and a car is wider from the side.")};
  page.section("The lead's pose (Figure 6.5)")
      .paragraph(
          "The four values of the box about the lead in each demonstrated frame. Where nothing of "
          "it is to be seen the pose is null, as the thesis's non-detections are.")
      .charts(poses);
  const std::vector<report::Chart> actions = {
      scatter(all, &Poses::x, x, &Poses::steering,
              {.title = "steering", .unit = "stick, + is left"},
              fmt::format("Figure 6.6. Least squares: {:.2f} stick a hundred pixels.",
                          100.0 * turn.slope)),
      scatter(all, &Poses::height, height, &Poses::throttle, {.title = "throttle", .unit = "stick"},
              "The smaller it looks, the faster.")};
  page.section("Pose and action (Figure 6.6)")
      .paragraph(
          "What the teacher does against what it sees in the same frame. It answers a fifth of a "
          "second later, and what it does then goes to the width of the clouds.")
      .charts(actions);
}

}  // namespace

/// Figures 6.5 and 6.6: where the lead is in the demonstrated pictures, and what is done about it.
StudyResult study_demonstrations(const StudyContext& context, report::Page& page) {
  const Materials materials(context);
  const std::uint64_t episodes = materials.five_minutes();
  const dataset::Dataset drives(materials.recording(Purpose::kCollect, episodes));
  const Demonstrated all = demonstrated(drives);
  const Poses& seen = all.seen;
  const StraightLine turn = fit_straight_line(seen.x, seen.steering);
  const StraightLine drive = fit_straight_line(seen.height, seen.throttle);
  const StraightLine box = fit_straight_line(seen.width, seen.height);
  const std::size_t frames = seen.count() + all.unseen.count();

  StudyResult result;
  // To the left is less x and more stick.
  result.figures = {
      {"steering_correlation", -turn.correlation},
      {"steering_per_100_px", -100.0 * turn.slope},
      {"throttle_correlation", -drive.correlation},
      {"width_height_correlation", box.correlation},
      {"not_in_view", static_cast<double>(all.unseen.count()) / static_cast<double>(frames)},
      {"frames", frames},
      {"episodes", episodes}};
  constexpr double kStrong = 0.7;  // half of the variance
  result.claims = {
      at_least("steering_correlation",
               "Figure 6.6: steering goes with the lead's horizontal position, nearly linearly",
               -turn.correlation, kStrong),
      at_least("width_height_correlation", "Figure 6.5: its width and height go together",
               box.correlation, kStrong)};
  add_page(all, turn, page);
  return result;
}

}  // namespace pacer
