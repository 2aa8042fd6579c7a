// SPDX-License-Identifier: Apache-2.0
#include "apps/command.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <thread>

#include "core/check.h"
#include "core/output_file.h"

namespace pacer {
namespace {

/// As writable_file(), for names that end in `ending`; `what` says what is written there.
CLI::Validator file_named(std::string ending, std::string what) {
  return {[ending = std::move(ending), what = std::move(what)](const std::string& file) {
            std::string kind = std::filesystem::path(file).extension().string();
            std::ranges::transform(kind, kind.begin(),
                                   [](unsigned char c) { return std::tolower(c); });
            if (kind == ending) return writable_file()(std::string(file));
            return fmt::format("{}: {}; give it a name that ends in {}", file, what, ending);
          },
          ""};
}

/// Whether there is a file that does not begin as every model does.
bool holds_something_else(const std::filesystem::path& file) {
  constexpr std::string_view kModels = "PACER";
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return false;
  std::string first(kModels.size(), '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(first.data(), static_cast<std::streamsize>(first.size()));
  return stream.gcount() > 0 && first != kModels;
}

}  // namespace

CLI::Validator writable_file() {
  return {[](const std::string& file) {
            try {
              const OutputFile tried(file);
              return std::string();
            } catch (const std::exception& error) {
              return std::string(error.what());
            }
          },
          ""};
}

CLI::Validator film_file() { return file_named(".mp4", "a film is an MP4"); }

CLI::Validator picture_file() { return file_named(".png", "a picture is a PNG"); }

CLI::Validator model_file() {
  return {[](const std::string& file) {
            if (!holds_something_else(file)) return writable_file()(std::string(file));
            return file + ": is there, and is no model; name another file";
          },
          ""};
}

CLI::Validator whole_number() {
  return {[](const std::string& text) {
            constexpr std::size_t kMostDigits = 18;  // fit into 64 bits, whatever they are
            const bool good = !text.empty() && text.size() <= kMostDigits &&
                              text.find_first_not_of("0123456789") == std::string::npos;
            return good ? std::string() : "expected a whole number, 0 or more, not " + text;
          },
          ""};
}

void keep_apart(const std::vector<std::filesystem::path>& inputs,
                const std::vector<std::filesystem::path>& outputs) {
  namespace fs = std::filesystem;
  std::vector<fs::path> known;
  for (const fs::path& output : outputs) {
    std::error_code error;
    if (output.empty() || fs::is_other(output, error)) continue;
    const fs::path place = fs::weakly_canonical(output, error);
    if (std::ranges::find(known, place) != known.end()) {
      throw UsageError(output.string() + ": is named for two results; name another file for one");
    }
    known.push_back(place);
    for (const fs::path& input : inputs) {
      if (input.empty() || !fs::exists(input, error)) continue;
      const fs::path source = fs::canonical(input, error);
      if (std::ranges::mismatch(source, place).in1 == source.end()) {
        throw UsageError(fmt::format("{}: is part of {}, which is read; name another file",
                                     output.string(), input.string()));
      }
    }
  }
}

void CommonOptions::add_to(CLI::App& command) {
  command.add_option("--set", set, "Change a scenario value, e.g. --set limits.throttle_cap=0.4")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command.add_option("--seed", seed, "The seed all chance comes from (default: the scenario's)")
      ->check(whole_number());
  command.add_option("--json", json, "Write the result to this file")->check(writable_file());
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
  if (json == "/dev/stdout") {  // in turn with what is printed, also where that goes to a file
    fmt::print("{}\n", result.dump(2));
    return;
  }
  OutputFile file(json);
  file.write(result.dump(2) + "\n");
  file.keep();
}

}  // namespace pacer
