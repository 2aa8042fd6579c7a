// SPDX-License-Identifier: Apache-2.0
#include "studies/run_studies.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>

#include "core/check.h"
#include "core/output_file.h"
#include "core/version.h"
#include "studies/materials.h"
#include "studies/studies.h"

namespace pacer {
namespace {

using nlohmann::ordered_json;

void write_whole(const std::filesystem::path& file, const std::string& text) {
  OutputFile output(file);
  output.write(text);
  output.keep();
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    throw std::runtime_error(
        fmt::format("{}: no folder can be made there: {}", folder.string(), error.message()));
  }
}

/// The goal of scenarios/`shipped`.yaml.
const char* goal_of(const std::string& shipped) {
  if (shipped == "balloon") return "reach";
  return shipped == "lane" ? "keep" : "follow";
}

/// A study drives as its own scenario does; with another goal it would measure nothing, and with
/// another lead something else than it says.
void require_like(const Study& study, const std::string& shipped, const Scenario& scenario) {
  const char* const goal = goal_of(shipped);
  if (scenario.goal != goal) {
    throw UsageError(
        fmt::format("study {}: is measured with goal: {}, and scenario {} has goal: {}; name one "
                    "such as scenarios/{}.yaml",
                    study.name, goal, scenario.name, scenario.goal, shipped));
  }
  const std::string& lead = scenario.simulated.world.lead_body;
  if (shipped != "person" || lead == "person") return;
  throw UsageError(
      fmt::format("study {}: is measured behind a person, and scenario {} has "
                  "simulated.world.lead_body: {}; name one such as scenarios/person.yaml",
                  study.name, scenario.name, lead));
}

void require_scenes(const Study& study, const StudyContext& context) {
  require_like(study, study.scenario, context.scenario);
  if (context.also) require_like(study, study.also, *context.also);
}

/// The result of an earlier run of the same program and scenario; null when there is none.
ordered_json earlier(const std::filesystem::path& file, const std::string& made_of) {
  std::ifstream stream(file);
  const ordered_json value = ordered_json::parse(stream, nullptr, false);
  if (!value.is_object() || value.value("made_of", "") != made_of) return nullptr;
  return value["result"];
}

/// A claim as a row: the study, what is claimed, and what was measured.
report::Row row_of(const std::string& study, const ordered_json& claim) {
  const ordered_json& measured = claim["measured"];  // null in a file where it was not finite
  return {
      .cells = {study, claim["name"].get<std::string>(), claim["thesis"].get<std::string>(),
                claim["bound"].get<std::string>(),
                measured.is_number() ? measured.get<double>() : std::nan(""),
                claim["holds"].get<bool>() ? report::Verdict::kHolds : report::Verdict::kShort}};
}

report::Table table_of(const ordered_json& results) {
  report::Table table;
  table.columns = {{.heading = "study"},
                   {.heading = "figure"},
                   {.heading = "claim"},
                   {.heading = "bound"},
                   {.heading = "measured", .unit = "", .decimals = 3},
                   {.heading = "holds"}};
  for (const bool holds : {false, true}) {  // what falls short comes first
    for (const auto& [study, result] : results.items()) {
      for (const ordered_json& claim : result["claims"]) {
        if (claim["holds"].get<bool>() == holds) table.rows.push_back(row_of(study, claim));
      }
    }
  }
  return table;
}

}  // namespace

const std::vector<Study>& studies() {
  static const std::vector<Study> all = {
      {"convergence", "Figures 3.7, 3.8: a predictor, a flock and Lucas-Kanade, 60,000 tests",
       "follow", study_convergence, "images"},
      {"training-range", "Figures 3.3, 3.4: answers within the range of training", "follow",
       study_training_range, "images"},
      {"parameters", "Figure 3.9: what a predictor's parameters do", "follow", study_parameters,
       "images"},
      {"weighting", "Figure 3.10: a flock weighted by agreement, its target partly hidden",
       "follow", study_weighting, "images"},
      {"interframe", "Figures 3.5, 3.6: a jump of 37 pixels, with blur", "follow",
       study_interframe},
      {"tracking", "Figures 4.4 to 4.17, Table 4.4: every tracker beside those of today", "follow",
       study_tracking, "sequences"},
      {"output-clustering", "Figure 5.4: grouped by percepts, and grouped by actions", "balloon",
       study_output_clustering},
      {"blobs", "Figure 5.10: are balloons found where they are?", "balloon", study_blobs},
      {"perceptual-weighting", "Figure 5.12: what decides the action decides the match", "balloon",
       study_perceptual_weighting},
      {"generalisation", "Figure 5.13: actions of unseen percepts, against tau", "balloon",
       study_generalisation},
      {"recall-efficiency", "Figure 5.14: exact matches and spared nodes, against tau", "balloon",
       study_recall_efficiency},
      {"exemplar-scale", "searches among 304 to a million exemplars", "balloon",
       study_exemplar_scale},
      {"balloon", "Figures 5.15, 5.16: closed loop to the red balloon", "balloon", study_balloon},
      {"demonstrations",
       "Figures 6.5, 6.6: the lead's pose in the picture, and the teacher's action", "follow",
       study_demonstrations},
      {"action-clusters", "Figure 6.8: the whitened actions and their six types", "follow",
       study_action_clusters},
      {"response", "frame to command on one core, SIFT included", "follow", study_response},
      {"throughput", "recording against a bare simulation loop", "follow", study_throughput},
      {"apriori", "mining: equal to independent implementations, and its time", "follow",
       study_apriori, "transactions"},
      {"hits", "Table 6.1: do mined configurations lie on the lead?", "follow", study_hits},
      {"signals", "Figure 6.15: the turn signal, against the supervised baseline's", "follow",
       study_signals},
      {"lag", "how late a teacher answers, found from its demonstrations", "follow", study_lag},
      {"standing-lead", "Figure 6.16: a lead that stands to the left, in the middle, to the right",
       "follow", study_standing_lead},
      {"absence", "rooms without a lead: does it stand?", "follow", study_absence},
      {"loss", "6.7.1, 6.6.2: what to do when the lead is lost, in closed loop", "follow",
       study_loss},
      {"following", "closed loop in unseen rooms, against teacher and baselines", "follow",
       study_following},
      {"learning-curve", "episodes followed after 0.5 to 10 minutes of demonstration", "follow",
       study_learning_curve},
      {"transfer", "other light, corrupted frames and delay: what of following is lost", "follow",
       study_transfer},
      {.name = "tasks",
       .about = "another target and another task, nothing changed but the demonstrations",
       .scenario = "person",
       .run = study_tasks,
       .also = "lane"}};
  return all;
}

const Study& find_study(const std::string& name) {
  const auto found = std::ranges::find(studies(), name, &Study::name);
  if (found != studies().end()) return *found;
  std::string names;
  for (const Study& study : studies()) names += study.name + ", ";
  throw UsageError("there is no study \"" + name + "\"; name one of " + names + "all");
}

ordered_json run_study(const Study& study, const StudyContext& context) {
  require_scenes(study, context);
  const auto start = std::chrono::steady_clock::now();
  report::Page page(study.name, study.about);
  const StudyResult result = study.run(context, page);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  ordered_json value = to_json(study, context, result, seconds);
  if (!context.out.empty()) {
    make_folder(context.out);
    page.section("Claims").table(table_of({{study.name, value}}));
    page.write(context.out / (study.name + ".html"));
    write_whole(context.out / (study.name + ".json"), value.dump(2) + "\n");
  }
  return value;
}

ordered_json run_all_studies(StudyContext context,
                             const std::function<void(const Study&, StudyContext&)>& set_scenes) {
  if (context.out.empty()) throw UsageError("study all: --out names the folder of its page");
  for (const Study& study : studies()) {  // before the first of them has taken an hour
    set_scenes(study, context);
    require_scenes(study, context);
  }
  ordered_json results = ordered_json::object();
  for (const Study& study : studies()) {
    set_scenes(study, context);
    std::string made_of = Materials(context).fingerprint();
    if (context.also) made_of += to_yaml(*context.also);
    for (const auto& given : {context.transactions, context.images, context.sequences}) {
      made_of += " " + (given ? given->string() : "");
    }
    const std::filesystem::path kept = context.out / ("." + study.name + ".done.json");
    ordered_json result = earlier(kept, made_of);
    if (result.is_null()) {
      result = run_study(study, context);
      write_whole(kept, ordered_json{{"made_of", made_of}, {"result", result}}.dump());
    }
    results[study.name] = result;
  }
  const report::Table table = table_of(results);
  report::Page page(
      "Results", fmt::format("Every study of pacer {}, seed {}.", kVersion, context.scenario.seed));
  report::Content& claims = page.section("Claims");
  claims.table(table);
  for (const auto& [name, result] : results.items()) {
    page.section(name).paragraph(report::Text::link("its page", name + ".html"));
  }
  page.write(context.out / "index.html");
  write_whole(context.out / "results.md",
              fmt::format("# Results\n\nWritten by `pacer study all`: pacer {}, seed {}.\n\n{}",
                          kVersion, context.scenario.seed, report::markdown(table)));
  return results;
}

std::string to_text(const ordered_json& result) {
  std::string text;
  constexpr std::size_t kLongest = 200;  // characters; tables and curves are for --json
  for (const auto& [name, value] : result["figures"].items()) {
    const std::string shown =
        value.is_number_float() ? fmt::format("{:.4g}", value.get<double>()) : value.dump();
    if (shown.size() <= kLongest) text += fmt::format("  {:<28} {}\n", name, shown);
  }
  for (const ordered_json& claim : result["claims"]) {
    text += fmt::format("  {} {}: {:.4g}, claimed {}\n",
                        claim["holds"].get<bool>() ? "holds " : "SHORT ",
                        claim["name"].get<std::string>(), claim["measured"].get<double>(),
                        claim["bound"].get<std::string>());
  }
  return text + fmt::format("  took {:.0f} s\n", result["study_seconds"].get<double>());
}

}  // namespace pacer
