// SPDX-License-Identifier: Apache-2.0
#include "studies/bare_loop.h"

#include <mujoco/mujoco.h>

#include <chrono>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "sim/gl_context.h"
#include "sim/lens.h"
#include "sim/renderer.h"
#include "sim/world.h"

namespace pacer {

double bare_loop_frames_a_second(const sim::SimCarConfig& config, const Random& random,
                                 const StepInputs& inputs) {
  const sim::CameraConfig& camera = config.camera;
  const sim::Lens lens(camera.lens, camera.size(), random.fork("lens"));
  const Seconds period{1.0 / camera.frame_rate_hz};
  const std::int64_t steps = sim::steps_per_frame(camera);
  sim::World world(config.world, period / static_cast<double>(steps), lens.rendered_fovy(),
                   random.fork("world"));
  const mjModel& model = world.model();
  mjData* data = &world.data();

  const sim::GlContext context;
  const mjvOption shown = sim::shown_in_pictures();
  mjvCamera view;
  mjv_defaultCamera(&view);
  view.type = mjCAMERA_FIXED;
  view.fixedcamid = world.camera();
  mjvScene scene;
  mjrContext buffers;
  sim::make_buffers(model, camera.size(), camera.render, scene, buffers);
  const mjrRect whole{0, 0, camera.width, camera.height};
  std::vector<unsigned char> pixels(static_cast<std::size_t>(3 * camera.width * camera.height));

  const std::int64_t frames = inputs.steps() / steps;
  const auto start = std::chrono::steady_clock::now();
  std::int64_t step = 0;
  for (std::int64_t frame = 0; frame < frames; ++frame) {
    for (std::int64_t i = 0; i < steps; ++i) {
      inputs.apply(model, step++, *data);
      mj_step(&model, data);
    }
    mjv_updateScene(&model, data, &shown, nullptr, &view, mjCAT_ALL, &scene);
    mjr_render(whole, &scene, &buffers);
    mjr_readPixels(pixels.data(), nullptr, whole, &buffers);
  }
  const Seconds taken = std::chrono::steady_clock::now() - start;

  mjv_freeScene(&scene);
  mjr_freeContext(&buffers);
  for (; step < inputs.steps(); ++step) {
    inputs.apply(model, step, *data);
    mj_step(&model, data);
  }
  if (!inputs.end_in(model, *data)) {
    throw std::logic_error("the bare loop does not end where the drive ended");
  }
  return static_cast<double>(frames) / taken.count();
}

}  // namespace pacer
