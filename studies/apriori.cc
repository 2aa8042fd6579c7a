// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/apriori.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>

#include "core/check.h"
#include "core/parallel.h"
#include "dataset/demonstration.h"
#include "learning/affordance/generated_transactions.h"
#include "learning/affordance/rules_file.h"
#include "learning/affordance/train.h"
#include "runs/train.h"
#include "runs/worker_pool.h"
#include "studies/materials.h"
#include "studies/reference_apriori.h"
#include "studies/studies.h"

namespace pacer {
namespace {

using affordance::ActionType;
using affordance::AprioriConfig;
using affordance::Item;
using affordance::Rule;
using affordance::TransactionDatabase;

/// Twelve items, three types, a few hundred transactions: every set of items can be counted.
TransactionDatabase small_database(Random& random) {
  constexpr std::size_t kItems = 12;
  TransactionDatabase database;
  database.item_count = kItems;
  database.type_count = 3;
  const std::size_t transactions = 50 + random.below(250);
  const double density = random.uniform(0.1, 0.7);
  for (std::size_t t = 0; t < transactions; ++t) {
    std::vector<Item> items;
    for (std::size_t item = 0; item < kItems; ++item) {
      if (random.chance(density)) items.push_back(static_cast<Item>(item));
    }
    database.add(items, static_cast<ActionType>(random.below(3)),
                 static_cast<std::uint32_t>(t / 10));
  }
  return database;
}

/// How many of `databases` small random databases give other rules than brute force does.
int differences_from_brute_force(int databases, Random random) {
  int different = 0;
  for (int i = 0; i < databases; ++i) {
    const TransactionDatabase database = small_database(random);
    const AprioriConfig config{.support_percent = random.uniform(0.5, 8.0),
                               .confidence_percent = random.uniform(35.0, 100.0),
                               .grow_confident = random.chance(0.5)};
    for (ActionType type = 0; type < database.type_count; ++type) {
      if (affordance::mine_rules(database, type, config) !=
          affordance::reference::brute_force(database, type, config)) {
        ++different;
        break;
      }
    }
  }
  return different;
}

/// For how many of the action types the level-wise implementation gives other rules, `jobs` types
/// at once.
int types_that_differ_from_level_wise(const TransactionDatabase& database,
                                      const AprioriConfig& config, int jobs) {
  std::atomic<int> different{0};
  parallel_for(static_cast<std::size_t>(database.type_count), jobs, [&](std::size_t index) {
    const auto type = static_cast<ActionType>(index);
    if (affordance::mine_rules(database, type, config) !=
        affordance::reference::level_wise(database, type, config)) {
      ++different;
    }
  });
  return different;
}

struct Timing {
  double seconds = 0.0;
  double peak_mb = 0.0;
  std::size_t rules = 0;
  std::size_t transactions = 0;
  double mean_items = 0.0;
};

/// Mines all types on one core in a process of its own: its peak memory is the database's and the
/// search's. Making the database is not timed.
Timing timed_mining(const std::function<TransactionDatabase()>& make, const AprioriConfig& config,
                    const StudyContext& context) {
  Timing timing;
  const std::uint32_t only = 0;
  run_in_workers(
      1, {&only, 1},
      [&](std::uint32_t) {
        const OneCore one_core;
        const TransactionDatabase database = make();
        const auto start = std::chrono::steady_clock::now();
        const std::vector<Rule> rules = affordance::mine_rules(database, config);
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
        rusage usage{};
        ::getrusage(RUSAGE_SELF, &usage);
        return nlohmann::json{{"seconds", taken.count()},
                              {"peak_mb", static_cast<double>(usage.ru_maxrss) / 1024.0},
                              {"rules", rules.size()},
                              {"transactions", database.size()},
                              {"mean_items", static_cast<double>(database.items.size()) /
                                                 static_cast<double>(database.size())}}
            .dump();
      },
      [&](std::uint32_t, const std::string& text) {
        const nlohmann::json value = nlohmann::json::parse(text);
        timing = {.seconds = value["seconds"],
                  .peak_mb = value["peak_mb"],
                  .rules = value["rules"],
                  .transactions = value["transactions"],
                  .mean_items = value["mean_items"]};
      },
      context.control.stop);
  if (timing.transactions == 0) throw StudyStopped();
  return timing;
}

StudyResult mine_file(const StudyContext& context) {
  const TransactionDatabase database = affordance::read_transactions(*context.transactions);
  const auto start = std::chrono::steady_clock::now();
  const std::vector<Rule> rules =
      affordance::mine_rules(database, AprioriConfig{}, context.control.jobs);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  if (!context.out.empty()) std::filesystem::create_directories(context.out);
  const std::filesystem::path file = context.out / "rules.txt";
  affordance::write_rules(file, rules);
  StudyResult result;
  result.figures = {{"transactions", database.size()},
                    {"rules", rules.size()},
                    {"seconds", taken.count()},
                    {"rules_file", file.string()}};
  return result;
}

}  // namespace

/// Mining at the thesis's thresholds (6.5.3): exact, and how long it takes.
StudyResult study_apriori(const StudyContext& context, report::Page& page) {
  if (context.transactions) return mine_file(context);
  constexpr int kSmall = 200;
  constexpr int kMillion = 1'000'000;
  constexpr std::uint64_t kSteps = 5;
  const Random random = Random(context.scenario.seed).fork("apriori");
  const AprioriConfig thesis;  // support 0.02 %, confidence 99 %, 3 to 10 items
  const int different_small = differences_from_brute_force(kSmall, random.fork("small"));
  context.control.progress(1, kSteps, "comparisons");

  const int usual = affordance::GeneratedTransactions{}.transactions;
  const auto generate = [&random](int transactions) {
    return [&random, transactions] {
      affordance::GeneratedTransactions generated;
      generated.transactions = transactions;
      return affordance::generate_transactions(generated, random.fork("large"));
    };
  };
  const Timing large = timed_mining(generate(usual), thesis, context);
  context.control.progress(2, kSteps, "comparisons");
  const Timing million = timed_mining(generate(kMillion), thesis, context);
  context.control.progress(3, kSteps, "comparisons");

  const Materials materials(context);
  const std::filesystem::path drives =
      materials.recording(Purpose::kCollect, materials.five_minutes());
  // Recorded pictures repeat: a rule that is confident is not grown, here as in training.
  AprioriConfig least = thesis;
  least.grow_confident = false;
  const Timing recorded = timed_mining(
      [&] {
        const dataset::RecordedDemonstration demonstration(drives);
        return affordance::transactions_of(demonstration, context.scenario.affordance,
                                           chances_of_training(context.scenario));
      },
      least, context);
  context.control.progress(4, kSteps, "comparisons");
  // Last, since a process begins with the memory of the one that it is forked from.
  const int different_large =
      types_that_differ_from_level_wise(generate(usual)(), thesis, context.control.jobs);
  context.control.progress(kSteps, kSteps, "comparisons");

  StudyResult result;
  result.figures = {{"small_databases", kSmall},
                    {"different_from_brute_force", different_small},
                    {"different_from_level_wise", different_large},
                    {"seconds", large.seconds},
                    {"peak_mb", large.peak_mb},
                    {"rules", large.rules},
                    {"seconds_million", million.seconds},
                    {"peak_mb_million", million.peak_mb},
                    {"rules_million", million.rules},
                    {"seconds_recorded", recorded.seconds},
                    {"peak_mb_recorded", recorded.peak_mb},
                    {"mean_items", recorded.mean_items},
                    {"transactions", recorded.transactions},
                    {"rules_recorded", recorded.rules}};
  result.claims = {
      at_most("different_from_brute_force", "exact on small databases", different_small, 0.0),
      at_most("different_from_level_wise", "exact on a large one, for each of six types",
              different_large, 0.0),
      at_most("seconds", "88,810 generated transactions, six types, one core", large.seconds, 2.0),
      at_most("peak_mb", "in little memory", large.peak_mb, 500.0),
      at_most("seconds_million", "1,000,000 of them", million.seconds, 30.0),
      at_most("peak_mb_million", "in 2 GB", million.peak_mb, 2000.0)};
  report::Content& mining = page.section("Mining");
  mining.paragraph(fmt::format(
      "All action types on one core, each database in a process of its own. Support {} %, "
      "confidence {} %, {} to {} items. Rules of recorded transactions hold no other rule.",
      thesis.support_percent, thesis.confidence_percent, thesis.min_items, thesis.max_items));
  report::Table table;
  table.columns = {{.heading = "transactions"},
                   {.heading = "number"},
                   {.heading = "items each", .unit = "", .decimals = 1},
                   {.heading = "rules"},
                   {.heading = "time", .unit = "s"},
                   {.heading = "peak memory", .unit = "MB", .decimals = 0}};
  const auto add = [&](const char* name, const Timing& timing) {
    table.rows.push_back({.cells = {name, timing.transactions, timing.mean_items, timing.rules,
                                    timing.seconds, timing.peak_mb}});
  };
  add("generated", large);
  add("generated", million);
  add("recorded", recorded);
  mining.table(table);
  return result;
}

}  // namespace pacer
