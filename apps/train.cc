// SPDX-License-Identifier: Apache-2.0
#include "runs/train.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "apps/command.h"
#include "apps/terminal_progress.h"
#include "core/check.h"
#include "dataset/reader.h"
#include "runs/training_report.h"

namespace pacer {
namespace {

struct TrainCommand {
  CommonOptions common;
  std::string method;
  std::filesystem::path dataset;
  std::filesystem::path onto;
  std::filesystem::path out;

  void run(const std::stop_token& stop) const {
    keep_apart({dataset, onto}, {out, common.json});
    if (!onto.empty() && !common.set.empty()) {
      throw UsageError(fmt::format("--set {}: {} keeps its settings as it grows; leave --set out",
                                   common.set.front(), onto.string()));
    }
    const std::string source = (dataset / "meta" / "scenario.yaml").string();
    const std::string recorded = dataset::Dataset(dataset).scenario();
    const Scenario scenario = parse_scenario(recorded, source, common.overrides());
    if (!recorded.empty()) {
      require_as_recorded(scenario, parse_scenario(recorded, source));
      require_demonstrated(scenario);
    }
    const std::string drive = recorded.empty() ? "SCENARIO" : source;  // what it can be driven in
    RunControl control = common.control(stop);
    TerminalProgress progress;
    control.progress = progress.callback();
    if (method == "exemplar") {
      const auto report = train_exemplar(scenario, dataset, onto, out, control);
      progress.finish();
      tell(report, drive);
      return;
    }
    if (!onto.empty()) throw UsageError("--onto: only exemplar models grow");
    if (method == "affordance") {
      const auto report = train_affordance(scenario, dataset, out, control);
      progress.finish();
      tell(report, drive);
    } else {
      const auto report = train_baseline(scenario, method, dataset, out, control);
      progress.finish();
      tell(report, drive);
    }
  }

 private:
  /// What was recorded cannot be set any more; how it is learnt can.
  void require_as_recorded(Scenario wanted, const Scenario& recorded) const {
    wanted.affordance = recorded.affordance;
    wanted.exemplar = recorded.exemplar;
    wanted.seed = recorded.seed;
    if (to_yaml(wanted) == to_yaml(recorded)) return;
    const auto is_of_recording = [](const std::string& assignment) {
      constexpr std::array<std::string_view, 3> kLearnt = {"affordance", "exemplar", "seed"};
      return std::ranges::find(kLearnt, assignment.substr(0, assignment.find_first_of(".="))) ==
             kLearnt.end();
    };
    const auto named = std::ranges::find_if(common.set, is_of_recording);
    throw UsageError(
        fmt::format("--set {}: {} was recorded otherwise; only affordance.*, exemplar.* and seed "
                    "can be set to learn from it",
                    named == common.set.end() ? "" : *named, dataset.string()));
  }

  /// Throws where the teacher showed something else than `method` learns.
  void require_demonstrated(const Scenario& scenario) const {
    const bool by_impulses = method == "exemplar";
    if ((scenario.what_for() == Goal::kReach) == by_impulses) return;
    throw UsageError(
        fmt::format("{}: was recorded with goal: {}, and {} learns from goal: {}; collect it with "
                    "scenarios/{}.yaml, or train {}",
                    dataset.string(), scenario.goal, method, by_impulses ? "reach" : "follow",
                    by_impulses ? "balloon" : "follow", by_impulses ? "affordance" : "exemplar"));
  }

  template <class Report>
  void tell(const Report& report, const std::string& scenario) const {
    fmt::print("{}", to_text(report));
    fmt::print("{}: written\nnext: pacer evaluate {} --policy {} teacher --out out/report.html\n",
               out.string(), scenario, out.string());
    common.write_json(to_json(report));
  }
};

}  // namespace

void add_train(CLI::App& app, const std::stop_token& stop) {
  auto options = std::make_shared<TrainCommand>();
  CLI::App* command = app.add_subcommand("train", "Learn to drive from a recorded dataset");
  std::vector<std::string> methods = {"affordance", "exemplar"};
  methods.insert(methods.end(), baseline_methods().begin(), baseline_methods().end());
  command
      ->add_option("METHOD", options->method,
                   fmt::format("How: affordance (chapter 6), exemplar (chapter 5), or a baseline: "
                               "{}",
                               fmt::join(baseline_methods(), ", ")))
      ->required()
      ->check(CLI::IsMember(methods));
  command->add_option("DATASET", options->dataset, "Folder of the dataset")->required();
  command->add_option("--out", options->out, "File of the model")->required()->check(model_file());
  command
      ->add_option("--onto", options->onto,
                   "exemplar: a model that the dataset's exemplars are added to, as corrections")
      ->check(CLI::ExistingFile);
  options->common.add_to(*command);
  command->footer(
      "Example: pacer train affordance out/drives --out out/follow.model\n"
      "         pacer train exemplar out/clicks --out out/balloon.model\n"
      "         pacer train supervised out/drives --out out/supervised.model\n"
      "The scenario is the one recorded with the dataset; --set changes how it is learnt.");
  command->callback([options, stop] { options->run(stop); });
}

}  // namespace pacer
