// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "runs/evaluate.h"
#include "studies/study.h"

namespace pacer {

/// Recordings, models and closed-loop runs that studies share. Each is kept in the cache under a
/// fingerprint of what it was made from, this program included, and made when it is not there.
/// Times are never kept.
class Materials {
 public:
  /// `context` must outlive it.
  explicit Materials(const StudyContext& context);

  /// `episodes` episodes that the teacher drove for `purpose`: the dataset's folder.
  [[nodiscard]] std::filesystem::path recording(Purpose purpose, std::uint64_t episodes) const;

  /// A model learnt from the first `episodes` demonstrated episodes: its file, whose stem is
  /// `name`.
  [[nodiscard]] std::filesystem::path model(std::uint64_t episodes,
                                            const std::string& name = "learned") const;
  /// The same learnt by `config` instead of the scenario's settings.
  [[nodiscard]] std::filesystem::path model(const affordance::AffordanceConfig& config,
                                            std::uint64_t episodes,
                                            const std::string& name = "learned") const;

  /// A baseline (`pacer train METHOD`) learnt from them: its file, whose stem is `method`.
  [[nodiscard]] std::filesystem::path baseline(const std::string& method,
                                               std::uint64_t episodes) const;

  /// A hierarchy (chapter 5) learnt by `config` from the first `episodes` demonstrated episodes:
  /// its file, whose stem is `name`.
  [[nodiscard]] std::filesystem::path exemplar_model(const exemplar::ExemplarConfig& config,
                                                     std::uint64_t episodes,
                                                     const std::string& name) const;

  /// The simulated tracking sequences of `seed`, each a folder in this one.
  [[nodiscard]] std::filesystem::path sequences(std::uint64_t seed) const;

  /// Of the program and the scenario: what a result depends on.
  [[nodiscard]] std::string fingerprint() const;

  /// The demonstrations of so many minutes at most, whole episodes, and one at least.
  [[nodiscard]] std::uint64_t minutes(double count) const;
  [[nodiscard]] std::uint64_t five_minutes() const { return minutes(5.0); }

 private:
  [[nodiscard]] std::filesystem::path place(const std::string& kind,
                                            const std::string& made_of) const;

  const StudyContext& context_;
  std::uint64_t program_;  // hash of this executable
};

/// Thrown when a stop was requested before a study was done.
struct StudyStopped : std::runtime_error {
  StudyStopped()
      : std::runtime_error(
            "interrupted: the same command begins anew, with the recordings and models it has") {}
};

/// Keeps this process, and those it starts, on one core while it lives: on the one at `which` of
/// those that it may use, counted round.
class OneCore {
 public:
  explicit OneCore(std::uint64_t which = 0);  ///< throws std::system_error when the kernel refuses
  ~OneCore();
  OneCore(const OneCore&) = delete;
  OneCore& operator=(const OneCore&) = delete;

 private:
  struct Saved;
  std::unique_ptr<Saved> saved_;
};

}  // namespace pacer
