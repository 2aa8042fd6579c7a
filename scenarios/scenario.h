// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/channels.h"
#include "core/impulse.h"
#include "core/limits.h"
#include "core/random.h"
#include "dataset/video.h"
#include "learning/affordance/config.h"
#include "learning/exemplar/config.h"
#include "scenarios/following.h"
#include "scenarios/keeping.h"
#include "scenarios/reaching.h"
#include "sim/click_teacher.h"
#include "sim/lane_teacher.h"
#include "sim/sim_car.h"
#include "sim/teacher.h"

namespace pacer {

/// Which kinds of room each purpose drives in. A kind that is demonstrated is never unseen.
struct RoomSplit {
  std::vector<std::string> demonstrated = {"living", "office"};
  std::vector<std::string> unseen = {"workshop"};

  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("demonstrated", demonstrated);
    visit("unseen", unseen);
  }
};

/// A recorded episode in the car's place.
struct ReplayedCarConfig {
  std::string dataset;  ///< folder of a recorded dataset
  int episode = 0;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("dataset", dataset);
    visit("episode", episode);
  }
};

/// What the car is to do: which teacher shows it, how it is driven and how that is scored.
enum class Goal : std::uint8_t {
  kFollow,  ///< the lead vehicle, a command a frame (chapter 6)
  kReach,   ///< the red balloon, by impulses (chapter 5)
  kKeep,    ///< its lane, a command a frame
};

/// What an episode is driven for. Each has seeds, and rooms, of its own: nothing that is scored
/// can have been demonstrated.
enum class Purpose : std::uint8_t { kCollect, kEvaluate, kStudy };

/// One run, whole: which car, what it may do, who teaches, how it is learnt and scored, and the
/// one seed that all chance comes from. One YAML file each.
struct Scenario {
  std::string name = "unnamed";
  std::string task = "Follow the lead vehicle.";  ///< recorded with every episode
  std::uint64_t seed = 1;
  std::string goal = "follow";    ///< follow, reach or keep
  std::string car = "simulated";  ///< simulated or replayed: the switch
  Limits limits;
  Channels channels;
  RoomSplit rooms;
  sim::SimCarConfig simulated;
  ReplayedCarConfig replayed;
  sim::TeacherConfig teacher;             ///< of following
  sim::ClickTeacherConfig click_teacher;  ///< of reaching
  sim::LaneTeacherConfig lane_teacher;    ///< of keeping
  ImpulseConfig impulses;                 ///< of reaching
  affordance::AffordanceConfig affordance;
  exemplar::ExemplarConfig exemplar;
  FollowingConfig following;
  ReachingConfig reaching;
  KeepingConfig keeping;
  dataset::VideoSettings video;  ///< of recorded datasets

  /// Throws std::invalid_argument for what no section can see alone.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("name", name);
    visit("task", task);
    visit("seed", seed);
    visit("goal", goal);
    visit("car", car);
    visit("limits", limits);
    visit("channels", channels);
    visit("rooms", rooms);
    visit("simulated", simulated);
    visit("replayed", replayed);
    visit("teacher", teacher);
    visit("click_teacher", click_teacher);
    visit("lane_teacher", lane_teacher);
    visit("impulses", impulses);
    visit("affordance", affordance);
    visit("exemplar", exemplar);
    visit("following", following);
    visit("reaching", reaching);
    visit("keeping", keeping);
    visit("video", video);
  }

  [[nodiscard]] Goal what_for() const {
    if (goal == "keep") return Goal::kKeep;
    return goal == "reach" ? Goal::kReach : Goal::kFollow;
  }

  /// All chance of one episode.
  [[nodiscard]] Random episode_random(Purpose purpose, std::uint64_t index) const;

  /// The simulated car's config with the rooms that `purpose` drives in.
  [[nodiscard]] sim::SimCarConfig simulated_for(Purpose purpose) const;
};

/// Defaults, then the file, then `overrides`, each "key.key=value" as after --set.
/// Throws UsageError as "file:line: key: what is wrong", for an unknown key too.
[[nodiscard]] Scenario load_scenario(const std::filesystem::path& file,
                                     std::span<const std::string> overrides = {});

/// The same from text, which `source` names in errors.
[[nodiscard]] Scenario parse_scenario(const std::string& text, const std::string& source,
                                      std::span<const std::string> overrides = {});

/// The scenario with every value written out: defaults may change, a recorded run may not.
[[nodiscard]] std::string to_yaml(const Scenario& scenario);

}  // namespace pacer
