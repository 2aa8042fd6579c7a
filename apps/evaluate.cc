// SPDX-License-Identifier: Apache-2.0
#include "runs/evaluate.h"

#include <fmt/format.h>

#include "apps/command.h"
#include "apps/terminal_progress.h"
#include "runs/evaluation_report.h"

namespace pacer {
namespace {

struct EvaluateCommand {
  CommonOptions common;
  std::filesystem::path scenario;
  std::filesystem::path out;
  std::vector<std::string> policies;
  EvaluateOptions options;

  void run(const std::stop_token& stop) const {
    keep_apart({scenario}, {out, common.json});
    keep_apart({policies.begin(), policies.end()}, {out, common.json});
    const Scenario loaded = common.load(scenario);
    const std::vector<PolicySource> sources = PolicySource::load(policies);
    RunControl control = common.control(stop);
    TerminalProgress progress;
    control.progress = progress.callback();
    const EvaluationRun result = evaluate(loaded, sources, options, control);
    progress.finish();
    fmt::print("{}\n", report::markdown(score_table(result.evaluation)));
    if (!out.empty()) {
      evaluation_page(loaded, sources, result).write(out);
      fmt::print("{}: the report; open it in a browser\n", out.string());
    }
    common.write_json(to_json(result.evaluation));
    if (!result.whole) {
      fmt::print(stderr, "interrupted: the table holds the episodes that were finished\n");
      throw Unfinished{};
    }
  }
};

}  // namespace

void add_evaluate(CLI::App& app, const std::stop_token& stop) {
  auto options = std::make_shared<EvaluateCommand>();
  CLI::App* command =
      app.add_subcommand("evaluate", "Drive policies over the same unseen episodes, and score");
  command->add_option("SCENARIO", options->scenario, "A scenario, e.g. scenarios/follow.yaml")
      ->required();
  command
      ->add_option("--policy", options->policies,
                   "Model files, or teacher, neutral, mean (the first model's mean command)")
      ->required();
  command->add_option("--episodes", options->options.episodes, "Unseen episodes a policy")
      ->capture_default_str()
      ->check(CLI::Range(1, 2000));
  command->add_option("--clips", options->options.clips, "Filmed episodes a policy")
      ->check(whole_number())
      ->capture_default_str();
  command->add_option("--out", options->out, "File of the report (HTML)")->check(writable_file());
  options->common.add_to(*command);
  command->footer(
      "Example: pacer evaluate scenarios/follow.yaml --policy out/follow.model teacher neutral "
      "mean --out out/report.html");
  command->callback([options, stop] { options->run(stop); });
}

}  // namespace pacer
