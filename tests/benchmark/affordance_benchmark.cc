// SPDX-License-Identifier: Apache-2.0
// What each stage of a response costs on one core, at 320 x 240.
#include <benchmark/benchmark.h>

#include <opencv2/core/utility.hpp>
#include <opencv2/imgproc.hpp>

#include "learning/affordance/kmeans.h"
#include "learning/affordance/perception.h"
#include "tests/learning/affordance/random_model.h"

namespace pacer::affordance {
namespace {

/// Noise at several scales: as many features as the contrast threshold lets through.
Frame rich_frame(std::uint64_t seed) {
  Random random(seed);
  Frame frame;
  frame.size = {320, 240};
  frame.rgb.resize(320 * 240 * 3);
  cv::Mat sum(240, 320, CV_32FC3, cv::Scalar::all(128));
  for (const int step : {4, 8, 16, 32}) {
    cv::Mat noise(240 / step + 1, 320 / step + 1, CV_32FC3);
    for (int i = 0; i < 3 * static_cast<int>(noise.total()); ++i) {
      noise.ptr<float>()[i] = static_cast<float>(random.uniform(-42.0, 42.0));
    }
    cv::Mat large;
    cv::resize(noise, large, sum.size(), 0.0, 0.0, cv::INTER_CUBIC);
    sum += large;
  }
  cv::Mat image(240, 320, CV_8UC3, frame.rgb.data());
  sum.convertTo(image, CV_8UC3);
  return frame;
}

void Extract(benchmark::State& state) {
  cv::setNumThreads(1);
  FeatureExtractor extractor({.budget = static_cast<int>(state.range(0))});
  const Frame frame = rich_frame(1);
  Features features;
  for (auto _ : state) extractor.extract(frame, features);
  state.counters["features"] = static_cast<double>(features.count());
}
BENCHMARK(Extract)->Arg(250)->Arg(500)->Arg(800)->Unit(benchmark::kMillisecond);

void Label(benchmark::State& state) {
  const Features features =
      testing::random_features(static_cast<std::size_t>(state.range(0)), Random(1));
  const Vocabulary vocabulary = testing::random_vocabulary(50, 5, 5);
  Words words;
  for (auto _ : state) vocabulary.label(features, words);
}
BENCHMARK(Label)->Arg(500)->Unit(benchmark::kMillisecond);

void Configure(benchmark::State& state) {
  const auto count = static_cast<std::size_t>(state.range(0));
  const Features features = testing::random_features(count, Random(1));
  const Words words = testing::random_words(count, Random(2));
  const ItemLayout layout(testing::random_vocabulary(50, 5, 5));
  Configuration configuration;
  for (auto _ : state) {
    for (std::size_t centre = 0; centre < count; ++centre) {
      build_configuration({features.poses, words}, layout, {}, centre, configuration);
      benchmark::DoNotOptimize(configuration);
    }
  }
}
BENCHMARK(Configure)->Arg(500)->Unit(benchmark::kMillisecond);

/// Configurations, subset tests and mappings together.
void Match(benchmark::State& state) {
  const Model model = testing::random_model(static_cast<std::size_t>(state.range(0)));
  Perception perception(model);
  perception.look(testing::random_features(500, Random(1)));
  std::size_t votes = 0;
  for (auto _ : state) votes = perception.match().size();
  state.counters["votes"] = static_cast<double>(votes);
}
BENCHMARK(Match)->Arg(0)->Arg(3000)->Unit(benchmark::kMillisecond);

void ClusterDescriptors(benchmark::State& state) {
  const Features features = testing::random_features(40000, Random(1));
  const std::vector<float> samples(features.descriptors.begin(), features.descriptors.end());
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        kmeans(samples, kDescriptorSize, {.clusters = 50, .iterations = 10}, Random(2)));
  }
}
BENCHMARK(ClusterDescriptors)->Unit(benchmark::kSecond)->Iterations(1);

}  // namespace
}  // namespace pacer::affordance

BENCHMARK_MAIN();
