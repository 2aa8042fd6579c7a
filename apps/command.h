// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "runs/run_control.h"
#include "scenarios/scenario.h"

namespace pacer {

/// What every command takes.
struct CommonOptions {
  std::vector<std::string> set;
  std::optional<std::uint64_t> seed;
  std::filesystem::path json;
  int jobs = 0;  ///< 0: as many as there are processors

  /// Adds --set, --seed, --json and --jobs to `command`.
  void add_to(CLI::App& command);

  [[nodiscard]] std::vector<std::string> overrides() const;  ///< --set, then --seed
  [[nodiscard]] Scenario load(const std::filesystem::path& file) const;
  [[nodiscard]] RunControl control(const std::stop_token& stop) const;

  /// Writes `result` to --json, when it was asked for: whole or not at all.
  void write_json(const nlohmann::ordered_json& result) const;
};

/// For options that name a file to write: tries it before the work is done.
[[nodiscard]] CLI::Validator writable_file();

/// For options that name a film to write: as writable_file(), and .mp4 is all that is written.
[[nodiscard]] CLI::Validator film_file();

/// The same for a picture, which is a PNG.
[[nodiscard]] CLI::Validator picture_file();

/// For options that name a model to write: as writable_file(), and what is there and is no model
/// stays.
[[nodiscard]] CLI::Validator model_file();

/// For options that count: digits, where CLI11 would wrap what is negative or too large.
[[nodiscard]] CLI::Validator whole_number();

/// Throws UsageError when an output is an input, lies inside one, or is named twice.
void keep_apart(const std::vector<std::filesystem::path>& inputs,
                const std::vector<std::filesystem::path>& outputs);

/// Thrown by a command that did what it could and has to end with status 1: interrupted, or a
/// dataset with faults. What is to be said has been said.
struct Unfinished {};

// Each adds one subcommand that runs when the command line names it.
void add_collect(CLI::App& app, const std::stop_token& stop);
void add_train(CLI::App& app, const std::stop_token& stop);
void add_evaluate(CLI::App& app, const std::stop_token& stop);
void add_drive(CLI::App& app, const std::stop_token& stop);
void add_sequences(CLI::App& app, const std::stop_token& stop);
void add_track(CLI::App& app, const std::stop_token& stop);
void add_inspect(CLI::App& app, const std::stop_token& stop);
void add_study(CLI::App& app, const std::stop_token& stop);
void add_doctor(CLI::App& app, const std::stop_token& stop);

}  // namespace pacer
