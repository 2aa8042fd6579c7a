// SPDX-License-Identifier: Apache-2.0
#include "runs/train.h"

#include <fmt/format.h>

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
    } else {
      if (!onto.empty()) throw UsageError("--onto: only exemplar models grow");
      const auto report = train_affordance(scenario, dataset, out, control);
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
  command
      ->add_option("METHOD", options->method, "How: affordance (chapter 6) or exemplar (chapter 5)")
      ->required()
      ->check(CLI::IsMember({"affordance", "exemplar"}));
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
      "The scenario is the one recorded with the dataset; --set changes it.");
  command->callback([options, stop] { options->run(stop); });
}

}  // namespace pacer
