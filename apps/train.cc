// SPDX-License-Identifier: Apache-2.0
#include "runs/train.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <vector>

#include "apps/command.h"
#include "apps/terminal_progress.h"
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
    const dataset::Dataset recorded(dataset);
    const std::string source = (dataset / "meta" / "scenario.yaml").string();
    const Scenario scenario = parse_scenario(recorded.scenario(), source, common.overrides());
    RunControl control = common.control(stop);
    TerminalProgress progress;
    control.progress = progress.callback();
    if (method == "exemplar") {
      const auto report = train_exemplar(scenario, dataset, onto, out, control);
      progress.finish();
      tell(report, "balloon");
      return;
    }
    if (!onto.empty()) throw UsageError("--onto: only exemplar models grow");
    if (method == "affordance") {
      const auto report = train_affordance(scenario, dataset, out, control);
      progress.finish();
      tell(report, "follow");
    } else {
      const auto report = train_baseline(scenario, method, dataset, out, control);
      progress.finish();
      tell(report, "follow");
    }
  }

 private:
  template <class Report>
  void tell(const Report& report, const char* scenario) const {
    fmt::print("{}", to_text(report));
    fmt::print(
        "{}: written\nnext: pacer evaluate scenarios/{}.yaml --policy {} teacher "
        "--out out/report.html\n",
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
  command->add_option("--out", options->out, "File of the model")
      ->required()
      ->check(writable_file());
  command
      ->add_option("--onto", options->onto,
                   "exemplar: a model that the dataset's exemplars are added to, as corrections")
      ->check(CLI::ExistingFile);
  options->common.add_to(*command);
  command->footer(
      "Example: pacer train affordance out/drives --out out/follow.model\n"
      "         pacer train exemplar out/balloon --out out/balloon.model\n"
      "         pacer train supervised out/drives --out out/supervised.model\n"
      "The scenario is the one recorded with the dataset; --set changes it.");
  command->callback([options, stop] { options->run(stop); });
}

}  // namespace pacer
