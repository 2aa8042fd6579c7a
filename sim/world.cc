// SPDX-License-Identifier: Apache-2.0
#include "sim/world.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/channels.h"
#include "core/check.h"
#include "sim/balloon.h"

namespace pacer::sim {
namespace {

constexpr const char* kFloor = "floor";  // build_room's name for it
constexpr int kRooms = 6;                // tried before a world is given up
constexpr Seconds kSettle{0.25};         // until the cars stand still on their wheels
constexpr Seconds kLeadReaction{0.04};   // between two decisions of the lead's driver

/// Fast and stable for wheels on a floor: an elliptic cone, stiffer along the floor than across it,
/// keeps tyres from creeping.
void choose_physics(mjOption& option, Seconds time_step) {
  option.timestep = time_step.count();
  option.integrator = mjINT_IMPLICITFAST;
  option.cone = mjCONE_ELLIPTIC;
  option.impratio = 5.0;
}

/// A floor with a pattern, and light from above.
RoomPlan bare_room(mjSpec& spec, const RoomConfig& config) {
  const Eigen::Vector2d half{0.5 * config.length.middle(), 0.5 * config.width.middle()};
  mjsBody* const world = mjs_findBody(&spec, "world");
  mjsTexture* const texture = mjs_addTexture(&spec, nullptr);
  mjs_setName(texture->element, "bare_floor");
  texture->type = mjTEXTURE_2D;
  texture->builtin = mjBUILTIN_CHECKER;
  texture->width = texture->height = 128;
  std::ranges::fill(texture->rgb1, 0.62);
  std::ranges::fill(texture->rgb2, 0.45);
  mjsMaterial* const material = mjs_addMaterial(&spec, nullptr);
  mjs_setName(material->element, "bare_floor");
  mjs_setInStringVec(material->textures, mjTEXROLE_RGB, "bare_floor");
  material->texrepeat[0] = material->texrepeat[1] = 2.0F;
  material->texuniform = 1;
  mjsGeom* const floor = mjs_addGeom(world, nullptr);
  mjs_setName(floor->element, kFloor);
  floor->type = mjGEOM_PLANE;
  floor->size[0] = half.x();
  floor->size[1] = half.y();
  floor->size[2] = 1.0;
  mjs_setString(floor->material, "bare_floor");
  mjsLight* const light = mjs_addLight(world, nullptr);
  light->pos[2] = 3.0;
  light->castshadow = 0;
  return {.kind = "bare", .half_extent = half, .obstacles = {}};
}

/// Out of the way, where nothing is driven but much is seen: near walls and furniture.
std::array<Eigen::Vector2d, 2> balloon_places(const RoomPlan& plan, Random random) {
  constexpr double kFree = 0.24;  // metres about a tether: a balloon and its sway
  constexpr double kOpen = 0.40;  // metres: beyond, it would stand in the open
  constexpr double kApart = 1.0;  // metres between the two
  std::array<Eigen::Vector2d, 2> places;
  for (std::size_t i = 0; i < places.size(); ++i) {
    double best = -1.0;
    for (int attempt = 0; attempt < 400; ++attempt) {
      const Eigen::Vector2d place{random.uniform(-plan.half_extent.x(), plan.half_extent.x()),
                                  random.uniform(-plan.half_extent.y(), plan.half_extent.y())};
      if (i > 0 && (place - places[0]).norm() < kApart) continue;
      const double free = clearance(plan, place);
      const bool fits = free >= kFree && free <= kOpen;
      if (fits || free > best) {
        places.at(i) = place;
        best = free;
      }
      if (fits) break;
    }
  }
  return places;
}

/// What the lead's chassis carries is longer or taller than the chassis's own outline.
void fit_outline(mjSpec& spec, const LeadShell& shell) {
  mjsGeom* const outline = mjs_asGeom(mjs_findElement(&spec, mjOBJ_GEOM, "lead/outline"));
  check(outline != nullptr, "models/car.xml has a geom named outline");
  const double bottom = outline->pos[2] - outline->size[2];
  outline->pos[0] = 0.5 * (shell.front + shell.rear);
  outline->pos[2] = 0.5 * (shell.roof + bottom);
  outline->size[0] = 0.5 * (shell.front - shell.rear);
  outline->size[1] = shell.half_width;
  outline->size[2] = 0.5 * (shell.roof - bottom);
}

}  // namespace

void WorldConfig::validate() const {
  draught.validate("draught_n", 0.0, 0.03);
  require(layout == "route" || layout == "standing" || layout == "balloons" || layout == "lane",
          "layout: must be route, standing, balloons or lane");
  require(layout != "balloons" || balloons, "balloons: the layout asks for them");
  require(layout == "route" || layout == "standing" || !lead,
          "lead: only the layouts route and standing have a place for one");
  require(layout != "standing" || lead, "lead: the layout asks for one");
  require(lead_body == "vehicle" || lead_body == "person", "lead_body: must be vehicle or person");
  standing_lead.validate();
  placement.validate();
  lane.validate();
  livery.validate();
  room.validate();
  car.validate();
  lead_car.validate();
  route.validate();
  lead_driver.validate();
  mount.validate();
}

World::World(const WorldConfig& config, Seconds time_step, double fovy, const Random& random) {
  const Spec spec = furnish(config, random);
  choose_physics(spec->option, time_step);

  const Random car_random = random.fork("car");
  const Random lead_random = random.fork("lead");
  add_vehicle(*spec, "car/", kFloor, config.car, car_random);
  mjsCamera* const camera = mjs_asCamera(mjs_findElement(spec.get(), mjOBJ_CAMERA, kCamera));
  check(camera != nullptr, "models/car.xml has a camera named driver");
  mount_camera(*camera, config.mount, random.fork("mount"));
  camera->fovy = fovy;
  if (config.lead) {
    mjsBody* const lead = add_vehicle(*spec, "lead/", kFloor, config.lead_car, lead_random);
    const Random design(config.livery.design);
    if (config.follows_a_person()) {
      add_person(*spec, *lead, "lead/", design, config.livery);
      fit_outline(*spec, kPersonOutline);
    } else {
      dress_lead(*spec, *lead, design, config.livery);
      fit_outline(*spec, {});
    }
  }

  compile(*spec);
  camera_ = mj_name2id(model_.get(), mjOBJ_CAMERA, kCamera);
  car_.emplace(*model_, "car/", config.car, car_random);
  if (config.lead) {
    lead_.emplace(*model_, "lead/", config.lead_car, lead_random);
    if (config.layout == "route") lead_driver_.emplace(config.lead_driver, route_);
    if (config.follows_a_person()) gait_.emplace(*model_, "lead/");
    lead_period_ = std::max(1L, std::lround(kLeadReaction / time_step));
  }
  Random air = random.fork("air");
  draught_.emplace(*model_, config.draught.draw(air), random.fork("draught"));
  settle(config);
}

World::Spec World::furnish(const WorldConfig& config, const Random& random) {
  for (int attempt = 0;; ++attempt) {
    Spec spec{mj_makeSpec()};
    const Random room = random.fork("room", static_cast<std::uint64_t>(attempt));
    plan_ = config.furnished ? build_room(*spec, config.room, room) : bare_room(*spec, config.room);
    try {
      lay_out(config, *spec, room);
      return spec;
    } catch (const std::runtime_error&) {
      if (attempt + 1 == kRooms) throw;  // this room is too crowded: the next one
    }
  }
}

void World::lay_out(const WorldConfig& config, mjSpec& spec, const Random& room) {
  const auto hang = [&](const std::array<Eigen::Vector2d, 2>& places, const Range& height) {
    const std::vector<Footprint> taken = add_balloons(spec, places, height, room.fork("balloons"));
    plan_.obstacles.insert(plan_.obstacles.end(), taken.begin(), taken.end());
  };
  if (config.balloons_in_the_open()) {
    const Placement placement = place_for_reaching(config.placement, plan_, room);
    start_ = placement.car;
    hang({placement.red, placement.green}, config.placement.height);
    return;
  }
  if (config.balloons) {
    hang(balloon_places(plan_, room.fork("balloon_places")), {0.34, 0.55});
  }
  if (config.has_a_lane()) {
    put_on_lane(config, spec, room);
    return;
  }
  if (config.layout == "standing") {
    const StandingPlaces places = place_standing(config.standing_lead, plan_, room);
    start_ = places.car;
    lead_start_ = places.lead;
    return;
  }
  if (!config.furnished && !config.lead) return;
  route_ = plan_route(config.route, plan_, room.fork("route"));
  start_ = route_.follower_start();
  lead_start_ = route_.lead_start();
}

void World::put_on_lane(const WorldConfig& config, mjSpec& spec, const Random& room) {
  lane_ = lay_lane(config.lane, plan_, room.fork("course"));
  boards_ = stand_boards(lane_, config.lane.spacing);
  mark_lane(spec, lane_, boards_, Random(config.livery.design), config.livery);
  Random put = room.fork("start");
  const double along = put.uniform(0.0, lane_.length());
  start_.position = lane_.beside(along, config.lane.start_aside.draw(put));
  start_.yaw = lane_.at(along).yaw + config.lane.start_turn.draw(put) * std::numbers::pi / 180.0;
}

void World::compile(mjSpec& spec) {
  model_.reset(mj_compile(&spec, nullptr));
  if (!model_) {
    throw std::runtime_error("the simulated room does not compile: " +
                             std::string(mjs_getError(&spec)));
  }
  // MuJoCo would write warnings to a file in the working folder; advance() reads their counts. A
  // handler that the program has set stays.
  static const bool quiet = [] {
    if (mju_user_warning == nullptr) mju_user_warning = [](const char*) {};
    return true;
  }();
  (void)quiet;
  data_.reset(mj_makeData(model_.get()));
  if (!data_) throw std::runtime_error("no memory for the simulation of one room");
}

void World::settle(const WorldConfig& config) {
  car_->place(*data_, start_);
  if (config.lead) lead_->place(*data_, lead_start_);
  for (Seconds past{}; past < kSettle; past += Seconds{model_->opt.timestep}) {
    mj_step(model_.get(), data_.get());
  }
}

void World::observe() { mj_step1(model_.get(), data_.get()); }

void World::advance(const Pulses& pulses) {
  draught_->blow(*data_);
  car_->actuate(*data_, pulses);
  if (lead_) {
    if (step_ % lead_period_ == 0) lead_pulses_ = drive_lead();
    lead_->actuate(*data_, lead_pulses_);
    if (gait_) gait_->step(*data_, lead_->speed(*data_));
  }
  mj_step2(model_.get(), data_.get());
  ++step_;
  for (const mjtWarning kind : {mjWARN_BADQPOS, mjWARN_BADQVEL, mjWARN_BADQACC}) {
    if (data_->warning[kind].number > 0) {
      throw std::runtime_error("the simulation became unstable: " +
                               std::string(mju_warningText(kind, 0)));
    }
  }
}

Pulses World::drive_lead() {
  if (!lead_driver_) return Channels{}.encode({});
  const Seconds period{static_cast<double>(lead_period_) * model_->opt.timestep};
  const Command command =
      lead_driver_->act(lead_->pose(*data_), lead_->speed(*data_), step_ == 0 ? Seconds{} : period);
  return Channels{}.encode(command);
}

}  // namespace pacer::sim
