// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include "learning/exemplar/best_first.h"
#include "learning/exemplar/generated_exemplars.h"
#include "learning/exemplar/nn_pa.h"

namespace pacer::exemplar {
namespace {

Exemplars generated(std::int64_t count, const char* name) {
  GeneratedExemplars config;
  config.exemplars = static_cast<int>(count);
  return generate_exemplars(config, Random(1).fork(name));
}

void build(benchmark::State& state) {
  const Exemplars exemplars = generated(state.range(0), "exemplars");
  for (auto _ : state) benchmark::DoNotOptimize(Hierarchy(exemplars, {}).tree().depth());
}
BENCHMARK(build)->Arg(304)->Arg(10000)->Arg(100000)->Unit(benchmark::kMillisecond);

void learn_one(benchmark::State& state) {
  const Exemplars exemplars = generated(state.range(0), "exemplars");
  const Exemplars more = generated(1000, "more");
  Hierarchy hierarchy(exemplars, {});
  std::size_t n = 0;
  for (auto _ : state) {
    if (n == more.size()) {
      state.PauseTiming();
      hierarchy = Hierarchy(exemplars, {});
      n = 0;
      state.ResumeTiming();
    }
    benchmark::DoNotOptimize(hierarchy.learn(more.percept(n), more.action(n)));
    ++n;
  }
}
BENCHMARK(learn_one)->Arg(304)->Arg(10000);

// One unseen percept after the other.
template <class Find>
void ask(benchmark::State& state, const Find& find) {
  const Exemplars queries = generated(500, "queries");
  std::size_t q = 0;
  for (auto _ : state) benchmark::DoNotOptimize(find(queries.percept(q++ % queries.size())));
}

void every_branch(benchmark::State& state) {
  const Hierarchy hierarchy(generated(state.range(0), "exemplars"), {});
  Searcher searcher(hierarchy);
  ask(state, [&](std::span<const double> percept) { return searcher.find(percept).best.node; });
}
BENCHMARK(every_branch)->Arg(304)->Arg(10000)->Arg(100000);

void best_first(benchmark::State& state) {
  const Hierarchy hierarchy(generated(state.range(0), "exemplars"), {});
  const NodeIndex index(hierarchy);
  BestFirstSearcher searcher(hierarchy, index);
  ask(state, [&](std::span<const double> percept) { return searcher.find(percept).best.node; });
}
BENCHMARK(best_first)->Arg(304)->Arg(10000)->Arg(100000)->Arg(1000000);

void nanoflann(benchmark::State& state) {
  const NnPaTree tree(generated(state.range(0), "exemplars"), PerceptUnits::kStandardised);
  ask(state, [&](std::span<const double> percept) { return tree.nearest(percept); });
}
BENCHMARK(nanoflann)->Arg(304)->Arg(10000)->Arg(100000)->Arg(1000000);

}  // namespace
}  // namespace pacer::exemplar

BENCHMARK_MAIN();
