// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "core/car.h"
#include "core/random.h"
#include "core/range.h"
#include "sim/camera.h"
#include "sim/privileged.h"
#include "sim/sight.h"
#include "sim/world.h"

namespace pacer::sim {

/// A simulated episode.
struct SimCarConfig {
  Seconds duration{60.0};           ///< of the frames that look() shows
  Range command_delay{0.02, 0.03};  ///< seconds from send() to the servos; up to a time step
  CameraConfig camera;
  WorldConfig world;

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("duration_s", duration);
    visit("command_delay_s", command_delay);
    visit("camera", camera);
    visit("world", world);
  }
};

/// What the episodes of `world` are about.
[[nodiscard]] Subject subject_of(const WorldConfig& world);

/// How many whole time steps of the physics, of 5 ms at most, make up a frame.
[[nodiscard]] std::int64_t steps_per_frame(const CameraConfig& camera);

/// A car in MuJoCo. look() steps the physics until the next frame has come through camera and
/// radio; pulses sent then reach the servos `command_delay` later. Before the first send() there
/// is no pulse, and the car stands. Same config and random: same frames, bit for bit, on one
/// machine.
///
/// The shutter closes frame_rate_hz times a second, first at time 0; the frame shown last closed
/// its shutter `camera.delay` before the present.
class SimCar final : public Car {
 public:
  /// `random` picks the room, the route, the car's build and all noise. Throws
  /// std::invalid_argument for a bad config and std::runtime_error when there is no OpenGL to draw
  /// with or no room to drive in.
  SimCar(const SimCarConfig& config, const Random& random);
  ~SimCar() override;

  [[nodiscard]] const Frame* look() override;
  void send(const Pulses& pulses) override;
  [[nodiscard]] std::span<const SignalColumn> signal_columns() const override;
  [[nodiscard]] SignalValues signals() const override;

  /// What can be seen of the lead in the frame last shown. The reference lives as long as the car.
  [[nodiscard]] const LeadSight& lead_sight() const noexcept;
  /// What the frame last shown shows of the balloons; nothing unless the world's layout is
  /// `balloons`. The reference lives as long as the car.
  [[nodiscard]] const BalloonSights& balloon_sights() const noexcept;
  /// What can be seen of the lane's boards in the frame last shown; nothing unless the world's
  /// layout is `lane`. The reference lives as long as the car.
  [[nodiscard]] const LaneSight& lane_sight() const noexcept;
  /// The truth at the shutter of the frame last shown.
  [[nodiscard]] const Privileged& truth() const noexcept;
  /// The world at the present: later than the frame last shown.
  [[nodiscard]] const World& world() const noexcept;

 private:
  class Episode;
  std::unique_ptr<Episode> episode_;
};

}  // namespace pacer::sim
