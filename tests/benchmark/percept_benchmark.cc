// SPDX-License-Identifier: Apache-2.0
// A picture to its percept on one core, at 320 x 240; OpenCV's colour MSER (MSCR) is the baseline.
#include <benchmark/benchmark.h>

#include <opencv2/core/utility.hpp>
#include <opencv2/features2d.hpp>

#include "learning/exemplar/percept.h"
#include "tests/learning/exemplar/painted.h"

namespace pacer::exemplar {
namespace {

/// Two balloons before a wall of patches.
Frame cluttered() {
  Frame frame = testing::wall({320, 240});
  Random random(1);
  for (int i = 0; i < 300; ++i) {
    const testing::Rgb colour{random.uniform(0, 255), random.uniform(0, 255),
                              random.uniform(0, 255)};
    testing::fill_rectangle(frame, static_cast<int>(random.below(320)),
                            static_cast<int>(random.below(120)), 8, 12, colour);
  }
  testing::fill_ball(frame, 100.0, 60.0, 30.0, testing::kRedRubber);
  testing::fill_ball(frame, 220.0, 80.0, 15.0, testing::kGreenRubber);
  testing::add_noise(frame, 2.5, random.fork("noise"));
  return frame;
}

void FindBlobs(benchmark::State& state) {
  const Frame frame = cluttered();
  BlobFinder finder;
  for (auto _ : state) benchmark::DoNotOptimize(finder.find(frame).size());
}
BENCHMARK(FindBlobs)->Unit(benchmark::kMillisecond);

void FindBalloons(benchmark::State& state) {
  const Frame frame = cluttered();
  BalloonFinder finder;
  for (auto _ : state) benchmark::DoNotOptimize(percept(finder.find(frame)));
}
BENCHMARK(FindBalloons)->Unit(benchmark::kMillisecond);

void OpenCvMser(benchmark::State& state) {
  cv::setNumThreads(1);
  Frame frame = cluttered();
  const cv::Mat picture(240, 320, CV_8UC3, frame.rgb.data());
  const auto mser = cv::MSER::create(5, 20);
  std::vector<std::vector<cv::Point>> regions;
  std::vector<cv::Rect> boxes;
  for (auto _ : state) mser->detectRegions(picture, regions, boxes);
}
BENCHMARK(OpenCvMser)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pacer::exemplar

BENCHMARK_MAIN();
