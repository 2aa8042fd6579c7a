// SPDX-License-Identifier: Apache-2.0
#include "dataset/table.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/check.h"
#include "dataset/parquet_file.h"

namespace pacer::dataset {
namespace {

constexpr std::size_t kGroupRows = 1024;

std::shared_ptr<arrow::DataType> value_type(ValueType type) {
  switch (type) {
    case ValueType::kFloat32:
      return arrow::float32();
    case ValueType::kFloat64:
      return arrow::float64();
    case ValueType::kInt64:
      break;
  }
  return arrow::int64();
}

std::shared_ptr<arrow::DataType> column_type(const Feature& column) {
  auto values = value_type(column.type);
  if (column.width == 1) return values;
  return arrow::fixed_size_list(arrow::field("element", values), static_cast<int>(column.width));
}

/// What the `datasets` package keeps in a file's footer of the types that it shows.
std::string footer_of(const std::vector<Feature>& columns) {
  nlohmann::ordered_json features;
  for (const Feature& column : columns) {
    nlohmann::ordered_json value{{"dtype", name_of(column.type)}, {"_type", "Value"}};
    features[column.name] =
        column.width == 1 ? value
                          : nlohmann::ordered_json{
                                {"feature", value}, {"length", column.width}, {"_type", "List"}};
  }
  return nlohmann::ordered_json{{"info", {{"features", features}}}}.dump();
}

std::shared_ptr<arrow::Schema> schema_of(const std::vector<Feature>& columns) {
  arrow::FieldVector fields;
  for (const Feature& column : columns) {
    fields.push_back(arrow::field(column.name, column_type(column)));
  }
  return arrow::schema(fields, arrow::key_value_metadata({"huggingface"}, {footer_of(columns)}));
}

/// The values of one column, waiting for their row group to be full.
struct ColumnBuffer {
  explicit ColumnBuffer(const Feature& feature) : column(feature) {
    const std::size_t capacity = kGroupRows * column.width;
    if (column.type == ValueType::kFloat32) floats.reserve(capacity);
    if (column.type == ValueType::kFloat64) doubles.reserve(capacity);
    if (column.type == ValueType::kInt64) integers.reserve(capacity);
  }

  void append(std::span<const double> values) {
    for (const double value : values) {
      if (column.type == ValueType::kFloat32) floats.push_back(static_cast<float>(value));
      if (column.type == ValueType::kFloat64) doubles.push_back(value);
      if (column.type == ValueType::kInt64) integers.push_back(static_cast<std::int64_t>(value));
    }
  }

  /// A view of the values: valid until clear().
  [[nodiscard]] std::shared_ptr<arrow::Array> view() const {
    const auto wrapped = column.type == ValueType::kFloat32   ? arrow::Buffer::Wrap(floats)
                         : column.type == ValueType::kFloat64 ? arrow::Buffer::Wrap(doubles)
                                                              : arrow::Buffer::Wrap(integers);
    const std::size_t count = floats.size() + doubles.size() + integers.size();
    auto values = arrow::MakeArray(arrow::ArrayData::Make(
        value_type(column.type), static_cast<std::int64_t>(count), {nullptr, wrapped}, 0));
    if (column.width == 1) return values;
    return std::make_shared<arrow::FixedSizeListArray>(
        column_type(column), static_cast<std::int64_t>(count / column.width), values);
  }

  void clear() {
    floats.clear();
    doubles.clear();
    integers.clear();
  }

  Feature column;
  std::vector<float> floats;  // one of the three is in use
  std::vector<double> doubles;
  std::vector<std::int64_t> integers;
};

}  // namespace

struct TableWriter::Impl {
  std::filesystem::path path;
  std::shared_ptr<arrow::Schema> schema;
  std::vector<ColumnBuffer> columns;
  std::unique_ptr<ParquetWriter> file;
  std::size_t width = 0;
  std::size_t waiting = 0;  // rows

  void flush() {
    if (waiting == 0) return;
    arrow::ArrayVector arrays;
    for (const ColumnBuffer& column : columns) arrays.push_back(column.view());
    file->write(*arrow::Table::Make(schema, arrays, static_cast<std::int64_t>(waiting)));
    for (ColumnBuffer& column : columns) column.clear();
    waiting = 0;
  }
};

TableWriter::TableWriter(std::filesystem::path path, std::vector<Feature> columns)
    : impl_(std::make_unique<Impl>()) {
  impl_->path = std::move(path);
  impl_->schema = schema_of(columns);
  impl_->width = row_width(columns);
  for (const Feature& column : columns) impl_->columns.emplace_back(column);
  at_file(impl_->path, "cannot write",
          [&] { impl_->file = std::make_unique<ParquetWriter>(impl_->path, impl_->schema); });
}

TableWriter::~TableWriter() = default;

void TableWriter::append(std::span<const double> row) {
  check(row.size() == impl_->width, "a row fills the columns of its table");
  for (ColumnBuffer& column : impl_->columns) {
    column.append(row.first(column.column.width));
    row = row.subspan(column.column.width);
  }
  if (++impl_->waiting == kGroupRows) {
    at_file(impl_->path, "cannot write", [&] { impl_->flush(); });
  }
}

void TableWriter::close() {
  at_file(impl_->path, "cannot write", [&] {
    impl_->flush();
    impl_->file->close();
  });
}

struct TableReader::Impl {
  std::filesystem::path path;
  std::vector<Feature> columns;
  std::unique_ptr<parquet::arrow::FileReader> file;
  std::unique_ptr<arrow::RecordBatchReader> batches;
  std::vector<double> values;  // rows x width, of one batch
  std::size_t width = 0;
  std::size_t used = 0;  // values handed out

  /// The leaves of the wanted columns: the only parts of the file that are read.
  [[nodiscard]] std::vector<int> leaves() const {
    const parquet::SchemaDescriptor& schema = *file->parquet_reader()->metadata()->schema();
    std::vector<int> found;
    for (const Feature& column : columns) {
      int leaf = -1;
      for (int i = 0; i < schema.num_columns(); ++i) {
        if (schema.Column(i)->path()->ToDotVector().front() == column.name) leaf = i;
      }
      if (leaf < 0) throw std::runtime_error(fmt::format("it has no column '{}'", column.name));
      found.push_back(leaf);
    }
    return found;
  }

  /// Spreads one column of a batch over the rows of `values`.
  void take(const arrow::Array& column, const Feature& feature, std::size_t offset) {
    const auto rows = static_cast<std::size_t>(column.length());
    const auto refuse = [&](const char* why) {
      throw std::runtime_error(fmt::format("column '{}' {}", feature.name, why));
    };
    if (column.null_count() != 0) refuse("has missing values");
    const arrow::Array* flat = &column;
    std::int64_t first = 0;  // of this batch's values in `flat`
    std::shared_ptr<arrow::Array> inner;
    if (const auto* fixed = dynamic_cast<const arrow::FixedSizeListArray*>(&column)) {
      if (static_cast<std::size_t>(fixed->list_type()->list_size()) != feature.width) {
        refuse("has another width");
      }
      inner = fixed->values();
      first = fixed->value_offset(0);
    } else if (const auto* list = dynamic_cast<const arrow::ListArray*>(&column)) {
      for (std::int64_t row = 0; row < list->length(); ++row) {
        if (static_cast<std::size_t>(list->value_length(row)) != feature.width) {
          refuse("has another width");
        }
      }
      inner = list->values();
      first = list->value_offset(0);
    } else if (feature.width != 1) {
      refuse("has another width");
    }
    if (inner) flat = inner.get();
    if (flat->null_count() != 0) refuse("has missing values");
    if (flat->length() < first + static_cast<std::int64_t>(rows * feature.width)) {
      refuse("ends early");
    }
    const auto copy = [&](const auto& typed) {
      for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t i = 0; i < feature.width; ++i) {
          values[row * width + offset + i] = static_cast<double>(
              typed.Value(first + static_cast<std::int64_t>(row * feature.width + i)));
        }
      }
    };
    switch (flat->type_id()) {
      case arrow::Type::FLOAT:
        return copy(static_cast<const arrow::FloatArray&>(*flat));
      case arrow::Type::DOUBLE:
        return copy(static_cast<const arrow::DoubleArray&>(*flat));
      case arrow::Type::INT64:
        return copy(static_cast<const arrow::Int64Array&>(*flat));
      default:
        refuse("is not of numbers");
    }
  }

  /// False at the end.
  bool read_batch() {
    for (;;) {
      std::shared_ptr<arrow::RecordBatch> batch;
      require_good(batches->ReadNext(&batch));
      if (!batch) return false;
      if (batch->num_rows() == 0) continue;
      values.resize(static_cast<std::size_t>(batch->num_rows()) * width);
      used = 0;
      std::size_t offset = 0;
      for (const Feature& feature : columns) {
        const auto column = batch->GetColumnByName(feature.name);
        if (!column) throw std::runtime_error(fmt::format("column '{}' is broken", feature.name));
        take(*column, feature, offset);
        offset += feature.width;
      }
      return true;
    }
  }
};

TableReader::TableReader(std::filesystem::path path, std::vector<Feature> columns)
    : impl_(std::make_unique<Impl>()) {
  impl_->path = std::move(path);
  impl_->columns = std::move(columns);
  impl_->width = row_width(impl_->columns);
  check(impl_->width > 0, "a table is read by at least one column");
  at_file(impl_->path, "not a readable table", [&] {
    impl_->file = open_parquet(impl_->path);
    std::vector<int> groups;
    for (int i = 0; i < impl_->file->num_row_groups(); ++i) groups.push_back(i);
    impl_->batches = value_of(impl_->file->GetRecordBatchReader(groups, impl_->leaves()));
  });
}

TableReader::~TableReader() = default;

std::int64_t TableReader::rows() const {
  return impl_->file->parquet_reader()->metadata()->num_rows();
}

std::span<const double> TableReader::next() {
  Impl& my = *impl_;
  if (my.used == my.values.size()) {
    if (!at_file(my.path, "not a readable table", [&] { return my.read_batch(); })) {
      my.values.clear();
      my.used = 0;
      return {};
    }
  }
  const std::span<const double> row(my.values.data() + my.used, my.width);
  my.used += my.width;
  return row;
}

}  // namespace pacer::dataset
