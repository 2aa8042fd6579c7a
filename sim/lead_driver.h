// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "core/command.h"
#include "core/units.h"
#include "sim/route.h"

namespace pacer::sim {

/// How the lead's driver handles its car. Feedback takes up what the car really does.
struct LeadDriverConfig {
  double wheelbase = 0.26;        ///< metres, of the car it believes to drive
  double lock = 0.45;             ///< radians of wheel at full stick
  double lookahead = 0.40;        ///< metres, of pure pursuit
  double stick_per_speed = 0.33;  ///< stick per m/s
  double stick_friction = 0.03;   ///< stick that just keeps the car rolling
  double speed_gain = 0.25;       ///< stick per m/s of error
  double speed_integral = 0.35;   ///< stick per metre of error
  double drift_integral = 0.4;    ///< stick per metre-second off the line: a servo's wrong centre

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("wheelbase_m", wheelbase);
    visit("lock_rad", lock);
    visit("lookahead_m", lookahead);
    visit("stick_per_mps", stick_per_speed);
    visit("stick_friction", stick_friction);
    visit("speed_gain", speed_gain);
    visit("speed_integral", speed_integral);
    visit("drift_integral", drift_integral);
  }
};

/// Drives the lead along a route: pure pursuit, and a speed loop. It knows the truth of its own
/// car, nothing of the follower; when something blocks it, it stays.
class LeadDriver {
 public:
  /// Copies the route.
  LeadDriver(const LeadDriverConfig& config, Route route);

  /// What to do now. `pose` is of the body's middle, `speed` along its axis in m/s, `dt` the time
  /// since the call before (at most 0.1 s is believed).
  [[nodiscard]] Command act(const FloorPose& pose, double speed, Seconds dt);

  [[nodiscard]] double along() const noexcept { return along_; }  ///< metres of route behind it
  [[nodiscard]] bool standing() const noexcept { return standing_; }
  [[nodiscard]] const Route& route() const noexcept { return route_; }

 private:
  [[nodiscard]] double steer(const FloorPose& pose, double speed, double dt);
  [[nodiscard]] double push(double speed, double dt);

  LeadDriverConfig config_;
  Route route_;
  double along_ = 0.0;
  std::size_t next_stand_ = 0;
  bool standing_ = false;
  double stood_ = 0.0;     // seconds at rest in the present stand
  double trim_ = 0.0;      // stick, what steering needs beyond geometry
  double throttle_ = 0.0;  // stick, what speed needs beyond the estimate
};

}  // namespace pacer::sim
