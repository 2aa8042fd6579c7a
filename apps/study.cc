// SPDX-License-Identifier: Apache-2.0
#include "studies/study.h"

#include <fmt/format.h>

#include "apps/command.h"
#include "apps/terminal_progress.h"
#include "core/check.h"
#include "studies/run_studies.h"

namespace pacer {
namespace {

struct StudyCommand {
  CommonOptions common;
  std::string name;
  std::filesystem::path scenario;  ///< empty: each study's own
  std::filesystem::path out;
  std::filesystem::path cache = "out/cache";
  std::filesystem::path transactions;
  std::filesystem::path images;
  std::filesystem::path sequences;

  void run(const std::stop_token& stop) const {
    const Study* const study = name == "all" ? nullptr : &find_study(name);
    StudyContext context;
    context.control = common.control(stop);
    TerminalProgress progress;
    context.control.progress = progress.callback();
    context.cache = cache;
    if (!transactions.empty()) context.transactions = transactions;
    if (!images.empty()) context.images = images;
    if (!sequences.empty()) context.sequences = sequences;
    context.out = out;
    if (study == nullptr) {
      const nlohmann::ordered_json all = run_all_studies(
          context, [this](const Study& each, StudyContext& its) { set_scenes(each, its); });
      progress.finish();
      common.write_json(all);
      return;
    }
    refuse_what_it_does_not_take(*study);
    set_scenes(*study, context);
    const nlohmann::ordered_json result = run_study(*study, context);
    progress.finish();
    fmt::print("{}\n{}", study->about, to_text(result));
    common.write_json(result);
  }

 private:
  void refuse_what_it_does_not_take(const Study& study) const {
    for (const auto& [option, given] : {std::pair("transactions", &transactions),
                                        {"images", &images},
                                        {"sequences", &sequences}}) {
      if (!given->empty() && study.takes != option) {
        throw UsageError(fmt::format("--{}: study {} takes none", option, study.name));
      }
    }
  }

  /// The scenarios of `study`, each with the overrides of the command line.
  void set_scenes(const Study& study, StudyContext& context) const {
    context.scenario = scenario.empty() ? shipped(study.scenario) : loaded(scenario);
    context.also = study.also.empty() ? std::nullopt : std::optional(shipped(study.also));
  }

  [[nodiscard]] Scenario shipped(const std::string& which) const {
    return loaded(std::filesystem::path("scenarios") / (which + ".yaml"));
  }

  [[nodiscard]] Scenario loaded(const std::filesystem::path& file) const {
    std::error_code error;
    if (!std::filesystem::exists(file, error)) {
      throw UsageError(file.string() +
                       ": there is no such file; go to where it is, or name one with --scenario");
    }
    return common.load(file);
  }
};

}  // namespace

void add_study(CLI::App& app, const std::stop_token& stop) {
  auto options = std::make_shared<StudyCommand>();
  CLI::App* command = app.add_subcommand("study", "Measure a table or figure of the thesis");
  std::string names;
  for (const Study& study : studies())
    names += fmt::format("\n  {:<22}{}", study.name, study.about);
  command->add_option("NAME", options->name, "A study, or all")->required();
  command->add_option("--scenario", options->scenario,
                      "The scenario it is measured on; for tasks, the person's (default: "
                      "scenarios/balloon.yaml for chapter 5's, person.yaml for tasks, whose other "
                      "is lane.yaml, else follow.yaml)");
  command->add_option("--out", options->out, "Folder for its page");
  command->add_option("--cache", options->cache, "Folder of recordings and models kept for reuse")
      ->capture_default_str();
  command->add_option("--transactions", options->transactions,
                      "apriori: a file to mine, a line being TYPE ITEM ITEM ...");
  command->add_option("--images", options->images,
                      "Chapter 3's: pictures to try predictors on, instead of simulated rooms");
  command->add_option("--sequences", options->sequences,
                      "tracking: a folder of sequences with truth (OTB, VOT, GOT-10k, TLD), beside "
                      "the simulated ones");
  options->common.add_to(*command);
  command->footer("Studies:" + names +
                  "\nExample: pacer study following --json out/following.json --out out/following");
  command->callback([options, stop] { options->run(stop); });
}

}  // namespace pacer
