// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include <cstddef>
#include <vector>

#include "core/random.h"
#include "learning/affordance/apriori.h"
#include "learning/affordance/bit_table.h"
#include "learning/affordance/generated_transactions.h"
#include "learning/affordance/transaction_index.h"

namespace pacer::affordance {
namespace {

// All six types of the generated database at the thesis's thresholds, by transactions and jobs.
void mine_generated(benchmark::State& state) {
  GeneratedTransactions generated;
  generated.transactions = static_cast<int>(state.range(0));
  const TransactionDatabase database = generate_transactions(generated, Random(1));
  std::size_t rules = 0;
  for (auto _ : state) {
    rules = mine_rules(database, AprioriConfig{}, static_cast<int>(state.range(1))).size();
    benchmark::DoNotOptimize(rules);
  }
  state.counters["rules"] = static_cast<double>(rules);
}
BENCHMARK(mine_generated)
    ->Args({88810, 1})
    ->Args({88810, 2})
    ->Args({1000000, 1})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

void index_generated(benchmark::State& state) {
  const TransactionDatabase database = generate_transactions({}, Random(1));
  for (auto _ : state) benchmark::DoNotOptimize(TransactionIndex(database, 18).ranks());
}
BENCHMARK(index_generated)->Unit(benchmark::kMillisecond);

// One row of 540 against all others, 750 transactions, with each kind of loop this processor has.
void count_row(benchmark::State& state) {
  const auto kind = static_cast<std::size_t>(state.range(0));
  if (kind >= bit_loop_count()) return state.SkipWithError("not on this processor");
  constexpr std::size_t kRows = 540;
  BitTable table(bit_loops(kind));
  table.reset(kRows, 750);
  Random random(1);
  for (std::size_t row = 0; row < kRows; ++row) {
    for (std::size_t column = 0; column < 750; ++column) {
      if (random.chance(0.05)) table.set(row, column);
    }
  }
  std::vector<BitTable::Word> mask;
  table.copy_row(kRows - 1, mask);
  std::vector<std::uint32_t> counts(padded_rows(kRows));
  for (auto _ : state) {
    table.add_shared(mask, 0, table.words(), kRows, counts);
    benchmark::DoNotOptimize(counts.data());
  }
}
BENCHMARK(count_row)->DenseRange(0, 2);

}  // namespace
}  // namespace pacer::affordance

BENCHMARK_MAIN();
