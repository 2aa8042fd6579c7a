// SPDX-License-Identifier: Apache-2.0
#include "studies/study.h"

#include <fmt/format.h>
#include <unistd.h>

#include <fstream>
#include <string>

#include "core/version.h"

namespace pacer {
namespace {

/// The processor's own name, and how many of it there are.
std::string machine() {
  std::ifstream cpu("/proc/cpuinfo");
  std::string line;
  std::string name = "unknown processor";
  while (std::getline(cpu, line)) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) {
      name = line.substr(colon + 2);
      break;
    }
  }
  return fmt::format("{} x {}", ::sysconf(_SC_NPROCESSORS_ONLN), name);
}

}  // namespace

Claim at_least(std::string name, std::string thesis, double measured, double bound) {
  return {.name = std::move(name),
          .thesis = std::move(thesis),
          .bound = fmt::format(">= {}", bound),
          .measured = measured,
          .holds = measured >= bound};
}

Claim above(std::string name, std::string thesis, double measured, double bound) {
  return {.name = std::move(name),
          .thesis = std::move(thesis),
          .bound = fmt::format("> {}", bound),
          .measured = measured,
          .holds = measured > bound};
}

Claim at_most(std::string name, std::string thesis, double measured, double bound) {
  return {.name = std::move(name),
          .thesis = std::move(thesis),
          .bound = fmt::format("<= {}", bound),
          .measured = measured,
          .holds = measured <= bound};
}

Claim below(std::string name, std::string thesis, double measured, double bound) {
  return {.name = std::move(name),
          .thesis = std::move(thesis),
          .bound = fmt::format("< {}", bound),
          .measured = measured,
          .holds = measured < bound};
}

Claim between(std::string name, std::string thesis, double measured, double low, double high) {
  return {.name = std::move(name),
          .thesis = std::move(thesis),
          .bound = fmt::format("{} to {}", low, high),
          .measured = measured,
          .holds = low <= measured && measured <= high};
}

nlohmann::ordered_json to_json(const Study& study, const StudyContext& context,
                               const StudyResult& result, double seconds) {
  nlohmann::ordered_json claims = nlohmann::ordered_json::array();
  for (const Claim& claim : result.claims) {
    claims.push_back({{"name", claim.name},
                      {"thesis", claim.thesis},
                      {"bound", claim.bound},
                      {"measured", claim.measured},
                      {"holds", claim.holds}});
  }
  return {{"study", study.name},        {"version", kVersion},      {"seed", context.scenario.seed},
          {"machine", machine()},       {"study_seconds", seconds}, {"figures", result.figures},
          {"claims", std::move(claims)}};
}

}  // namespace pacer
