// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/random.h"
#include "core/units.h"
#include "sim/camera_mount.h"
#include "sim/draught.h"
#include "sim/lane_boards.h"
#include "sim/lead_driver.h"
#include "sim/livery.h"
#include "sim/person.h"
#include "sim/placement.h"
#include "sim/room.h"
#include "sim/route.h"
#include "sim/standing_lead.h"
#include "sim/vehicle.h"

namespace pacer::sim {

/// What there is, and how it varies from episode to episode.
struct WorldConfig {
  bool furnished = true;              ///< false: a bare floor of the room's size
  bool lead = true;                   ///< false: the car is alone
  std::string lead_body = "vehicle";  ///< what is followed looks like: vehicle or person
  bool balloons = true;               ///< a red and a green one
  /// Where the car starts and what stands where. `route`: on the lead's way, the balloons out of
  /// the way. `standing`: the lead never moves; it is where `standing_lead` says. `balloons`: as
  /// `placement` says, the balloons in the open. `lane`: in the lane that `lane` describes, the
  /// balloons out of the way.
  std::string layout = "route";
  StandingLeadConfig standing_lead;
  PlacementConfig placement;
  LaneConfig lane;
  Range draught{0.002, 0.006};  ///< newtons, the most that moving air pushes a balloon with
  RoomConfig room;
  VehicleConfig car;
  VehicleConfig lead_car;
  LiveryConfig livery;
  RouteConfig route;
  LeadDriverConfig lead_driver;
  CameraMountConfig mount;

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  [[nodiscard]] bool follows_a_person() const { return lead && lead_body == "person"; }
  [[nodiscard]] bool balloons_in_the_open() const { return layout == "balloons"; }
  [[nodiscard]] bool has_a_lane() const { return layout == "lane"; }

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("furnished", furnished);
    visit("lead", lead);
    visit("lead_body", lead_body);
    visit("balloons", balloons);
    visit("layout", layout);
    visit("standing_lead", standing_lead);
    visit("placement", placement);
    visit("lane", lane);
    visit("draught_n", draught);
    visit("room", room);
    visit("car", car);
    visit("lead_car", lead_car);
    visit("livery", livery);
    visit("route", route);
    visit("lead_driver", lead_driver);
    visit("mount", mount);
  }
};

/// One episode's world: a room, the car that is driven ("car/...", with its camera "car/driver"),
/// and the lead ("lead/...") with its driver. It knows nothing of frames and delays.
class World {
 public:
  /// `time_step` of the physics; `fovy` of the camera, degrees. Throws std::runtime_error when no
  /// room and route come together.
  World(const WorldConfig& config, Seconds time_step, double fovy, const Random& random);

  /// Brings positions, velocities and contacts up to date with the present state. Everything below
  /// may be asked for after it, and before advance().
  void observe();
  /// One time step on, with what the car's receiver gets now. Throws std::runtime_error when the
  /// physics has become unstable.
  void advance(const Pulses& pulses);

  [[nodiscard]] const mjModel& model() const noexcept { return *model_; }
  [[nodiscard]] mjData& data() noexcept { return *data_; }
  [[nodiscard]] const mjData& data() const noexcept { return *data_; }
  [[nodiscard]] const RoomPlan& plan() const noexcept { return plan_; }
  /// The lead's way, whether or not there is a lead; empty unless the layout is `route`.
  [[nodiscard]] const Route& route() const noexcept { return route_; }
  [[nodiscard]] int camera() const noexcept { return camera_; }
  [[nodiscard]] const Vehicle& car() const noexcept { return *car_; }
  /// nullptr where there is none.
  [[nodiscard]] const Vehicle* lead() const noexcept { return lead_ ? &*lead_ : nullptr; }

  /// Empty where the layout has none.
  [[nodiscard]] const Lane& lane() const noexcept { return lane_; }
  /// That stand along the lane.
  [[nodiscard]] const std::vector<Board>& boards() const noexcept { return boards_; }

  static constexpr const char* kCamera = "car/driver";

 private:
  struct Delete {
    void operator()(mjSpec* spec) const noexcept { mj_deleteSpec(spec); }
    void operator()(mjModel* model) const noexcept { mj_deleteModel(model); }
    void operator()(mjData* data) const noexcept { mj_deleteData(data); }
  };
  using Spec = std::unique_ptr<mjSpec, Delete>;

  [[nodiscard]] Spec furnish(const WorldConfig& config, const Random& random);
  void put_on_lane(const WorldConfig& config, mjSpec& spec, const Random& room);
  void lay_out(const WorldConfig& config, mjSpec& spec, const Random& room);
  void compile(mjSpec& spec);
  void settle(const WorldConfig& config);
  [[nodiscard]] Pulses drive_lead();

  RoomPlan plan_;
  Route route_;
  Lane lane_;
  std::vector<Board> boards_;
  FloorPose start_;       // of the car
  FloorPose lead_start_;  // of the lead, where there is one
  std::unique_ptr<mjModel, Delete> model_;
  std::unique_ptr<mjData, Delete> data_;
  int camera_ = -1;
  std::optional<Vehicle> car_;
  std::optional<Vehicle> lead_;
  std::optional<LeadDriver> lead_driver_;  // none where the lead stands
  std::optional<Gait> gait_;               // where the lead is a person
  std::optional<Draught> draught_;
  Pulses lead_pulses_;
  std::int64_t step_ = 0;
  std::int64_t lead_period_ = 1;  // steps between two decisions of the lead's driver
};

}  // namespace pacer::sim
