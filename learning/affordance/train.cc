// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/train.h"

#include <algorithm>
#include <chrono>

#include "core/check.h"
#include "core/parallel.h"
#include "learning/affordance/evidence.h"
#include "learning/affordance/rule_matches.h"
#include "learning/affordance/rule_search.h"
#include "learning/affordance/rule_selection.h"
#include "learning/affordance/support_search.h"
#include "learning/affordance/survey.h"
#include "learning/affordance/transactions.h"
#include "learning/read_episodes.h"

namespace pacer::affordance {
namespace {

class Trainer {
 public:
  Trainer(const Demonstration& demonstration, const AffordanceConfig& config, const Random& random,
          const TrainingOptions& options)
      : demonstration_(demonstration), config_(config), random_(random), options_(options) {
    config.validate();
    model_.config = config;
    model_.image_size = demonstration.image_size();
    model_.frame_rate_hz = demonstration.frame_rate_hz();
    model_.scenario = options.scenario;
    model_.fingerprint = demonstration.fingerprint();
  }

  TransactionDatabase gather() {
    stage("survey", [&] { survey_ = survey(demonstration_, config_, random_, options_); });
    stage("action types", [&] { find_action_types(); });  // 6.3
    stage("words", [&] { build_words(); });               // 6.5
    stage("features", [&] { read_features(); });          // 6.5
    stage("transactions", [&] { build_database(); });     // 6.5.1, 6.5.2
    return std::move(database_);
  }

  Training run() {
    database_ = gather();
    stage("rules", [&] { mine(); });               // 6.5.3
    stage("mappings", [&] { learn_mappings(); });  // 6.6.1
    return {std::move(model_), std::move(report_)};
  }

 private:
  template <class Work>
  void stage(const char* name, const Work& work) {
    stage_ = name;
    tell(0.0);
    const auto start = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    report_.stages.push_back({name, took.count()});
    tell(1.0);
  }

  void tell(double share) {
    if (options_.progress) options_.progress(stage_, share);
  }

  void find_action_types();
  void build_words();
  void read_features();
  void build_database();
  void mine();
  void learn_mappings();

  const Demonstration& demonstration_;
  const AffordanceConfig& config_;
  const Random& random_;
  const TrainingOptions& options_;
  const char* stage_ = "";

  Survey survey_;
  std::vector<FeatureLog> logs_;  // an episode each
  TransactionDatabase database_;
  Model model_;
  TrainingReport report_;
};

void Trainer::find_action_types() {
  for (const Survey::Episode& episode : survey_.episodes) {
    report_.frames += episode.commands.size();
  }
  std::vector<Command> commands;
  commands.reserve(report_.frames);
  for (Survey::Episode& episode : survey_.episodes) {
    commands.insert(commands.end(), episode.commands.begin(), episode.commands.end());
    episode.commands = std::vector<Command>();
  }
  report_.episodes = survey_.episodes.size();
  report_.frames_counted = survey_.counted;
  if (commands.empty()) throw UsageError("the demonstration holds no frames; record some first");
  model_.actions = cluster_actions(commands, config_.actions, random_.fork("action types"));
  if (model_.actions.one_action()) {
    throw UsageError(
        "the demonstration holds one action only, so there is nothing to tell apart; demonstrate "
        "turns and speeds");
  }
}

void Trainer::build_words() {
  const Features sample = survey_.sample.take();
  report_.word_samples = sample.count();
  std::vector<FeatureKind> kinds;
  for (const std::string& name : config_.features.kinds) {
    if (std::ranges::find(sample.kinds, static_cast<std::uint8_t>(kinds.size())) ==
        sample.kinds.end()) {
      throw UsageError(
          "the demonstration's pictures hold no features" + (kinds.empty() ? "" : " of " + name) +
          "; see features.top, features.max_size_px, features.contrast and features.kinds");
    }
    kinds.push_back(*feature_kind(name));
  }
  model_.vocabulary = build_vocabulary(sample, kinds, config_.words, random_.fork("words"));
}

void Trainer::read_features() {
  const auto most = static_cast<std::uint64_t>(config_.transactions.most_frames);
  logs_.resize(survey_.episodes.size());
  read_episodes(demonstration_, options_, stage_, [&](std::size_t number, auto& steps) {
    const Survey::Episode& episode = survey_.episodes[number];
    FeatureLog& log = logs_[number];
    FeatureExtractor extractor(config_.features);
    Features features;
    Words words;
    Seconds start{};
    std::uint64_t counted = episode.before;
    for (std::size_t i = 0; const DemonstratedStep* step = steps.next(); ++i) {
      check(i < episode.counts.size(), "a recording reads the same twice");
      if (i == 0) start = step->frame->time;
      if (episode.counts[i] == 0 || !taken(counted++, survey_.counted, most)) continue;
      extractor.extract(*step->frame, features);
      model_.vocabulary.label(features, words);
      const double stretches =
          std::max(0.0, (step->frame->time - start) / config_.transactions.stretch);
      log.add(features, words, step->command, model_.actions.assign(step->command),
              static_cast<std::uint32_t>(std::min(stretches, 1e9)));
    }
  });
  survey_ = {};
  for (const FeatureLog& log : logs_) {
    report_.features += log.poses.count();
    report_.frames_learnt += log.frame_count();
  }
}

void Trainer::build_database() {
  database_ = build_transactions(logs_, ItemLayout(model_.vocabulary), config_.grid,
                                 config_.transactions, model_.actions.count());
  report_.transactions = database_.size();
  report_.items = database_.items.size();
  report_.types.resize(static_cast<std::size_t>(model_.actions.count()));
  for (std::size_t t = 0; t < report_.types.size(); ++t) {
    report_.types[t].name = model_.actions.names[t];
    report_.types[t].centre = model_.actions.centre(static_cast<ActionType>(t));
  }
  for (const ActionType type : database_.types) ++report_.types[type].transactions;
  for (const FeatureLog& log : logs_) {
    for (const ActionType type : log.types) ++report_.types[type].frames;
  }
}

void Trainer::mine() {
  const auto types = static_cast<std::size_t>(model_.actions.count());
  std::vector<std::vector<Rule>> selected(types);
  // A type a thread; where there are threads to spare, several within a type.
  const int jobs_a_type = std::max(1, options_.jobs / model_.actions.count());
  parallel_for(types, options_.jobs, [&](std::size_t t) {
    if (options_.stop.stop_requested()) throw TrainingStopped();
    TrainingReport::Type& report = report_.types[t];
    const auto type = static_cast<ActionType>(t);
    AprioriConfig mining = config_.mining;
    // Rules of fewer transactions than of stretches there are none; those of one mean nothing.
    if (mining.wanted_rules > 0) {
      mining.support_percent = support_percent_of(
          static_cast<std::uint32_t>(std::max(2, mining.min_stretches)), database_.size());
    }
    // Where the support asked for would give more rules than are wanted, or can be chosen from, the
    // lowest that does not.
    const int most =
        mining.wanted_rules > 0 ? mining.wanted_rules : config_.selection.max_candidates;
    const SupportChoice choice = support_for_rule_count(
        database_, type, mining, static_cast<std::size_t>(most), jobs_a_type, options_.stop);
    const bool raised = mining.wanted_rules == 0 &&
                        choice.min_count > Thresholds(mining, database_.size()).min_count;
    mining.support_percent = choice.support_percent;
    std::vector<Rule> rules = mine_rules(database_, type, mining, jobs_a_type, options_.stop);
    if (options_.stop.stop_requested()) throw TrainingStopped();
    report.support_percent = mining.support_percent;
    report.mined = rules.size();
    Selection selection = select_rules(database_, std::move(rules), config_.selection);
    if (raised)
      selection.capped += selection.capped.empty() ? "support raised" : ", support raised";
    selected[t] = std::move(selection.rules);
    report.selected = selected[t].size();
    report.capped = selection.capped;
  });
  for (const std::vector<Rule>& rules : selected) {
    model_.rules.insert(model_.rules.end(), rules.begin(), rules.end());
  }
  model_.frequency = item_frequency(database_);
  database_ = {};
}

void Trainer::learn_mappings() {
  const RuleMatcher matcher(model_.rules, model_.frequency);
  std::vector<EpisodeMatches> matches(logs_.size());
  parallel_for(logs_.size(), options_.jobs, [&](std::size_t episode) {
    if (options_.stop.stop_requested()) throw TrainingStopped();
    matches[episode] = find_matches(logs_[episode], model_.rules, matcher,
                                    ItemLayout(model_.vocabulary), config_.grid);
  });
  const MatchIndex index(matches, model_.rules.size());
  std::vector<Mapping> mappings(model_.rules.size());
  parallel_for(model_.rules.size(), options_.jobs, [&](std::size_t r) {
    if (index.count(r) < static_cast<std::size_t>(config_.mapping.min_matches)) return;
    const MappingExamples examples = gather_examples(logs_, matches, index, r);
    mappings[r] = fit_mapping(examples.poses, examples.actions, config_.mapping);
    mappings[r].held_out = held_out_error(mappings[r], examples.poses, examples.actions,
                                          examples.stretches, config_.mapping.ridge);
  });

  std::vector<char> kept(model_.rules.size(), 0);
  std::vector<Rule> rules;
  for (std::size_t r = 0; r < model_.rules.size(); ++r) {
    if (mappings[r].matches == 0) continue;  // too few for a mapping
    kept[r] = 1;
    report_.matches += mappings[r].matches;
    ++report_.types[model_.rules[r].type].kept;
    rules.push_back(std::move(model_.rules[r]));
    model_.mappings.push_back(std::move(mappings[r]));
  }
  model_.rules = std::move(rules);
  for (const EpisodeMatches& episode : matches) report_.frames_matched += episode.frames(kept);
  model_.frames_learnt = report_.frames_learnt;
  model_.frames_matched = report_.frames_matched;
  if (model_.rules.empty()) {
    throw NothingLearnt(
        "no rule holds in the demonstration: it is too short or too uniform (the shipped scenario "
        "wants about two minutes); record more, or lower affordance.mining.support_percent");
  }
  model_.matcher = RuleMatcher(model_.rules, model_.frequency);
  model_.typical_witnesses = typical_witnesses(logs_, matches, kept, config_.grid);
}

}  // namespace

TransactionDatabase transactions_of(const Demonstration& demonstration,
                                    const AffordanceConfig& config, const Random& random,
                                    const TrainingOptions& options) {
  const SettledLag lag = settle_lag(demonstration, config, random, options);
  return Trainer(AnsweredDemonstration(demonstration, lag.frames), lag.config, random, options)
      .gather();
}

Training train(const Demonstration& demonstration, const AffordanceConfig& config,
               const Random& random, const TrainingOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const SettledLag lag = settle_lag(demonstration, config, random, options);
  const std::chrono::duration<double> finding = std::chrono::steady_clock::now() - start;
  const AnsweredDemonstration answered(demonstration, lag.frames);
  Training training = Trainer(answered, lag.config, random, options).run();
  TrainingReport& report = training.report;
  report.lag = Seconds{static_cast<double>(lag.frames) / demonstration.frame_rate_hz()};
  report.found = lag.found;
  report.knowledge = knowledge_of(training.model);
  if (lag.found) report.stages.insert(report.stages.begin(), {"lag", finding.count()});
  return training;
}

}  // namespace pacer::affordance
