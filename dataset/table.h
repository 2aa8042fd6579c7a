// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "dataset/feature.h"

namespace pacer::dataset {

/// Writes rows of numbers to a Parquet file, a group of rows at a time, on the calling thread.
/// Memory does not grow with the number of rows. A row is a span of double, whatever the columns'
/// types: their values in turn.
///
/// A writer that is destroyed before close() leaves an unreadable file behind.
class TableWriter {
 public:
  /// Throws std::runtime_error, naming the file, when it cannot be written.
  TableWriter(std::filesystem::path path, std::vector<Feature> columns);
  ~TableWriter();
  TableWriter(const TableWriter&) = delete;
  TableWriter& operator=(const TableWriter&) = delete;

  void append(std::span<const double> row);
  void close();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Reads some columns of a Parquet file, row by row. The file is not trusted: whatever is wrong
/// with it becomes a std::runtime_error that names it, and a false size costs no memory.
class TableReader {
 public:
  /// Throws when a column is missing or of another type or width.
  TableReader(std::filesystem::path path, std::vector<Feature> columns);
  ~TableReader();
  TableReader(const TableReader&) = delete;
  TableReader& operator=(const TableReader&) = delete;

  /// As the file declares it.
  [[nodiscard]] std::int64_t rows() const;

  /// The next row: the columns' values in turn. Empty after the last. Lives until the next call.
  [[nodiscard]] std::span<const double> next();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pacer::dataset
