// SPDX-License-Identifier: Apache-2.0
#include "dataset/inspect.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "apps/command.h"
#include "core/check.h"
#include "core/counted.h"
#include "core/output_file.h"
#include "dataset/contact_sheet.h"
#include "learning/exemplar/policy_model.h"
#include "runs/hierarchy_picture.h"
#include "runs/model_description.h"
#include "runs/model_kinds.h"
#include "runs/report/canvas.h"

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
    const bool folder = std::filesystem::is_directory(what);
    const bool scenario = !folder && (what.extension() == ".yaml" || what.extension() == ".yml");
    if (!folder) {
      refuse(mend, "--repair", "only a dataset can be repaired");
      refuse(quick, "--quick", "only a dataset has videos");
    }
    if (scenario) refuse(!sheet.empty(), "--sheet", "a scenario has no picture");
    if (folder) {
      inspect_dataset();
    } else if (scenario) {
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
  /// Throws when an option was `given` that does not go with what is inspected.
  void refuse(bool given, const char* option, const char* why) const {
    if (given) throw UsageError(fmt::format("{} {}: {}; leave it out", option, what.string(), why));
  }

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
    fmt::print("{}: {}, {}, {:.1f} s of {} x {} at {} Hz, {:.1f} MB\n", what.string(),
               counted(static_cast<std::uint64_t>(summary.episodes), "episode"),
               counted(static_cast<std::uint64_t>(summary.frames), "frame"), summary.seconds,
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
      write_sheet(dataset::contact_sheet(dataset::Dataset(what)));
      const auto drawn = static_cast<std::int64_t>(dataset::ContactSheetOptions{}.most_episodes);
      fmt::print("{}: the contact sheet{}\n", sheet.string(),
                 drawn < summary.episodes
                     ? fmt::format(", {} of the {} episodes", drawn, summary.episodes)
                     : "");
    }
    common.write_json({{"episodes", summary.episodes},
                       {"frames", summary.frames},
                       {"seconds", summary.seconds},
                       {"whole", found.whole()},
                       {"findings", findings}});
    if (!found.whole()) {
      const bool readable = std::ranges::none_of(
          found.findings,
          [](const dataset::Finding& finding) { return finding.where == "meta" || finding.lost; });
      if (readable) {
        fmt::print("not whole; `pacer inspect {} --repair` keeps what is\n", what.string());
      } else {
        fmt::print("not whole, and beyond repair: put back the file named, or record anew\n");
      }
      throw Unfinished{};
    }
    fmt::print("whole{}\n", summary.episodes == 0 ? ", and empty: `pacer collect` fills it" : "");
  }

  /// `bgr`, as PNG.
  void write_sheet(const cv::Mat& bgr) const {
    std::vector<std::uint8_t> png;
    if (!cv::imencode(".png", bgr, png)) {
      throw std::runtime_error(sheet.string() + ": OpenCV cannot draw it");
    }
    OutputFile file(sheet);
    file.write({reinterpret_cast<const char*>(png.data()), png.size()});
    file.keep();
  }

  void inspect_model() const {
    const LoadedModel loaded = load_model(what);
    const ModelDescription about = loaded.kind->describe(*loaded.model);
    fmt::print("{}: {}", what.string(), about.text);
    const auto* exemplars = dynamic_cast<const exemplar::ExemplarPolicyModel*>(loaded.model.get());
    refuse(!sheet.empty() && exemplars == nullptr, "--sheet",
           "only an exemplar model has a picture, its hierarchy");
    if (!sheet.empty()) {
      const Frame drawn = draw_hierarchy(*exemplars->model());
      cv::Mat bgr;
      cv::cvtColor(report::canvas::view(drawn), bgr, cv::COLOR_RGB2BGR);
      write_sheet(bgr);
      fmt::print("{}: the hierarchy, drawn\n", sheet.string());
    }
    common.write_json(about.json);
  }
};

}  // namespace

void add_inspect(CLI::App& app, const std::stop_token&) {
  auto options = std::make_shared<InspectCommand>();
  CLI::App* command =
      app.add_subcommand("inspect", "What is in a dataset, model or scenario, and is it whole");
  command->add_option("WHAT", options->what, "A dataset's folder, a model or a scenario file")
      ->required();
  command
      ->add_option("--sheet", options->sheet,
                   "Draw a dataset's contact sheet, or an exemplar model's hierarchy (PNG)")
      ->check(picture_file());
  command->add_flag("--repair", options->mend,
                    "Keep a dataset's episodes before the first that is damaged, and move the rest "
                    "to .dropped");
  command->add_flag("--quick", options->quick, "Leave out the videos");
  options->common.add_to(*command);
  command->footer("Example: pacer inspect out/drives --sheet out/drives.png");
  command->callback([options] { options->run(); });
}

}  // namespace pacer
