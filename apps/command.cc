// SPDX-License-Identifier: Apache-2.0
#include "apps/command.h"

#include <fmt/format.h>

#include <fstream>
#include <thread>

#include "core/check.h"

namespace pacer {

void CommonOptions::add_to(CLI::App& command) {
  command.add_option("--set", set, "Change a scenario value, e.g. --set limits.throttle_cap=0.4")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command.add_option("--seed", seed, "The seed all chance comes from (default: the scenario's)");
  command.add_option("--json", json, "Write the result to this file");
  command.add_option("-j,--jobs", jobs, "Worker processes (default: one a processor)")
      ->check(CLI::Range(1, 256));
}

std::vector<std::string> CommonOptions::overrides() const {
  std::vector<std::string> all = set;
  if (seed) all.push_back(fmt::format("seed={}", *seed));
  return all;
}

Scenario CommonOptions::load(const std::filesystem::path& file) const {
  return load_scenario(file, overrides());
}

RunControl CommonOptions::control(const std::stop_token& stop) const {
  RunControl control;
  control.jobs =
      jobs > 0 ? jobs : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  control.stop = stop;
  return control;
}

void CommonOptions::write_json(const nlohmann::ordered_json& result) const {
  if (json.empty()) return;
  // What is no plain file (a pipe, /dev/stdout) is written to; it must not be replaced.
  std::error_code error;
  const auto kind = std::filesystem::symlink_status(json, error).type();
  const bool replace =
      kind == std::filesystem::file_type::not_found || kind == std::filesystem::file_type::regular;
  const std::filesystem::path aside = replace ? json.string() + ".part" : json.string();
  std::ofstream stream(aside);
  stream << result.dump(2) << '\n';
  stream.close();
  error.clear();
  if (stream && replace) std::filesystem::rename(aside, json, error);
  if (!stream || error) {
    if (replace) std::filesystem::remove(aside, error);
    throw std::runtime_error(json.string() + ": cannot be written; check the folder and the disk");
  }
}

}  // namespace pacer
