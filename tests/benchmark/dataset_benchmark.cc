// SPDX-License-Identifier: Apache-2.0
// What recording costs: one frame, all in (copy, encode, statistics, table), on one core, and the
// most memory a process takes for episodes of 1,000 and of 20,000 frames.
#include <benchmark/benchmark.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <ctime>

#include "dataset/demonstration.h"
#include "tests/dataset/recording.h"

namespace pacer::dataset {
namespace {

using testing::made_up_step;
using testing::MadeUpStep;
using testing::Scratch;

constexpr std::int64_t kPictures = 50;

DatasetSpec full_spec() {
  DatasetSpec spec = testing::small_spec();
  spec.image_size = {.width = 320, .height = 240};
  return spec;
}

/// Frames with the detail of a furnished room: smooth shapes, and grain that does not stay.
std::vector<MadeUpStep> pictures(const DatasetSpec& spec) {
  std::vector<MadeUpStep> steps;
  Random random(17);
  for (std::int64_t i = 0; i < kPictures; ++i) {
    MadeUpStep& made = steps.emplace_back(made_up_step(spec, 0, i));
    for (std::uint8_t& value : made.frame.rgb) {
      value = static_cast<std::uint8_t>(value + random.below(7));
    }
  }
  return steps;
}

void stay_on_one_core() {
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(0, &one);
  ::sched_setaffinity(0, sizeof one, &one);
}

void record(const std::filesystem::path& root, const DatasetSpec& spec,
            const std::vector<MadeUpStep>& steps, std::int64_t length) {
  EpisodeRecorder recorder(root, spec, 0);
  for (std::int64_t i = 0; i < length; ++i) {
    const MadeUpStep& made = steps[static_cast<std::size_t>(i % kPictures)];
    static_cast<void>(recorder.write(made.frame, made.step()));
  }
  recorder.finish();
}

void RecordFrame(benchmark::State& state) {
  stay_on_one_core();
  const DatasetSpec spec = full_spec();
  const auto steps = pictures(spec);
  constexpr std::int64_t kLength = 1500;
  double cpu_s = 0.0;
  for (auto _ : state) {
    const Scratch scratch;
    const DatasetWriter writer(scratch / "set", spec);
    const std::clock_t start = std::clock();
    record(scratch / "set", spec, steps, kLength);
    cpu_s += static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  }
  const auto frames = static_cast<double>(state.iterations() * kLength);
  state.counters["cpu_us_per_frame"] = 1e6 * cpu_s / frames;
  state.SetItemsProcessed(state.iterations() * kLength);
}
BENCHMARK(RecordFrame)->Unit(benchmark::kMillisecond)->UseRealTime();

void ReadFrame(benchmark::State& state) {
  const DatasetSpec spec = full_spec();
  const Scratch scratch;
  {
    DatasetWriter writer(scratch / "set", spec);
    record(scratch / "set", spec, pictures(spec), 500);
    writer.commit();
  }
  const RecordedDemonstration demonstration(scratch / "set");
  for (auto _ : state) {
    const auto stream = demonstration.open(0);
    while (stream->next() != nullptr) {
    }
  }
  state.SetItemsProcessed(state.iterations() * 500);
}
BENCHMARK(ReadFrame)->Unit(benchmark::kMillisecond);

/// Records in a process of its own and reports the most memory that it held.
void PeakMemory(benchmark::State& state) {
  const DatasetSpec spec = full_spec();
  const auto steps = pictures(spec);
  for (auto _ : state) {
    const Scratch scratch;
    const DatasetWriter writer(scratch / "set", spec);
    const pid_t child = ::fork();
    if (child == 0) {
      record(scratch / "set", spec, steps, state.range(0));
      ::_exit(0);
    }
    rusage usage{};
    ::wait4(child, nullptr, 0, &usage);
    state.counters["peak_mb"] = static_cast<double>(usage.ru_maxrss) / 1024.0;
  }
}
BENCHMARK(PeakMemory)->Arg(1'000)->Arg(20'000)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pacer::dataset

BENCHMARK_MAIN();
