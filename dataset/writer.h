// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "dataset/feature.h"

namespace pacer::dataset {

/// A dataset open for more episodes: the one process that makes recorded episodes part of it, in
/// their order. Every file appears whole, by a rename, and an episode's entry after its frames, so
/// that a kill at any moment leaves a dataset that the next DatasetWriter makes whole again; what
/// was committed or finished stays. The bytes do not depend on who recorded an episode, on the
/// order in which they were finished, or on interruptions.
class DatasetWriter {
 public:
  /// Makes a dataset in `root`, or goes on with the one that is there, after putting right what a
  /// kill left half done. Holds the folder's lock.
  /// Throws UsageError when what is there is no dataset, or one of another camera, rate, columns or
  /// scenario, or in use; std::runtime_error when it is damaged beyond what a kill can do.
  DatasetWriter(std::filesystem::path root, DatasetSpec spec);
  ~DatasetWriter();
  DatasetWriter(const DatasetWriter&) = delete;
  DatasetWriter& operator=(const DatasetWriter&) = delete;

  [[nodiscard]] std::int64_t episodes() const;  ///< committed; the next one's number
  [[nodiscard]] std::int64_t frames() const;    ///< committed

  /// Whether episode `episode` is recorded and waits for its commit.
  [[nodiscard]] bool is_finished(std::int64_t episode) const;

  /// Makes episode number `episodes()` part of the dataset. Throws std::runtime_error, naming the
  /// file, and then the episode still waits.
  void commit();

  /// Commits as many as are finished, in order; returns how many.
  std::int64_t commit_finished();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pacer::dataset
