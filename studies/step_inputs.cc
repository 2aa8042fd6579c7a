// SPDX-License-Identifier: Apache-2.0
#include "studies/step_inputs.h"

#include <algorithm>
#include <stdexcept>

#include "core/drive.h"
#include "sim/sim_car.h"
#include "sim/teacher.h"

namespace pacer {
namespace {

StepInputs* watching = nullptr;  // MuJoCo's callbacks carry no context

class Nobody final : public StepSink {
 public:
  [[nodiscard]] bool write(const Frame&, const Step&) override { return true; }
};

/// MuJoCo calls `see` for `inputs` while it lives.
class Watch {
 public:
  Watch(StepInputs& inputs, mjfGeneric see) {
    watching = &inputs;
    mjcb_control = see;
  }
  ~Watch() {
    mjcb_control = nullptr;
    watching = nullptr;
  }
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;
};

}  // namespace

void StepInputs::see(const mjModel* model, mjData* data) {
  StepInputs& my = *watching;
  my.motors_ = static_cast<int>(model->nu);
  my.bodies_ = static_cast<int>(model->nbody);
  // Called before a step's inputs are chosen: those of the step before still stand.
  if (my.seen_++ > 0) {
    my.controls_.insert(my.controls_.end(), data->ctrl, data->ctrl + model->nu);
    my.forces_.insert(my.forces_.end(), data->xfrc_applied, data->xfrc_applied + 6 * model->nbody);
  }
  my.last_.assign(data->qpos, data->qpos + model->nq);
}

StepInputs StepInputs::of_demonstration(const Scenario& scenario, std::uint32_t episode) {
  const Random random = scenario.episode_random(Purpose::kCollect, episode);
  sim::SimCar car(scenario.simulated_for(Purpose::kCollect), random.fork("car"));
  sim::Teacher teacher(scenario.teacher, car.lead_sight(), random.fork("policy").fork("teacher"));
  StepInputs inputs;
  Nobody nobody;
  const Watch watch(inputs, see);  // from here on: the world has settled, and a new one will have
  (void)drive(car, teacher, scenario.limits, scenario.channels, nobody);
  return inputs;
}

std::int64_t StepInputs::steps() const { return std::max<std::int64_t>(0, seen_ - 1); }

void StepInputs::apply(const mjModel& model, std::int64_t step, mjData& data) const {
  if (model.nu != motors_ || model.nbody != bodies_) {
    throw std::logic_error("the inputs are another world's");
  }
  const auto put = [step](const std::vector<mjtNum>& from, std::int64_t width, mjtNum* to) {
    std::copy_n(from.begin() + step * width, width, to);
  };
  put(controls_, model.nu, data.ctrl);
  put(forces_, 6 * model.nbody, data.xfrc_applied);
}

bool StepInputs::end_in(const mjModel& model, const mjData& data) const {
  return std::equal(last_.begin(), last_.end(), data.qpos, data.qpos + model.nq);
}

}  // namespace pacer
