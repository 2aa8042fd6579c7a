// SPDX-License-Identifier: Apache-2.0
#include "scenarios/scenario.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <vector>

#include "core/check.h"
#include "scenarios/yaml_fields.h"

namespace pacer {
namespace {

constexpr std::size_t kLargestFile = 256 * 1024;  // bytes; a scenario is a few kB

const char* name_of(Purpose purpose) {
  switch (purpose) {
    case Purpose::kCollect:
      return "collect";
    case Purpose::kEvaluate:
      return "evaluate";
    case Purpose::kStudy:
      break;
  }
  return "study";
}

YAML::Node parse_yaml(const std::string& text, const std::string& source) {
  try {
    const std::vector<YAML::Node> documents = YAML::LoadAll(text);
    if (documents.size() > 1) {
      throw UsageError(
          fmt::format("{}: holds {} documents, and a scenario is one; remove the lines "
                      "`---`",
                      source, documents.size()));
    }
    return documents.empty() ? YAML::Node() : documents.front();
  } catch (const YAML::Exception& error) {
    throw UsageError(fmt::format("{}:{}: {}", source, error.mark.line + 1, error.msg));
  }
}

/// "a.b=value" as the mapping {a: {b: value}}.
YAML::Node nested(const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw UsageError("--set " + assignment + ": expected key=value, such as seed=7");
  }
  YAML::Node node = parse_yaml(assignment.substr(equals + 1), "--set " + assignment);
  std::string path = assignment.substr(0, equals);
  while (!path.empty()) {
    const std::size_t dot = path.rfind('.');
    YAML::Node outer(YAML::NodeType::Map);
    outer[dot == std::string::npos ? path : path.substr(dot + 1)] = node;
    node = outer;
    path = dot == std::string::npos ? "" : path.substr(0, dot);
  }
  return node;
}

void read(Scenario& scenario, const YAML::Node& node, const std::string& source, Places& places) {
  YamlReader reader(node, source, "", places);
  scenario.fields(reader);
  reader.finish();
}

}  // namespace

void FollowingConfig::validate() const {
  require(duration.count() > 0.0 && duration.count() <= 3600.0,
          "duration_s: must lie in (0, 3600]");
  require(longest_loss.count() > 0.0, "longest_loss_s: must be positive");
  require(nearest >= 0.0 && nearest < farthest, "nearest_m: must lie between 0 and farthest_m");
  require(share_in_range > 0.0 && share_in_range <= 1.0, "share_in_range: must lie in (0, 1]");
}

void ReachingConfig::validate() const {
  require(distance > 0.0 && distance <= 5.0, "distance_m: must lie in (0, 5]");
  require(most_impulses >= 1 && most_impulses <= 10000, "most_impulses: must lie in [1, 10000]");
  require(standstill.count() > 0.0, "standstill_s: must be positive");
}

void KeepingConfig::validate() const {
  require(duration.count() > 0.0 && duration.count() <= 3600.0,
          "duration_s: must lie in (0, 3600]");
  require(most_offset > 0.0 && most_offset <= 1.0, "most_offset_m: must lie in (0, 1]");
  require(least_distance >= 0.0, "least_distance_m: must not be negative");
  require(standstill.count() > 0.0, "standstill_s: must be positive");
}

void RoomSplit::validate() const {
  require(!demonstrated.empty(), "demonstrated: name at least one kind of room");
  require(!unseen.empty(), "unseen: name at least one kind of room");
  for (const std::string& kind : demonstrated) sim::require_room_kind("demonstrated", kind);
  for (const std::string& kind : unseen) {
    sim::require_room_kind("unseen", kind);
    require(std::ranges::find(demonstrated, kind) == demonstrated.end(),
            "unseen: \"" + kind + "\" is demonstrated too");
  }
}

void Scenario::validate() const {
  require(goal == "follow" || goal == "reach" || goal == "keep",
          "goal: expected follow, reach or keep");
  if (car == "simulated") {
    const std::string& layout = simulated.world.layout;
    require(goal != "reach" || layout == "balloons",
            "simulated.world.layout: set it to balloons, which are to be reached");
    require(goal != "keep" || layout == "lane",
            "simulated.world.layout: set it to lane, which is to be kept");
    require(goal != "follow" || layout == "route" || layout == "standing",
            "simulated.world.layout: set it to route or standing, or the goal to " +
                std::string(layout == "lane" ? "keep" : "reach"));
  }
  require(car == "simulated" || car == "replayed", "car: expected simulated or replayed");
  require(car != "replayed" || !replayed.dataset.empty(),
          "replayed.dataset: name the dataset to replay");
  const sim::CameraConfig& camera = simulated.camera;
  require(camera.width % 2 == 0, "simulated.camera.width_px: must be even, as a video's is");
  require(camera.height % 2 == 0, "simulated.camera.height_px: must be even, as a video's is");
  require(simulated.duration.count() * camera.frame_rate_hz >= 1.0,
          "simulated.duration_s: is shorter than one frame");
  (void)simulated_for(Purpose::kCollect);
  (void)simulated_for(Purpose::kEvaluate);
}

Random Scenario::episode_random(Purpose purpose, std::uint64_t index) const {
  return Random(seed).fork(name_of(purpose), index);
}

sim::SimCarConfig Scenario::simulated_for(Purpose purpose) const {
  sim::SimCarConfig config = simulated;
  config.world.room.kinds = purpose == Purpose::kCollect ? rooms.demonstrated : rooms.unseen;
  config.world.room.validate();
  return config;
}

Scenario parse_scenario(const std::string& text, const std::string& source,
                        std::span<const std::string> overrides) {
  Scenario scenario;
  const YAML::Node file = parse_yaml(text, source);
  Places places;
  if (!file.IsNull()) read(scenario, file, source, places);
  for (const std::string& assignment : overrides) {
    read(scenario, nested(assignment), "--set", places);
  }
  FieldChecker(source, "", places).check_all(scenario);
  return scenario;
}

Scenario load_scenario(const std::filesystem::path& file, std::span<const std::string> overrides) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) {
    throw UsageError(file.string() +
                     ": is a folder; name a scenario file, such as "
                     "scenarios/follow.yaml");
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    throw UsageError(fmt::format("{}: {}; name a scenario file, such as scenarios/follow.yaml",
                                 file.string(), std::strerror(errno)));
  }
  std::string text(kLargestFile + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (text.size() > kLargestFile) {
    throw UsageError(file.string() + ": larger than 256 kB, so no scenario");
  }
  if (text.empty()) throw UsageError(file.string() + ": is empty, so no scenario");
  return parse_scenario(text, file.string(), overrides);
}

std::string to_yaml(const Scenario& scenario) {
  Scenario copy = scenario;
  YAML::Emitter out;
  YamlWriter writer(out);
  out << YAML::BeginMap;
  copy.fields(writer);
  out << YAML::EndMap;
  return std::string(out.c_str()) + "\n";
}

}  // namespace pacer
