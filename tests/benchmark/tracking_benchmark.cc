// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "learning/tracking/learning_loops.h"
#include "learning/tracking/linear_predictor.h"
#include "learning/tracking/tracker.h"
#include "tests/learning/tracking/texture.h"

namespace pacer::tracking {
namespace {

const cv::Mat1b& image() {
  static const cv::Mat1b picture = texture({720, 480}, 1, 6.0);
  return picture;
}

// One predictor of Table 4.2's size.
void learn_predictor(benchmark::State& state) {
  PredictorTrainer trainer({}, Random(1));
  LinearPredictor predictor = trainer.make();
  for (auto _ : state) {
    trainer.learn(image(), {360, 240}, predictor);
    benchmark::DoNotOptimize(predictor.at_rest);
  }
}
BENCHMARK(learn_predictor)->Unit(benchmark::kMicrosecond);

void predict(benchmark::State& state) {
  PredictorTrainer trainer({}, Random(1));
  LinearPredictor predictor = trainer.make();
  trainer.learn(image(), {360, 240}, predictor);
  const Eigen::Vector2d at(state.range(0), 240.0);
  for (auto _ : state) benchmark::DoNotOptimize(predictor.predict(image(), at));
}
BENCHMARK(predict)->ArgName("column")->Arg(360)->Arg(5);

// The equations of one predictor, with the loops for each kind of processor.
void solve(benchmark::State& state) {
  const auto kind = static_cast<std::size_t>(state.range(0));
  if (kind >= processor_kinds()) return state.SkipWithError("not on this processor");
  constexpr std::size_t kPairs = 75, kSamples = 112, kStride = 112;
  Random random(1);
  std::vector<std::int32_t> differences(kPairs * kSamples);
  for (auto& pair : differences) pair = static_cast<std::int32_t>(random.next() & 0x007f007f);
  std::vector<float> system(kSamples * kStride), solution(2 * kSamples);
  for (auto _ : state) {
    learning_loops(kind).gram(differences.data(), kPairs, kSamples, kStride, system.data());
    for (std::size_t i = 0; i < 100; ++i) system[i * (kStride + 1)] += 1e6F;
    learning_loops(kind).solve(system.data(), 100, kStride, solution.data());
    benchmark::DoNotOptimize(solution.data());
  }
}
BENCHMARK(solve)->ArgName("kind")->DenseRange(0, 2)->Unit(benchmark::kMicrosecond);

// A tracker's frames a second on a target of Dudek's size and of a fraction of it, once its
// appearance model is full.
void track(benchmark::State& state, const TrackerKind& kind) {
  const cv::Size kFrame(720, 480);
  const cv::Mat1b world = texture({800, 560}, 1, 6.0);
  std::vector<Picture> pictures;
  for (int t = 0; t < 40; ++t) {
    const Eigen::Vector2d camera(40.0 + 30.0 * std::sin(0.157 * t),
                                 40.0 + 20.0 * std::cos(0.157 * t));
    pictures.push_back(picture_of(part_of(world, camera, kFrame)));
  }
  const auto side = static_cast<double>(state.range(0));
  const auto tracker = kind.make(1);
  tracker->start(pictures[0], {.x = 360, .y = 240, .width = 0.75 * side, .height = side});
  std::size_t t = 1;
  for (; t < 400; ++t) (void)tracker->update(pictures[t % pictures.size()]);
  for (auto _ : state) {
    benchmark::DoNotOptimize(tracker->update(pictures[t++ % pictures.size()]));
  }
  state.SetItemsProcessed(state.iterations());
}

}  // namespace
}  // namespace pacer::tracking

int main(int argc, char** argv) {
  for (const pacer::tracking::TrackerKind& kind : pacer::tracking::trackers()) {
    benchmark::RegisterBenchmark(
        ("track/" + kind.name).c_str(),
        [kind](benchmark::State& state) { pacer::tracking::track(state, kind); })
        ->ArgName("height")
        ->Arg(176)
        ->Arg(88)
        ->Arg(44)
        ->Unit(benchmark::kMicrosecond);
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
