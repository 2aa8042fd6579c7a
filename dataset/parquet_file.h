// SPDX-License-Identifier: Apache-2.0
// Private to the module: Arrow as all of its files use it, on one thread, by one allocator.
#pragma once

#include <arrow/api.h>
#include <arrow/io/file.h>
#include <parquet/arrow/reader.h>
#include <parquet/arrow/writer.h>

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>

namespace pacer::dataset {

/// Runs `work` and turns whatever it throws into a std::runtime_error that names the file.
template <class Work>
auto at_file(const std::filesystem::path& path, const char* what, Work&& work) {
  try {
    return work();
  } catch (const std::exception& error) {
    std::string why = error.what();
    for (char& c : why) {
      if (c == '\n') c = ' ';
    }
    const std::size_t end = why.find_last_not_of(" .;");
    why.resize(end == std::string::npos ? 0 : end + 1);  // what is said next has its own stop
    throw std::runtime_error(path.string() + ": " + what + ": " + why);
  }
}

inline void require_good(const arrow::Status& status) {
  if (!status.ok()) throw std::runtime_error(status.message());
}
template <class T>
T value_of(arrow::Result<T> result) {
  require_good(result.status());
  return std::move(result).ValueUnsafe();
}

/// A Parquet file open for writing, with the settings of the reference's writer.
class ParquetWriter {
 public:
  ParquetWriter(const std::filesystem::path& path, const std::shared_ptr<arrow::Schema>& schema);
  void write(const arrow::Table& table);
  void close();

 private:
  std::shared_ptr<arrow::io::FileOutputStream> file_;
  std::unique_ptr<parquet::arrow::FileWriter> writer_;
};

/// A Parquet file open for reading, its memory capped.
[[nodiscard]] std::unique_ptr<parquet::arrow::FileReader> open_parquet(
    const std::filesystem::path& path);

}  // namespace pacer::dataset
