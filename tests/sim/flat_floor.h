// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <memory>

#include "sim/vehicle.h"

namespace pacer::sim::testing {

/// Any warning of the simulator fails a test.
inline void expect_no_warnings(const mjData& data) {
  for (int kind = 0; kind < mjNWARNING; ++kind) {
    EXPECT_EQ(data.warning[kind].number, 0) << mju_warningText(kind, 0);
  }
}

/// A car whose every figure is the nominal one.
inline VehicleConfig nominal() {
  VehicleConfig config;
  for (ReceiverConfig* receiver : {&config.steering.receiver, &config.throttle.receiver}) {
    receiver->centre_error = {0.0, 0.0};
    receiver->throw_factor = {1.0, 1.0};
    receiver->dead_zone = Pulse{0};
  }
  config.steering.seconds_per_60deg = {0.16, 0.16};
  config.motor.battery_factor = {1.0, 1.0};
  config.mass_factor = {1.0, 1.0};
  config.grip = {0.9, 0.9};
  return config;
}

/// One car on an endless floor.
class FlatFloor {
 public:
  explicit FlatFloor(const VehicleConfig& config = nominal()) {
    mjSpec* const spec = mj_makeSpec();
    spec->option.timestep = 0.005;
    spec->option.integrator = mjINT_IMPLICITFAST;
    spec->option.cone = mjCONE_ELLIPTIC;
    spec->option.impratio = 5.0;
    mjsGeom* const floor = mjs_addGeom(mjs_findBody(spec, "world"), nullptr);
    floor->type = mjGEOM_PLANE;
    floor->size[0] = floor->size[1] = 50.0;
    floor->size[2] = 1.0;
    mjs_setName(floor->element, "floor");
    add_vehicle(*spec, "car/", "floor", config, Random{1});
    model_.reset(mj_compile(spec, nullptr));
    EXPECT_NE(model_, nullptr) << mjs_getError(spec);
    mj_deleteSpec(spec);
    data_.reset(mj_makeData(model_.get()));
    vehicle_ = std::make_unique<Vehicle>(*model_, "car/", config, Random{1});
    vehicle_->place(*data_, {});
    run(Seconds{0.3}, {});
  }
  ~FlatFloor() { expect_no_warnings(*data_); }
  FlatFloor(const FlatFloor&) = delete;
  FlatFloor& operator=(const FlatFloor&) = delete;

  /// Drives with these pulses for a while.
  void run(Seconds duration, const Pulses& pulses) {
    for (long left = std::lround(duration.count() / model_->opt.timestep); left > 0; --left) {
      vehicle_->actuate(*data_, pulses);
      mj_step(model_.get(), data_.get());
    }
  }

  [[nodiscard]] FloorPose pose() const { return vehicle_->pose(*data_); }
  [[nodiscard]] double speed() const { return vehicle_->speed(*data_); }
  [[nodiscard]] double height() const { return data_->qpos[2]; }
  [[nodiscard]] const mjModel& model() const { return *model_; }
  [[nodiscard]] mjData& data() { return *data_; }
  [[nodiscard]] Vehicle& vehicle() { return *vehicle_; }

 private:
  struct Delete {
    void operator()(mjModel* model) const { mj_deleteModel(model); }
    void operator()(mjData* data) const { mj_deleteData(data); }
  };
  std::unique_ptr<mjModel, Delete> model_;
  std::unique_ptr<mjData, Delete> data_;
  std::unique_ptr<Vehicle> vehicle_;
};

}  // namespace pacer::sim::testing
