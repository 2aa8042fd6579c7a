// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "apps/command.h"
#include "apps/terminal_progress.h"
#include "runs/drive_once.h"

namespace pacer {
namespace {

struct DriveCommand {
  CommonOptions common;
  std::filesystem::path scenario;
  std::string policy = "teacher";
  DriveOptions options;

  void run(const std::stop_token& stop) const {
    keep_apart({scenario, policy}, {options.video, common.json});
    const std::vector<PolicySource> sources = PolicySource::load({policy});
    RunControl control = common.control(stop);
    TerminalProgress progress;
    control.progress = progress.callback();
    const DriveReport report = drive_once(common.load(scenario), sources.front(), options, control);
    progress.finish();
    nlohmann::ordered_json json = {{"frames", report.frames}};
    if (report.score && report.whole) {
      fmt::print("{}: {}\n{}\n", sources.front().name(), verdict(*report.score),
                 summary(*report.score));
      json["score"] = to_json(*report.score);
    } else {
      fmt::print("{}: {} frames\n", sources.front().name(), report.frames);
    }
    if (!options.video.empty() && report.frames > 0)
      fmt::print("{}: the video\n", options.video.string());
    common.write_json(json);
    if (!report.whole) {
      fmt::print(stderr, "interrupted: the episode is not scored\n");
      throw Unfinished{};
    }
  }
};

}  // namespace

void add_drive(CLI::App& app, const std::stop_token& stop) {
  auto options = std::make_shared<DriveCommand>();
  CLI::App* command = app.add_subcommand("drive", "Drive one episode, and film it");
  command->add_option("SCENARIO", options->scenario, "A scenario, e.g. scenarios/follow.yaml")
      ->required();
  command->add_option("--policy", options->policy, "A model file, teacher or neutral")
      ->capture_default_str();
  command->add_option("--episode", options->options.episode, "Which of the unseen episodes")
      ->check(whole_number())
      ->capture_default_str();
  command->add_flag("--demonstrated-rooms", options->options.demonstrated_rooms,
                    "Drive where the teacher recorded, instead of in unseen rooms");
  command->add_flag("--until-the-end", options->options.until_the_end,
                    "Go on when the episode has failed");
  command->add_option("--video", options->options.video, "File of the film (mp4)")
      ->check(film_file());
  options->common.add_to(*command);
  command->footer(
      "Example: pacer drive scenarios/follow.yaml --policy out/follow.model --video out/drive.mp4");
  command->callback([options, stop] { options->run(stop); });
}

}  // namespace pacer
