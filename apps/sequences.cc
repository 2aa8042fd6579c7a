// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "apps/command.h"
#include "apps/terminal_progress.h"
#include "core/check.h"
#include "runs/render_sequences.h"

namespace pacer {
namespace {

struct SequencesCommand {
  CommonOptions common;
  std::filesystem::path out;
  std::vector<std::string> names;

  void run(const std::stop_token& stop) const {
    if (!common.set.empty()) throw UsageError("--set: simulated sequences have no scenario");
    keep_apart({}, {out, common.json});
    RunControl control = common.control(stop);
    TerminalProgress progress;
    control.progress = progress.callback();
    const std::uint64_t seed = common.seed.value_or(1);
    const RenderSequencesReport report = render_sequences(names, seed, out, control);
    progress.finish();
    nlohmann::ordered_json json = {{"seed", seed},
                                   {"seconds", report.seconds},
                                   {"sequences", nlohmann::ordered_json::array()}};
    for (const RenderedSequence& one : report.sequences) {
      const auto& [name, about, size, frames] = one.sequence;
      fmt::print("{}: {} frames of {} x {}{}\n", (out / name).string(), frames, size.width,
                 size.height, one.was_there ? ", was there" : "");
      json["sequences"].push_back({{"name", name},
                                   {"about", about},
                                   {"frames", frames},
                                   {"width", size.width},
                                   {"height", size.height},
                                   {"was_there", one.was_there}});
    }
    common.write_json(json);
    if (!report.whole) {
      fmt::print(stderr, "interrupted: the same command goes on from here\n");
      throw Unfinished{};
    }
  }
};

std::string explain() {
  std::string text =
      "Example: pacer sequences --out out/sequences\n"
      "They lie in OTB's layout, and what is there already stays. Simulated are:";
  for (const sim::SimulatedSequence& one : sim::simulated_sequences()) {
    text += fmt::format("\n  {:<18}{}", one.name, one.about);
  }
  return text;
}

}  // namespace

void add_sequences(CLI::App& app, const std::stop_token& stop) {
  auto options = std::make_shared<SequencesCommand>();
  CLI::App* command =
      app.add_subcommand("sequences", "Render the simulated tracking sequences, with their truth");
  command->add_option("NAME", options->names, "Which of them (default: all)");
  command->add_option("--out", options->out, "Folder that each gets a folder in")->required();
  options->common.add_to(*command);
  command->footer(explain());
  command->callback([options, stop] { options->run(stop); });
}

}  // namespace pacer
