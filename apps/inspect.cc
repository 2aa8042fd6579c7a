// SPDX-License-Identifier: Apache-2.0
#include "dataset/inspect.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <opencv2/imgcodecs.hpp>
#include <vector>

#include "apps/command.h"
#include "core/check.h"
#include "core/output_file.h"
#include "dataset/contact_sheet.h"
#include "learning/affordance/model.h"

namespace pacer {
namespace {

struct InspectCommand {
  CommonOptions common;
  std::filesystem::path what;
  std::filesystem::path sheet;
  bool mend = false;
  bool quick = false;

  void run() const {
    keep_apart({what}, {sheet, common.json});
    if (std::filesystem::is_directory(what)) {
      inspect_dataset();
    } else if (what.extension() == ".yaml" || what.extension() == ".yml") {
      const std::string yaml = to_yaml(common.load(what));
      fmt::print("{}", yaml);
      common.write_json({{"scenario", yaml}});
    } else if (std::filesystem::is_regular_file(what)) {
      inspect_model();
    } else {
      throw UsageError(what.string() + ": no such dataset, model or scenario");
    }
  }

 private:
  /// What the scenario recorded with the dataset says its task is; the usual one where that cannot
  /// be read.
  [[nodiscard]] std::string recorded_task() const {
    try {
      return load_scenario(what / "meta" / "scenario.yaml").task;
    } catch (const UsageError&) {
      return Scenario{}.task;
    }
  }

  /// The scenario recorded with it has to be one.
  void check_scenario(dataset::Inspection& found) const {
    const std::filesystem::path scenario = what / "meta" / "scenario.yaml";
    std::error_code error;
    if (!std::filesystem::is_regular_file(scenario, error)) return;  // found missing, if it is ours
    try {
      (void)load_scenario(scenario);
    } catch (const UsageError& fault) {
      found.findings.push_back({.where = "meta/scenario.yaml", .what = fault.what()});
    }
  }

  void inspect_dataset() const {
    if (mend) {
      for (const std::string& line : dataset::repair(what, recorded_task())) {
        fmt::print("mended  {}\n", line);
      }
    }
    dataset::Inspection found =
        dataset::inspect(what, quick ? dataset::Depth::kTables : dataset::Depth::kAll);
    check_scenario(found);
    const dataset::DatasetSummary& summary = found.summary;
    fmt::print("{}: {} episodes, {} frames, {:.1f} s of {} x {} at {} Hz, {:.1f} MB\n",
               what.string(), summary.episodes, summary.frames, summary.seconds,
               summary.image_size.width, summary.image_size.height, summary.rate_hz,
               static_cast<double>(summary.bytes) / 1e6);
    fmt::print("task    {}\n", summary.task);
    for (const auto& [driver, frames] : summary.driven_by) {
      fmt::print("driven  by {}: {} frames\n", driver, frames);
    }
    if (summary.unfinished > 0) {
      fmt::print("aside   {} unfinished episodes; the next collect goes on from them\n",
                 summary.unfinished);
    }
    nlohmann::ordered_json findings = nlohmann::ordered_json::array();
    for (const dataset::Finding& finding : found.findings) {
      fmt::print("{}  {}: {}\n", finding.harms ? "FAULT " : "note  ", finding.where, finding.what);
      findings.push_back(
          {{"where", finding.where}, {"what", finding.what}, {"harms", finding.harms}});
    }
    if (!sheet.empty()) {
      std::vector<std::uint8_t> png;
      if (!cv::imencode(".png", dataset::contact_sheet(dataset::Dataset(what)), png)) {
        throw std::runtime_error(sheet.string() + ": OpenCV cannot draw it");
      }
      OutputFile file(sheet);
      file.write({reinterpret_cast<const char*>(png.data()), png.size()});
      file.keep();
      fmt::print("{}: the contact sheet\n", sheet.string());
    }
    common.write_json({{"episodes", summary.episodes},
                       {"frames", summary.frames},
                       {"seconds", summary.seconds},
                       {"whole", found.whole()},
                       {"findings", findings}});
    if (!found.whole()) {
      const bool readable = std::ranges::none_of(
          found.findings, [](const dataset::Finding& finding) { return finding.where == "meta"; });
      if (readable) {
        fmt::print("not whole; `pacer inspect {} --repair` keeps what is\n", what.string());
      } else {
        fmt::print("not whole, and beyond repair: put back the file named, or record anew\n");
      }
      throw Unfinished{};
    }
    fmt::print("whole{}\n", summary.episodes == 0 ? ", and empty: `pacer collect` fills it" : "");
  }

  void inspect_model() const {
    const affordance::Model model = affordance::load(what);
    fmt::print("{}: affordance model, format {}, {} rules, for {} x {} at {} Hz\n", what.string(),
               affordance::Model::kVersion, model.rules.size(), model.image_size.width,
               model.image_size.height, model.frame_rate_hz);
    fmt::print("learnt from {}\n", model.fingerprint);
    nlohmann::ordered_json types = nlohmann::ordered_json::array();
    for (int type = 0; type < model.actions.count(); ++type) {
      const auto index = static_cast<affordance::ActionType>(type);
      const Command centre = model.actions.centre(index);
      std::size_t rules = 0;
      for (const affordance::Rule& rule : model.rules) rules += rule.type == index ? 1 : 0;
      const std::string& name = model.actions.names[index];
      fmt::print("{:<16} steering {:+.2f}, throttle {:+.2f}: {} rules\n", name, centre.steering,
                 centre.throttle, rules);
      types.push_back({{"name", name},
                       {"steering", centre.steering},
                       {"throttle", centre.throttle},
                       {"rules", rules}});
    }
    common.write_json({{"fingerprint", model.fingerprint},
                       {"rules", model.rules.size()},
                       {"action_types", types}});
  }
};

}  // namespace

void add_inspect(CLI::App& app, const std::stop_token&) {
  auto options = std::make_shared<InspectCommand>();
  CLI::App* command =
      app.add_subcommand("inspect", "What is in a dataset, model or scenario, and is it whole");
  command->add_option("WHAT", options->what, "A dataset's folder, a model or a scenario file")
      ->required();
  command->add_option("--sheet", options->sheet, "Draw a dataset's contact sheet (PNG)")
      ->check(writable_file());
  command->add_flag("--repair", options->mend,
                    "Keep a dataset's episodes before the first that is damaged, and move the rest "
                    "to .dropped");
  command->add_flag("--quick", options->quick, "Leave out the videos");
  options->common.add_to(*command);
  command->footer("Example: pacer inspect out/drives --sheet out/drives.png");
  command->callback([options] { options->run(); });
}

}  // namespace pacer
