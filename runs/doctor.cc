// SPDX-License-Identifier: Apache-2.0
#include "runs/doctor.h"

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <chrono>
#include <filesystem>
#include <thread>

#include "dataset/video.h"
#include "runs/film.h"
#include "sim/gl_context.h"
#include "sim/sim_car.h"

namespace pacer {
namespace {

using Verdict = Diagnosis::Verdict;

Diagnosis processors() {
  const unsigned count = std::thread::hardware_concurrency();
  return {.what = "processors",
          .found = fmt::format("{}; that many workers by default (--jobs)", count),
          .verdict = count < 2 ? Verdict::kSlow : Verdict::kGood,
          .advice = count < 2 ? "recording and evaluating scale with processors" : ""};
}

Diagnosis opengl() {
  try {
    const sim::GlContext context;
    const sim::GlDescription& gl = context.description();
    return {.what = "OpenGL",
            .found = fmt::format("{} ({}), OpenGL {}", gl.renderer, gl.path, gl.version),
            .verdict = gl.software ? Verdict::kSlow : Verdict::kGood,
            .advice = gl.software ? "the processor draws: correct, but slower than a GPU; keep "
                                    "simulated.camera.render.quality=fast"
                                  : ""};
  } catch (const std::exception& error) {
    return {.what = "OpenGL",
            .found = error.what(),
            .verdict = Verdict::kMissing,
            .advice = "install EGL or OSMesa: scripts/setup does"};
  }
}

Diagnosis drawing(const Scenario& scenario) {
  constexpr int kFrames = 50;
  try {
    sim::SimCar car(scenario.simulated_for(Purpose::kCollect),
                    scenario.episode_random(Purpose::kCollect, 0).fork("car"));
    (void)car.look();
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < kFrames; ++i) (void)car.look();
    const double ms =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
            .count() /
        kFrames;
    constexpr double kSlowMs = 20.0;
    return {.what = "simulated frames",
            .found = fmt::format("{:.1f} ms each, {:.0f} a second", ms, 1e3 / ms),
            .verdict = ms > kSlowMs ? Verdict::kSlow : Verdict::kGood,
            .advice = ms > kSlowMs ? "set simulated.camera.render.quality=fast" : ""};
  } catch (const std::exception& error) {
    return {.what = "simulated frames",
            .found = error.what(),
            .verdict = Verdict::kMissing,
            .advice = "see OpenGL above"};
  }
}

Diagnosis video() {
  try {
    const TemporaryFile file(".mp4");
    Frame frame;
    frame.size = {.width = 64, .height = 48};
    frame.rgb.assign(64 * 48 * 3, 100);
    dataset::VideoEncoder encoder(file.path(), frame.size, 25);
    encoder.write(frame);
    encoder.close();
    return {.what = "video", .found = "H.264 by libx264", .verdict = Verdict::kGood, .advice = ""};
  } catch (const std::exception& error) {
    return {.what = "video",
            .found = error.what(),
            .verdict = Verdict::kMissing,
            .advice = "install an FFmpeg with libx264: scripts/setup does"};
  }
}

Diagnosis disk() {
  std::error_code error;
  const std::filesystem::space_info space =
      std::filesystem::space(std::filesystem::current_path(), error);
  const double gigabytes = static_cast<double>(space.available) / 1e9;
  const bool low = !error && gigabytes < 1.0;
  return {.what = "disk here",
          .found = error ? error.message() : fmt::format("{:.1f} GB free", gigabytes),
          .verdict = low ? Verdict::kSlow : Verdict::kGood,
          .advice = low ? "five minutes of driving take about 0.1 GB" : ""};
}

}  // namespace

std::vector<Diagnosis> examine(const Scenario& scenario) {
  return {processors(),
          opengl(),
          drawing(scenario),
          {.what = "MuJoCo", .found = mj_versionString(), .verdict = Verdict::kGood, .advice = ""},
          video(),
          disk()};
}

}  // namespace pacer
