// SPDX-License-Identifier: Apache-2.0
#include "sim/sim_car.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "core/check.h"
#include "sim/delayed_pulses.h"
#include "sim/lane_view.h"

namespace pacer::sim {
namespace {

constexpr double kTimeStep = 0.005;  // seconds, at most: eight steps a frame at 25 Hz

Seconds time_step(const CameraConfig& camera) {
  return Seconds{1.0 / (camera.frame_rate_hz * static_cast<double>(steps_per_frame(camera)))};
}

/// A delay drawn from `range`, in whole time steps, rounded up.
std::int64_t delay_steps(const Range& range, Seconds step, Random random) {
  return static_cast<std::int64_t>(std::ceil(range.draw(random) / step.count() - 1e-9));
}

double covered_rows(std::span<const RowBand> bands) {
  int rows = 0;
  for (const RowBand& band : bands) rows += band.last - band.first;
  return rows;
}

int index_of_kind(const std::string& kind) {
  const std::vector<std::string>& kinds = room_kinds();
  const auto found = std::ranges::find(kinds, kind);
  return found == kinds.end() ? -1 : static_cast<int>(found - kinds.begin());
}

}  // namespace

std::int64_t steps_per_frame(const CameraConfig& camera) {
  return static_cast<std::int64_t>(std::ceil(1.0 / (camera.frame_rate_hz * kTimeStep) - 1e-9));
}

Subject subject_of(const WorldConfig& world) {
  if (world.has_a_lane()) return Subject::kLane;
  return world.balloons_in_the_open() ? Subject::kBalloons : Subject::kLead;
}

void SimCarConfig::validate() const {
  require(duration.count() > 0.0 && duration.count() <= 3600.0,
          "duration_s: must lie in (0, 3600]");
  command_delay.validate("command_delay_s", 0.0, 1.0);
  camera.validate();
  world.validate();
}

/// A picture under way, with all that is true of it.
struct Shot {
  Frame frame;
  LeadSight sight;
  BalloonSights balloons;
  LaneSight lane;
  Privileged truth;
};

/// Of something seen from camera `id`: how far over the floor, metres, and radians off its axis.
struct Way {
  double distance;
  double bearing;
};

Way way_to(const mjData& data, int id, const Eigen::Vector2d& place) {
  using Axes = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>;
  const Eigen::Vector3d eye = Eigen::Map<const Eigen::Vector3d>(data.cam_xpos + 3 * id);
  const Eigen::Vector3d axis = -Axes(data.cam_xmat + 9 * id).col(2);
  const Eigen::Vector2d way = place - eye.head<2>();
  return {.distance = way.norm(),
          .bearing = wrapped(std::atan2(way.y(), way.x()) - std::atan2(axis.y(), axis.x()))};
}

class SimCar::Episode {
 public:
  Episode(const SimCarConfig& config, const Random& random)
      : frame_steps_(steps_per_frame(config.camera)),
        frames_(static_cast<std::uint64_t>(
            std::llround(config.duration.count() * config.camera.frame_rate_hz))),
        image_delay_(
            std::max<std::int64_t>(1, delay_steps(config.camera.delay, time_step(config.camera),
                                                  random.fork("image_delay")))),
        frame_rate_hz_(config.camera.frame_rate_hz),
        pulses_(delay_steps(config.command_delay, time_step(config.camera),
                            random.fork("command_delay"))),
        lens_(config.camera.lens, config.camera.size(), random.fork("lens")),
        world_(config.world, time_step(config.camera), lens_.rendered_fovy(), random.fork("world")),
        camera_(config.camera, lens_, world_, random.fork("camera")),
        room_kind_(index_of_kind(world_.plan().kind)),
        subject_(subject_of(config.world)),
        shots_(static_cast<std::size_t>(image_delay_ / frame_steps_) + 2) {
    if (world_.lead() != nullptr) {
      visibility_.emplace(world_.model(), world_.camera(), world_.lead()->body(),
                          camera_.geometry());
    }
    if (subject_ == Subject::kLane) {
      lane_view_.emplace(world_.model(), world_.camera(), world_.boards(), camera_.geometry());
    }
    values_of(truth_, subject_, values_);
  }

  /// The next frame with its truth, or nullptr.
  const Frame* look() {
    if (shown_ == frames_) return nullptr;
    const std::int64_t due = static_cast<std::int64_t>(shown_) * frame_steps_ + image_delay_;
    while (step_ < due) advance();
    const Shot& shot = shots_[shown_++ % shots_.size()];
    sight_ = shot.sight;
    balloons_ = shot.balloons;
    lane_ = shot.lane;
    truth_ = shot.truth;
    values_of(truth_, subject_, values_);
    return &shot.frame;
  }

  void send(const Pulses& pulses) { pulses_.send(step_, pulses); }

  [[nodiscard]] Subject subject() const noexcept { return subject_; }
  [[nodiscard]] SignalValues values() const noexcept { return values_; }
  [[nodiscard]] const LeadSight& sight() const noexcept { return sight_; }
  [[nodiscard]] const BalloonSights& balloons() const noexcept { return balloons_; }
  [[nodiscard]] const LaneSight& lane() const noexcept { return lane_; }
  [[nodiscard]] const Privileged& truth() const noexcept { return truth_; }
  [[nodiscard]] const World& world() const noexcept { return world_; }

 private:
  void advance() {
    world_.observe();
    collision_ = collision_ || world_.car().touching(world_.data());
    if (taken_ < frames_ && step_ == static_cast<std::int64_t>(taken_) * frame_steps_) expose();
    world_.advance(pulses_.arrived(step_));
    ++step_;
  }

  /// The shutter closes: picture and truth of this very instant.
  void expose() {
    Shot& shot = shots_[taken_ % shots_.size()];
    const std::span<const RowBand> spoilt = camera_.take(world_, shot.frame);
    shot.frame.index = taken_;
    shot.frame.time = Seconds{static_cast<double>(taken_) / frame_rate_hz_};

    const mjData& data = world_.data();
    shot.truth = {};
    shot.truth.car_pose = world_.car().pose(data);
    shot.truth.car_speed = world_.car().speed(data);
    shot.truth.collision = collision_;
    shot.truth.corrupted_rows = covered_rows(spoilt) / shot.frame.size.height;
    shot.truth.room_kind = room_kind_;
    if (visibility_) tell_lead(spoilt, shot);
    if (subject_ == Subject::kBalloons) {
      shot.balloons = camera_.balloons(world_, spoilt);
      shot.truth.red = balloon("red_balloon", shot.balloons.red);
      shot.truth.green = balloon("green_balloon", shot.balloons.green);
    }
    if (lane_view_) {
      shot.lane = lane_view_->look(data, spoilt);
      tell_lane(shot.truth);
    }
    collision_ = false;
    ++taken_;
  }

  void tell_lane(Privileged& truth) {
    const Lane& lane = world_.lane();
    const Lane::Place place = lane.nearest(truth.car_pose.position);
    if (taken_ > 0) driven_ += std::remainder(place.along - along_, lane.length());
    along_ = place.along;
    truth.lane = {.driven = driven_, .laps = driven_ / lane.length(), .offset = place.offset};
  }

  void tell_lead(std::span<const RowBand> spoilt, Shot& shot) {
    const mjData& data = world_.data();
    const Vehicle& lead = *world_.lead();
    const LeadView view = visibility_->look(data, spoilt);
    shot.sight = view.sight;
    shot.truth.lead_pose = lead.pose(data);
    shot.truth.lead_speed = lead.speed(data);
    shot.truth.lead_visible = view.sight.visible;
    clip_box(view, shot.frame.size, shot.truth);

    using Axes = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>;
    const Axes body(data.xmat + 9 * lead.body());
    const Eigen::Vector3d middle = Eigen::Map<const Eigen::Vector3d>(data.xpos + 3 * lead.body()) +
                                   body * visibility_->middle();
    const Way way = way_to(data, world_.camera(), middle.head<2>());
    shot.truth.lead_distance = way.distance;
    shot.truth.lead_bearing = way.bearing;
  }

  [[nodiscard]] BalloonTruth balloon(const char* name, const BalloonSight& sight) const {
    const mjData& data = world_.data();
    const int hull = mj_name2id(&world_.model(), mjOBJ_GEOM, name);
    const Eigen::Vector2d place =
        Eigen::Map<const Eigen::Vector3d>(data.geom_xpos + 3 * hull).head<2>();
    const Way way = way_to(data, world_.camera(), place);
    return {.position = place, .sight = sight, .distance = way.distance, .bearing = way.bearing};
  }

  std::int64_t frame_steps_;
  std::uint64_t frames_;
  std::int64_t image_delay_;  // time steps
  double frame_rate_hz_;
  DelayedPulses pulses_;
  Lens lens_;
  World world_;
  Camera camera_;
  std::optional<Visibility> visibility_;
  std::optional<LaneView> lane_view_;
  int room_kind_;
  Subject subject_;

  std::vector<Shot> shots_;  // a ring: frame n is in n modulo its size
  std::uint64_t taken_ = 0;  // frames whose shutter has closed
  std::uint64_t shown_ = 0;  // frames that look() has returned
  std::int64_t step_ = 0;    // the present, in time steps
  bool collision_ = false;   // since the last shutter
  double along_ = 0.0;       // metres of the lane, at the last shutter
  double driven_ = 0.0;      // metres along it so far

  LeadSight sight_;
  BalloonSights balloons_;
  LaneSight lane_;
  Privileged truth_;
  std::vector<float> values_;
};

SimCar::SimCar(const SimCarConfig& config, const Random& random) {
  config.validate();
  episode_ = std::make_unique<Episode>(config, random);
}

SimCar::~SimCar() = default;

const Frame* SimCar::look() { return episode_->look(); }
void SimCar::send(const Pulses& pulses) { episode_->send(pulses); }
std::span<const SignalColumn> SimCar::signal_columns() const {
  return privileged_columns(episode_->subject());
}
SignalValues SimCar::signals() const { return episode_->values(); }
const LeadSight& SimCar::lead_sight() const noexcept { return episode_->sight(); }
const BalloonSights& SimCar::balloon_sights() const noexcept { return episode_->balloons(); }
const LaneSight& SimCar::lane_sight() const noexcept { return episode_->lane(); }
const Privileged& SimCar::truth() const noexcept { return episode_->truth(); }
const World& SimCar::world() const noexcept { return episode_->world(); }

}  // namespace pacer::sim
