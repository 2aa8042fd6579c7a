// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/train.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <mutex>

#include "core/check.h"
#include "core/parallel.h"
#include "learning/affordance/evidence.h"
#include "learning/affordance/feature_sample.h"
#include "learning/affordance/rule_matches.h"
#include "learning/affordance/rule_search.h"
#include "learning/affordance/rule_selection.h"
#include "learning/affordance/support_search.h"
#include "learning/affordance/transactions.h"

namespace pacer::affordance {
namespace {

/// What the first reading notes of an episode.
struct Survey {
  std::vector<Command> commands;  // of every frame
  std::vector<char> counts;       // whether the frame differs from the ones before
  std::uint64_t counted = 0;      // how many do
  std::uint64_t before = 0;       // how many did in the episodes before
};

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
    stage("survey", [&] { survey(); });
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
    const std::scoped_lock lock(telling_);
    if (options_.progress) options_.progress(stage_, share);
  }

  /// Streams every episode, each on one thread: visit(episode, index of the step, step).
  template <class Visit>
  void read_episodes(const Visit& visit) {
    std::atomic<std::size_t> done{0};
    const std::size_t episodes = demonstration_.episode_count();
    parallel_for(episodes, options_.jobs, [&](std::size_t episode) {
      const auto stream = demonstration_.open(episode);
      std::size_t index = 0;
      auto step_visit = visit(episode);
      while (const DemonstratedStep* step = stream->next()) {
        if (options_.stop.stop_requested()) throw TrainingStopped();
        if (step->frame->size != model_.image_size) {
          throw std::runtime_error("episode " + std::to_string(episode) +
                                   ": a frame's size is not the recording's");
        }
        step_visit(index++, *step);
      }
      step_visit.finish();
      tell(static_cast<double>(++done) / static_cast<double>(episodes));
    });
  }

  void survey();
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
  std::mutex telling_;

  std::vector<Survey> surveys_;  // an episode each
  FeatureSample sample_{0};
  std::vector<FeatureLog> logs_;  // an episode each
  TransactionDatabase database_;
  Model model_;
  TrainingReport report_;
};

void Trainer::survey() {
  struct Visit {
    Trainer& trainer;
    Survey& survey;
    ChangeDetector changes;
    FeatureExtractor extractor;
    FeatureSample sample;
    Random random;
    std::size_t stride;
    std::mutex& merging;
    Features features{};

    void operator()(std::size_t, const DemonstratedStep& step) {
      const bool counts = changes.counts(*step.frame, step.command);
      survey.commands.push_back(step.command);
      survey.counts.push_back(counts ? 1 : 0);
      if (!counts || survey.counted++ % stride != 0) return;
      extractor.extract(*step.frame, features);
      for (std::size_t i = 0; i < features.count(); ++i) sample.offer(random.next(), features, i);
    }
    void finish() {
      const std::scoped_lock lock(merging);
      trainer.sample_.merge(sample);
    }
  };
  const double stride = std::round(config_.words.every * model_.frame_rate_hz);
  const auto samples = static_cast<std::size_t>(config_.words.samples);
  std::mutex merging;
  sample_ = FeatureSample(samples);
  surveys_.resize(demonstration_.episode_count());
  read_episodes([&](std::size_t episode) {
    return Visit{.trainer = *this,
                 .survey = surveys_[episode],
                 .changes = ChangeDetector(config_.transactions),
                 .extractor = FeatureExtractor(config_.features),
                 .sample = FeatureSample(samples),
                 .random = random_.fork("word sample", episode),
                 .stride = std::max<std::size_t>(1, static_cast<std::size_t>(stride)),
                 .merging = merging};
  });
}

void Trainer::find_action_types() {
  std::vector<Command> commands;
  for (Survey& survey : surveys_) {
    commands.insert(commands.end(), survey.commands.begin(), survey.commands.end());
    survey.commands = {};
    survey.before = report_.frames_counted;
    report_.frames_counted += survey.counted;
  }
  report_.episodes = surveys_.size();
  report_.frames = commands.size();
  if (commands.empty()) throw UsageError("the demonstration holds no frames; record some first");
  model_.actions = cluster_actions(commands, config_.actions, random_.fork("action types"));
  if (model_.actions.one_action()) {
    throw UsageError(
        "the demonstration holds one action only, so there is nothing to tell apart; demonstrate "
        "turns and speeds");
  }
}

void Trainer::build_words() {
  const Features sample = sample_.take();
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
  struct Visit {
    const Model& model;
    const Survey& survey;
    FeatureLog& log;
    FeatureExtractor extractor;
    std::uint64_t counted;  // in the whole recording
    std::uint64_t most;
    Seconds stretch;
    std::uint64_t number = 0;  // of the frame among those
    Seconds start{};
    Features features{};
    Words words{};

    void operator()(std::size_t index, const DemonstratedStep& step) {
      if (index == 0) start = step.frame->time;
      check(index < survey.counts.size(), "a recording reads the same twice");
      if (survey.counts[index] == 0 || !taken(number++, counted, most)) return;
      extractor.extract(*step.frame, features);
      model.vocabulary.label(features, words);
      const double stretches = std::max(0.0, (step.frame->time - start) / stretch);
      log.add(features, words, step.command, model.actions.assign(step.command),
              static_cast<std::uint32_t>(std::min(stretches, 1e9)));
    }
    void finish() {}
  };
  logs_.resize(demonstration_.episode_count());
  read_episodes([&](std::size_t episode) {
    return Visit{.model = model_,
                 .survey = surveys_[episode],
                 .log = logs_[episode],
                 .extractor = FeatureExtractor(config_.features),
                 .counted = report_.frames_counted,
                 .most = static_cast<std::uint64_t>(config_.transactions.most_frames),
                 .stretch = config_.transactions.stretch,
                 .number = surveys_[episode].before};
  });
  surveys_.clear();
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
    mappings[r].residual = held_out_error(mappings[r], examples.poses, examples.actions,
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
