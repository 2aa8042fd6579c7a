// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "runs/policy_source.h"
#include "studies/drawing.h"
#include "studies/materials.h"
#include "studies/studies.h"
#include "studies/trials.h"

namespace pacer {
namespace {

using Eigen::Vector2d;
using nlohmann::json;

// Metres between the cars' middles. Demonstrations show the lead at about 1.3 m; from 1.8 m on next
// to no rule matches.
constexpr std::array<double, 3> kDistances = {1.1, 1.3, 1.5};
constexpr std::array<double, 3> kBearings = {20.0, 0.0, -20.0};  // degrees: left, middle, right
constexpr std::array<const char*, 3> kSides = {"left", "middle", "right"};
constexpr Seconds kDuration{15.0};
constexpr double kNearer = 0.1;  // metres that it has to come nearer
constexpr std::size_t kRooms = 3;
constexpr double kRest = 0.03;  // m/s
constexpr std::size_t kCases = kDistances.size() * kBearings.size();

/// How one drive to a lead that stands went.
struct Approach {
  std::size_t room = 0;
  double distance = 0.0;  // metres between the middles, at the start
  std::size_t side = 0;
  double end_distance = 0.0;  // metres between the middles
  bool collided = false;
  bool rests = false;          // for the last second
  bool ahead = false;          // the lead is, at the end
  std::vector<Vector2d> path;  // of the car's middle
  Vector2d lead = Vector2d::Zero();
  double lead_yaw = 0.0;

  [[nodiscard]] bool approached() const { return distance - end_distance >= kNearer; }
  [[nodiscard]] bool stopped_short() const { return approached() && rests && ahead && !collided; }
};

/// Notes where the car goes.
class Path final : public StepSink {
 public:
  explicit Path(const sim::SimCar& car) : car_(car) {}

  [[nodiscard]] bool write(const Frame& frame, const Step&) override {
    const sim::Privileged& truth = car_.truth();
    if (frame.index % 5 == 0) approach.path.push_back(truth.car_pose.position);
    approach.collided = approach.collided || truth.collision;
    if (std::abs(truth.car_speed) > kRest) moved_at_ = frame.time;
    approach.rests = frame.time - moved_at_ >= Seconds{1.0};
    approach.lead = truth.lead_pose.position;
    approach.lead_yaw = truth.lead_pose.yaw;
    const Vector2d towards = approach.lead - truth.car_pose.position;
    approach.end_distance = towards.norm();
    approach.ahead =
        towards.dot(Vector2d(std::cos(truth.car_pose.yaw), std::sin(truth.car_pose.yaw))) > 0.0;
    return !approach.collided;
  }

  Approach approach;

 private:
  const sim::SimCar& car_;
  Seconds moved_at_{};
};

struct Case {
  std::size_t room, distance, side;
};
Case case_of(std::size_t index) {
  return {.room = index / kCases % kRooms,
          .distance = index % kCases / kBearings.size(),
          .side = index % kBearings.size()};
}

/// What all cases of one room share: the room, of the kind that nothing was demonstrated in.
Random room_random(const Scenario& scenario, std::size_t room) {
  return scenario.episode_random(Purpose::kStudy, room).fork("standing-lead");
}

sim::SimCarConfig config_of(const Scenario& scenario, const Case& which) {
  sim::SimCarConfig config = scenario.simulated_for(Purpose::kStudy);
  config.duration = kDuration;
  config.world.layout = "standing";
  config.world.standing_lead.distance = kDistances.at(which.distance);
  config.world.standing_lead.bearing = kBearings.at(which.side);
  return config;
}

Approach approach(const Scenario& scenario, const PolicySource& source, std::size_t index) {
  const Case which = case_of(index);
  const Random random = room_random(scenario, which.room);
  sim::SimCar car(config_of(scenario, which), random.fork("car"));
  const std::unique_ptr<Policy> policy = source.make(scenario, &car, random.fork("policy"));
  Path path(car);
  drive(car, *policy, scenario.limits, scenario.channels, path);
  return path.approach;
}

json to_json(const Approach& approach) {
  json path = json::array();
  for (const Vector2d& at : approach.path) path.push_back({at.x(), at.y()});
  return {{"end_distance", approach.end_distance},
          {"collided", approach.collided},
          {"rests", approach.rests},
          {"ahead", approach.ahead},
          {"lead", {approach.lead.x(), approach.lead.y(), approach.lead_yaw}},
          {"path", path}};
}

Vector2d point(const json& value) { return {value[0].get<double>(), value[1].get<double>()}; }

Approach approach_from(const json& value, std::size_t index) {
  const Case which = case_of(index);
  Approach approach{.room = which.room,
                    .distance = kDistances.at(which.distance),
                    .side = which.side,
                    .end_distance = value["end_distance"],
                    .collided = value["collided"],
                    .rests = value["rests"],
                    .ahead = value["ahead"],
                    .path = {},
                    .lead_yaw = value["lead"][2]};
  approach.lead = point(value["lead"]);
  for (const json& at : value["path"]) approach.path.push_back(point(at));
  return approach;
}

/// Seen from above, the room's obstacles dark.
class Plan {
 public:
  explicit Plan(const sim::RoomPlan& plan) : half_(plan.half_extent), drawing_(floor(plan), 1) {}

  void draw(const Approach& approach) {
    constexpr std::array<Ink, 3> kInks = {kBlue, kGreen, kRed};  // by side
    const Ink ink = kInks.at(approach.side);
    for (std::size_t i = 1; i < approach.path.size(); ++i) {
      drawing_.line(at(approach.path[i - 1]), at(approach.path[i]), ink);
    }
    drawing_.circle(at(approach.path.front()), ink, 4);
    constexpr double kHalfLength = 0.2;  // metres, of the lead
    const Vector2d ahead(std::cos(approach.lead_yaw), std::sin(approach.lead_yaw));
    drawing_.line(at(approach.lead - kHalfLength * ahead), at(approach.lead + kHalfLength * ahead),
                  approach.stopped_short() ? kYellow : kWhite);
  }
  [[nodiscard]] std::vector<std::uint8_t> png() const { return drawing_.png(); }

 private:
  static constexpr double kPixels = 60.0;  // a metre

  /// y is up in the picture, as x is to the right.
  [[nodiscard]] static Vector2d pixel(const Vector2d& half, const Vector2d& place) {
    return kPixels * Vector2d(place.x() + half.x(), half.y() - place.y());
  }
  [[nodiscard]] Vector2d at(const Vector2d& place) const { return pixel(half_, place); }

  static cv::Mat1b floor(const sim::RoomPlan& plan) {
    constexpr int kFree = 205, kTaken = 95;  // grey
    cv::Mat1b grey(static_cast<int>(2.0 * kPixels * plan.half_extent.y()),
                   static_cast<int>(2.0 * kPixels * plan.half_extent.x()), std::uint8_t{kFree});
    for (const sim::Footprint& obstacle : plan.obstacles) {
      const Vector2d along(std::cos(obstacle.yaw), std::sin(obstacle.yaw));
      const Vector2d across(-along.y(), along.x());
      std::vector<cv::Point> corners;
      for (const auto& [a, b] : {std::pair{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}) {
        const Vector2d corner =
            pixel(plan.half_extent,
                  obstacle.centre + a * obstacle.half.x() * along + b * obstacle.half.y() * across);
        corners.emplace_back(cvRound(corner.x()), cvRound(corner.y()));
      }
      cv::fillConvexPoly(grey, corners, cv::Scalar(kTaken));
    }
    return grey;
  }

  Vector2d half_;
  Drawing drawing_;
};

/// The plan of the room in which the cases of `room` were driven.
sim::RoomPlan plan_of(const Scenario& scenario, std::size_t room) {
  const sim::SimCar car(config_of(scenario, case_of(room * kCases)),
                        room_random(scenario, room).fork("car"));
  return car.world().plan();
}

double share(const std::vector<Approach>& approaches, bool (Approach::*has)() const) {
  const auto count =
      std::ranges::count_if(approaches, [&](const Approach& one) { return (one.*has)(); });
  return static_cast<double>(count) / static_cast<double>(approaches.size());
}

report::Table table_of(const std::vector<Approach>& learned, const std::vector<Approach>& teacher) {
  report::Table table;
  table.columns = {{.heading = "room", .decimals = 0},
                   {.heading = "lead"},
                   {.heading = "at the start", .unit = "m", .decimals = 1},
                   {.heading = "at the end", .unit = "m"},
                   {.heading = "drives towards it"},
                   {.heading = "stops short of it"},
                   {.heading = "the teacher, at the end", .unit = "m"}};
  const auto verdict = [](bool holds) {
    return holds ? report::Verdict::kHolds : report::Verdict::kShort;
  };
  for (std::size_t i = 0; i < learned.size(); ++i) {
    const Approach& one = learned[i];
    table.rows.push_back({.cells = {static_cast<double>(one.room + 1), kSides.at(one.side),
                                    one.distance, one.end_distance, verdict(one.approached()),
                                    verdict(one.stopped_short()), teacher[i].end_distance}});
  }
  return table;
}

}  // namespace

/// Figure 6.16: a lead that stands to the left, in the middle, to the right.
StudyResult study_standing_lead(const StudyContext& context, report::Page& page) {
  const Scenario& scenario = context.scenario;
  const Materials materials(context);
  const std::string model = materials.model(materials.five_minutes()).string();
  const std::vector<PolicySource> sources = PolicySource::load({model, "teacher"});
  const std::size_t cases = kCases * kRooms;
  const std::vector<json> results =
      run_trials(context, static_cast<std::uint32_t>(sources.size() * cases), "drives",
                 [&](std::uint32_t index) {
                   return to_json(approach(scenario, sources[index / cases], index % cases));
                 });
  std::vector<Approach> learned, teacher;
  for (std::size_t i = 0; i < cases; ++i) {
    learned.push_back(approach_from(results[i], i));
    teacher.push_back(approach_from(results[cases + i], i));
  }

  report::Content& section = page.section("Seen from above");
  section.paragraph(
      "Where the car drove: a circle where it started; blue, green and red where the lead stood to "
      "the left, in the middle and to the right of its picture. The lead is a bar: yellow where "
      "the car came to rest short of it.");
  for (std::size_t room = 0; room < kRooms; ++room) {
    Plan plan(plan_of(scenario, room));
    for (std::size_t i = room * kCases; i < (room + 1) * kCases; ++i) plan.draw(learned[i]);
    section.figure({.bytes = plan.png(), .caption = fmt::format("Room {}.", room + 1)});
  }
  page.section("Drives").table(table_of(learned, teacher));

  std::vector<double> ends;
  double collisions = 0.0;
  for (const Approach& one : learned) {
    ends.push_back(one.end_distance);
    collisions += one.collided ? 1.0 : 0.0;
  }
  const double approached = share(learned, &Approach::approached);
  const double stopped = share(learned, &Approach::stopped_short);
  StudyResult result;
  const double teacher_stopped = share(teacher, &Approach::stopped_short);
  result.figures = {{"approached", approached},
                    {"stopped_short", stopped},
                    {"collisions", collisions},
                    {"end_distance_m", report::mean(ends).value},
                    {"nearest_end_m", std::ranges::min(ends)},
                    {"teacher_approached", share(teacher, &Approach::approached)},
                    {"teacher_stopped_short", teacher_stopped},
                    {"drives", cases}};
  result.claims = {
      at_least("approached", "6.16: drives towards it", approached, 1.0),
      at_least("stopped_short", "6.16: drives towards it, slows down and stops short of it",
               stopped, 1.0),
      at_most("collisions", "touches nothing", collisions, 0.0),
      at_least("teacher_stopped_short", "the teacher shows no less", teacher_stopped, 1.0)};
  return result;
}

}  // namespace pacer
