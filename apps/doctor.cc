// SPDX-License-Identifier: Apache-2.0
#include "runs/doctor.h"

#include <fmt/format.h>

#include <algorithm>

#include "apps/command.h"

namespace pacer {
namespace {

struct DoctorCommand {
  CommonOptions common;
  std::filesystem::path scenario;

  void run() const {
    const Scenario loaded = scenario.empty() ? parse_scenario("", "defaults", common.overrides())
                                             : common.load(scenario);
    const std::vector<Diagnosis> findings = examine(loaded);
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const Diagnosis& finding : findings) {
      const char* const verdict = finding.verdict == Diagnosis::Verdict::kGood   ? "good"
                                  : finding.verdict == Diagnosis::Verdict::kSlow ? "slow"
                                                                                 : "missing";
      fmt::print("{:<8}{:<18}{}\n", verdict, finding.what, finding.found);
      if (!finding.advice.empty()) fmt::print("{:<26}{}\n", "", finding.advice);
      json.push_back({{"what", finding.what},
                      {"found", finding.found},
                      {"verdict", verdict},
                      {"advice", finding.advice}});
    }
    common.write_json({{"findings", json}});
    if (std::ranges::any_of(findings, [](const Diagnosis& finding) {
          return finding.verdict == Diagnosis::Verdict::kMissing;
        })) {
      throw Unfinished{};
    }
  }
};

}  // namespace

void add_doctor(CLI::App& app, const std::stop_token&) {
  auto options = std::make_shared<DoctorCommand>();
  CLI::App* command = app.add_subcommand("doctor", "What this machine offers, and what is slow");
  command->add_option("SCENARIO", options->scenario, "A scenario (default: the defaults)");
  options->common.add_to(*command);
  command->footer("Example: pacer doctor");
  command->callback([options] { options->run(); });
}

}  // namespace pacer
