// SPDX-License-Identifier: Apache-2.0
#include "runs/collect.h"

#include <fmt/format.h>

#include "apps/command.h"
#include "apps/terminal_progress.h"
#include "core/counted.h"

namespace pacer {
namespace {

struct CollectCommand {
  CommonOptions common;
  std::filesystem::path scenario;
  std::filesystem::path out;
  std::uint64_t episodes = 5;

  void run(const std::stop_token& stop) const {
    RunControl control = common.control(stop);
    TerminalProgress progress;
    control.progress = progress.callback();
    const Scenario loaded = common.load(scenario);
    const CollectReport report = collect(loaded, Purpose::kCollect, episodes, out, control);
    progress.finish();
    fmt::print("{}: {} ({} new), {} recorded in {:.1f} s\n", out.string(),
               counted(report.episodes, "episode"), report.episodes - report.resumed_from,
               counted(report.frames, "frame"), report.seconds);
    common.write_json({{"episodes", report.episodes},
                       {"resumed_from", report.resumed_from},
                       {"frames", report.frames},
                       {"seconds", report.seconds},
                       {"worker_peak_mb", report.worker_peak_mb}});
    if (!report.whole) {
      fmt::print(stderr, "interrupted: the same command goes on from here\n");
      throw Unfinished{};
    }
    fmt::print("next: pacer train {} {} --out {}.model\n",
               loaded.what_for() == Goal::kReach ? "exemplar" : "affordance", out.string(),
               out.string());
  }
};

}  // namespace

void add_collect(CLI::App& app, const std::stop_token& stop) {
  auto options = std::make_shared<CollectCommand>();
  CLI::App* command = app.add_subcommand("collect", "Record the scripted teacher, headlessly");
  command->add_option("SCENARIO", options->scenario, "A scenario, e.g. scenarios/follow.yaml")
      ->required();
  command->add_option("--episodes", options->episodes, "Episodes the dataset shall hold")
      ->capture_default_str()
      ->check(CLI::Range(1, 16384));
  command->add_option("--out", options->out, "Folder of the dataset (LeRobotDataset v3.0)")
      ->required();
  options->common.add_to(*command);
  command->footer(
      "Example: pacer collect scenarios/follow.yaml --episodes 5 --out out/drives\n"
      "Interrupted or killed, the same command goes on where it stopped.");
  command->callback([options, stop] { options->run(stop); });
}

}  // namespace pacer
