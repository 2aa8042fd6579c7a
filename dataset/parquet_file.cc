// SPDX-License-Identifier: Apache-2.0
#include "dataset/parquet_file.h"

namespace pacer::dataset {
namespace {

constexpr std::int64_t kMostMemory = 512LL << 20U;  // what a hostile file may make us allocate
constexpr std::int64_t kBatchRows = 1024;

arrow::MemoryPool* capped_pool() {
  static arrow::CappedMemoryPool pool(arrow::system_memory_pool(), kMostMemory);
  return &pool;
}

}  // namespace

ParquetWriter::ParquetWriter(const std::filesystem::path& path,
                             const std::shared_ptr<arrow::Schema>& schema)
    : file_(value_of(arrow::io::FileOutputStream::Open(path.string()))) {
  const auto properties = parquet::WriterProperties::Builder()
                              .memory_pool(arrow::system_memory_pool())
                              ->compression(parquet::Compression::SNAPPY)
                              ->build();
  const auto arrow_properties =
      parquet::ArrowWriterProperties::Builder().store_schema()->set_use_threads(false)->build();
  writer_ = value_of(parquet::arrow::FileWriter::Open(*schema, arrow::system_memory_pool(), file_,
                                                      properties, arrow_properties));
}

void ParquetWriter::write(const arrow::Table& table) {
  require_good(writer_->WriteTable(table, std::max<std::int64_t>(table.num_rows(), 1)));
}

void ParquetWriter::close() {
  require_good(writer_->Close());
  require_good(file_->Close());
}

std::unique_ptr<parquet::arrow::FileReader> open_parquet(const std::filesystem::path& path) {
  parquet::ReaderProperties properties(capped_pool());
  properties.set_thrift_string_size_limit(16 << 20);
  properties.set_thrift_container_size_limit(1 << 20);
  parquet::ArrowReaderProperties arrow_properties(/*use_threads=*/false);
  arrow_properties.set_batch_size(kBatchRows);
  arrow_properties.set_pre_buffer(false);
  parquet::arrow::FileReaderBuilder builder;
  require_good(builder.Open(value_of(arrow::io::ReadableFile::Open(path.string(), capped_pool())),
                            properties));
  builder.memory_pool(capped_pool())->properties(arrow_properties);
  return value_of(builder.Build());
}

}  // namespace pacer::dataset
