// SPDX-License-Identifier: Apache-2.0
#include "dataset/episode_file.h"

#include <fmt/format.h>

#include <numeric>

#include "dataset/parquet_file.h"

namespace pacer::dataset {
namespace {

constexpr std::int64_t kMostRows = 1'000'000;

/// One row, column by column.
class RowOfColumns {
 public:
  void add(const std::string& name, std::int64_t value) { add(name, integers({value})); }
  void add(const std::string& name, double value) { add(name, reals({value})); }
  void add_texts(const std::string& name, const std::vector<std::string>& texts) {
    arrow::StringBuilder builder;
    require_good(builder.AppendValues(texts));
    add(name, list(value_of(builder.Finish()), {0, static_cast<std::int32_t>(texts.size())}));
  }
  void add_list(const std::string& name, std::shared_ptr<arrow::Array> values) {
    const auto count = static_cast<std::int32_t>(values->length());
    add(name, list(std::move(values), {0, count}));
  }
  void add(const std::string& name, std::shared_ptr<arrow::Array> array) {
    fields_.push_back(arrow::field(name, array->type()));
    arrays_.push_back(std::move(array));
  }

  [[nodiscard]] std::shared_ptr<arrow::Table> table() const {
    return arrow::Table::Make(arrow::schema(fields_), arrays_, 1);
  }

  static std::shared_ptr<arrow::Array> integers(const std::vector<std::int64_t>& values) {
    arrow::Int64Builder builder;
    require_good(builder.AppendValues(values));
    return value_of(builder.Finish());
  }
  static std::shared_ptr<arrow::Array> reals(const std::vector<double>& values) {
    arrow::DoubleBuilder builder;
    require_good(builder.AppendValues(values));
    return value_of(builder.Finish());
  }
  static std::shared_ptr<arrow::Array> list(std::shared_ptr<arrow::Array> values,
                                            const std::vector<std::int32_t>& offsets) {
    const auto type = arrow::list(arrow::field("element", values->type()));
    return std::make_shared<arrow::ListArray>(type, static_cast<std::int64_t>(offsets.size()) - 1,
                                              arrow::Buffer::FromVector(offsets),
                                              std::move(values));
  }

 private:
  arrow::FieldVector fields_;
  arrow::ArrayVector arrays_;
};

void add_statistics(RowOfColumns& row, const std::string& name, const FeatureStatistics& feature,
                    bool image, bool integer) {
  const auto add = [&](const char* statistic, auto&& of, bool whole) {
    std::vector<double> numbers;
    for (const ValueStatistics& value : feature.components) numbers.push_back(of(value));
    auto values = whole ? RowOfColumns::integers({numbers.begin(), numbers.end()})
                        : RowOfColumns::reals(numbers);
    if (image) {  // [3][1][1]
      std::vector<std::int32_t> each(numbers.size() + 1);
      std::iota(each.begin(), each.end(), 0);
      values = RowOfColumns::list(RowOfColumns::list(std::move(values), each), each);
    }
    row.add_list(fmt::format("stats/{}/{}", name, statistic), std::move(values));
  };
  add(
      "min", [](const ValueStatistics& value) { return value.min; }, integer);
  add(
      "max", [](const ValueStatistics& value) { return value.max; }, integer);
  add(
      "mean", [](const ValueStatistics& value) { return value.mean; }, false);
  add(
      "std", [](const ValueStatistics& value) { return value.deviation; }, false);
  row.add_list(fmt::format("stats/{}/count", name), RowOfColumns::integers({feature.count}));
  for (std::size_t q = 0; q < kQuantiles.size(); ++q) {
    add(
        kQuantileNames[q], [q](const ValueStatistics& value) { return value.quantiles[q]; }, false);
  }
}

/// The numbers in an array of numbers or, however deep, of lists of them.
std::vector<double> numbers_in(const arrow::Array& array) {
  if (array.null_count() != 0) throw std::runtime_error("a number is missing");
  if (const auto* list = dynamic_cast<const arrow::ListArray*>(&array)) {
    return numbers_in(*value_of(list->Flatten()));
  }
  if (const auto* list = dynamic_cast<const arrow::FixedSizeListArray*>(&array)) {
    return numbers_in(*value_of(list->Flatten()));
  }
  std::vector<double> numbers;
  const auto copy = [&](const auto& typed) {
    for (std::int64_t i = 0; i < typed.length(); ++i) {
      numbers.push_back(static_cast<double>(typed.Value(i)));
    }
  };
  if (const auto* typed = dynamic_cast<const arrow::DoubleArray*>(&array)) {
    copy(*typed);
  } else if (const auto* floats = dynamic_cast<const arrow::FloatArray*>(&array)) {
    copy(*floats);
  } else if (const auto* integers = dynamic_cast<const arrow::Int64Array*>(&array)) {
    copy(*integers);
  } else {
    throw std::runtime_error("a column is not of numbers");
  }
  return numbers;
}

std::vector<std::string> texts_in(const arrow::Array& array) {
  std::vector<std::string> texts;
  const auto copy = [&](const auto& typed) {
    for (std::int64_t i = 0; i < typed.length(); ++i) texts.emplace_back(typed.GetView(i));
  };
  if (const auto* list = dynamic_cast<const arrow::ListArray*>(&array)) {
    return texts_in(*value_of(list->Flatten()));
  }
  if (const auto* typed = dynamic_cast<const arrow::StringArray*>(&array)) {
    copy(*typed);
  } else if (const auto* large = dynamic_cast<const arrow::LargeStringArray*>(&array)) {
    copy(*large);
  } else {
    throw std::runtime_error("a column is not of texts");
  }
  return texts;
}

/// Some columns of a small file, whole, each in one piece.
class SmallTable {
 public:
  /// Reads the columns for which `wanted(name)`.
  template <class Wanted>
  SmallTable(const std::filesystem::path& path, Wanted&& wanted) {
    const auto file = open_parquet(path);
    const auto& metadata = *file->parquet_reader()->metadata();
    if (metadata.num_rows() < 0 || metadata.num_rows() > kMostRows) {
      throw std::runtime_error(fmt::format("it has {} rows", metadata.num_rows()));
    }
    std::vector<int> leaves;
    for (int i = 0; i < metadata.schema()->num_columns(); ++i) {
      if (wanted(metadata.schema()->Column(i)->path()->ToDotVector().front())) leaves.push_back(i);
    }
    table_ = value_of(value_of(file->ReadTable(leaves))->CombineChunks());
  }

  [[nodiscard]] std::int64_t rows() const { return table_->num_rows(); }
  [[nodiscard]] const arrow::Schema& schema() const { return *table_->schema(); }

  /// The column's part in one row; null when there is no such column.
  [[nodiscard]] std::shared_ptr<arrow::Array> cell(const std::string& column,
                                                   std::int64_t row) const {
    const auto found = table_->GetColumnByName(column);
    if (!found || found->num_chunks() != 1) return nullptr;
    return found->chunk(0)->Slice(row, 1);
  }
  [[nodiscard]] double number(const std::string& column, std::int64_t row) const {
    const auto found = cell(column, row);
    if (!found) throw std::runtime_error(fmt::format("it has no column '{}'", column));
    const std::vector<double> numbers = numbers_in(*found);
    if (numbers.size() != 1) throw std::runtime_error(fmt::format("'{}' is no number", column));
    return numbers.front();
  }
  [[nodiscard]] std::int64_t count(const std::string& column, std::int64_t row) const {
    const double value = number(column, row);
    if (!(value >= 0.0 && value <= 1e15)) {
      throw std::runtime_error(fmt::format("'{}' is {}", column, value));
    }
    return static_cast<std::int64_t>(value);
  }

 private:
  std::shared_ptr<arrow::Table> table_;
};

StatisticsByFeature statistics_in(const SmallTable& table, std::int64_t row,
                                  const DatasetInfo& info) {
  StatisticsByFeature all;
  for (const Feature& feature : measured_features(info)) {
    const auto numbers = [&](const char* statistic, std::size_t width) {
      const auto cell = table.cell(fmt::format("stats/{}/{}", feature.name, statistic), row);
      if (!cell) throw std::out_of_range("no statistics");
      std::vector<double> found = numbers_in(*cell);
      if (found.size() != width) {
        throw std::runtime_error(
            fmt::format("the statistics of '{}' are of another width", feature.name));
      }
      return found;
    };
    try {
      FeatureStatistics statistics;
      statistics.components.resize(feature.width);
      statistics.count = static_cast<std::int64_t>(numbers("count", 1).front());
      const auto spread = [&](const char* statistic, auto&& into) {
        const std::vector<double> found = numbers(statistic, feature.width);
        for (std::size_t i = 0; i < found.size(); ++i) into(statistics.components[i]) = found[i];
      };
      spread("min", [](ValueStatistics& value) -> double& { return value.min; });
      spread("max", [](ValueStatistics& value) -> double& { return value.max; });
      spread("mean", [](ValueStatistics& value) -> double& { return value.mean; });
      spread("std", [](ValueStatistics& value) -> double& { return value.deviation; });
      for (std::size_t q = 0; q < kQuantiles.size(); ++q) {
        spread(kQuantileNames[q],
               [q](ValueStatistics& value) -> double& { return value.quantiles[q]; });
      }
      all.emplace_back(feature.name, std::move(statistics));
    } catch (const std::out_of_range&) {
      return {};
    }
  }
  return all;
}

}  // namespace

void write_episode_file(const std::filesystem::path& path, const EpisodeEntry& entry,
                        const DatasetInfo& info) {
  at_file(path, "cannot write", [&] {
    RowOfColumns row;
    const std::string video = "videos/" + info.camera;
    row.add("episode_index", entry.episode);
    row.add_texts("tasks", entry.tasks);
    row.add("length", entry.length);
    row.add("data/chunk_index", entry.data_chunk);
    row.add("data/file_index", entry.data_file);
    row.add("dataset_from_index", entry.first_index);
    row.add("dataset_to_index", entry.first_index + entry.length);
    row.add(video + "/chunk_index", entry.video_chunk);
    row.add(video + "/file_index", entry.video_file);
    row.add(video + "/from_timestamp", entry.video_from);
    row.add(video + "/to_timestamp", entry.video_to);
    for (const auto& [name, feature] : entry.statistics) {
      add_statistics(row, name, feature, is_image(info, name), is_integer(info, name));
    }
    row.add("meta/episodes/chunk_index", entry.data_chunk);
    row.add("meta/episodes/file_index", entry.data_file);
    const auto table = row.table();
    ParquetWriter file(path, table->schema());
    file.write(*table);
    file.close();
  });
}

std::vector<EpisodeEntry> read_episode_file(const std::filesystem::path& path,
                                            const DatasetInfo& info, bool with_statistics) {
  return at_file(path, "not a readable table of episodes", [&] {
    const SmallTable table(path, [&](const std::string& column) {
      return with_statistics || !column.starts_with("stats/");
    });
    const std::string video = "videos/" + info.camera;
    std::vector<EpisodeEntry> entries;
    for (std::int64_t row = 0; row < table.rows(); ++row) {
      EpisodeEntry& entry = entries.emplace_back();
      entry.episode = table.count("episode_index", row);
      entry.length = table.count("length", row);
      entry.first_index = table.count("dataset_from_index", row);
      entry.data_chunk = table.count("data/chunk_index", row);
      entry.data_file = table.count("data/file_index", row);
      entry.video_chunk = table.count(video + "/chunk_index", row);
      entry.video_file = table.count(video + "/file_index", row);
      entry.video_from = table.number(video + "/from_timestamp", row);
      entry.video_to = table.number(video + "/to_timestamp", row);
      if (table.count("dataset_to_index", row) != entry.first_index + entry.length) {
        throw std::runtime_error("an episode's indices are not as many as its frames");
      }
      if (const auto tasks = table.cell("tasks", row)) entry.tasks = texts_in(*tasks);
      if (with_statistics) entry.statistics = statistics_in(table, row, info);
    }
    return entries;
  });
}

void write_tasks_file(const std::filesystem::path& path, const std::string& task) {
  // The task's text is the index of a pandas frame, which says so in the footer.
  constexpr const char* kPandas =
      R"({"index_columns": ["__index_level_0__"], "column_indexes": [{"name": null, )"
      R"("field_name": null, "pandas_type": "unicode", "numpy_type": "str", )"
      R"("metadata": {"encoding": "UTF-8"}}], "columns": [{"name": "task_index", )"
      R"("field_name": "task_index", "pandas_type": "int64", "numpy_type": "int64", )"
      R"("metadata": null}, {"name": null, "field_name": "__index_level_0__", )"
      R"("pandas_type": "object", "numpy_type": "str", "metadata": null}], "attributes": {}, )"
      R"("creator": {"library": "pyarrow", "version": "26.0.1"}, "pandas_version": "3.1.1"})";
  at_file(path, "cannot write", [&] {
    arrow::LargeStringBuilder text;
    require_good(text.Append(task));
    const auto schema = arrow::schema({arrow::field("task_index", arrow::int64()),
                                       arrow::field("__index_level_0__", arrow::large_utf8())},
                                      arrow::key_value_metadata({"pandas"}, {kPandas}));
    ParquetWriter file(path, schema);
    file.write(
        *arrow::Table::Make(schema, {RowOfColumns::integers({0}), value_of(text.Finish())}, 1));
    file.close();
  });
}

std::vector<std::string> read_tasks_file(const std::filesystem::path& path) {
  return at_file(path, "not a readable table of tasks", [&] {
    const SmallTable table(path, [](const std::string&) { return true; });
    std::vector<std::string> tasks(static_cast<std::size_t>(table.rows()));
    std::string texts;
    for (const auto& field : table.schema().fields()) {
      if (field->name() != "task_index") texts = field->name();
    }
    for (std::int64_t row = 0; row < table.rows(); ++row) {
      const auto task = static_cast<std::size_t>(table.count("task_index", row));
      const auto text = table.cell(texts, row);
      if (task >= tasks.size() || !text) throw std::runtime_error("its tasks are not numbered");
      tasks[task] = texts_in(*text).at(0);
    }
    return tasks;
  });
}

}  // namespace pacer::dataset
