// SPDX-License-Identifier: Apache-2.0
// What a frame of the simulated car costs, beside a bare loop over the same world: eight mj_steps,
// mjv_updateScene, mjr_render and mjr_readPixels, and nothing else.
// LP_NUM_THREADS=1 taskset -c 0 sim_benchmark
#include <benchmark/benchmark.h>

#include "sim/sim_car.h"

namespace pacer::sim {
namespace {

SimCarConfig episode() {
  SimCarConfig config;
  config.duration = Seconds{1e6};
  return config;
}

void BM_SimCar(benchmark::State& state) {
  SimCar car(episode(), Random{1});
  for (auto _ : state) {
    benchmark::DoNotOptimize(car.look());
    car.send({std::chrono::microseconds{1600}, std::chrono::microseconds{1600}});
  }
}
BENCHMARK(BM_SimCar)->Unit(benchmark::kMillisecond);

void BM_BareLoop(benchmark::State& state) {
  const SimCarConfig config = episode();
  const Lens lens(config.camera.lens, config.camera.size(), Random{1}.fork("lens"));
  World world(config.world, Seconds{0.005}, lens.rendered_fovy(), Random{1}.fork("world"));
  Renderer renderer(world.model(), World::kCamera, config.camera.size(), config.camera.render);
  Frame frame;
  for (auto _ : state) {
    for (int step = 0; step < 8; ++step) mj_step(&world.model(), &world.data());
    renderer.render(world.model(), world.data(), frame);
    benchmark::DoNotOptimize(frame.rgb.data());
  }
}
BENCHMARK(BM_BareLoop)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pacer::sim

BENCHMARK_MAIN();
