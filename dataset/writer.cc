// SPDX-License-Identifier: Apache-2.0
#include "dataset/writer.h"

#include <fmt/format.h>

#include <optional>

#include "core/check.h"
#include "dataset/episode_file.h"
#include "dataset/files.h"
#include "dataset/info.h"
#include "dataset/layout.h"
#include "dataset/recorder.h"
#include "dataset/table.h"

namespace pacer::dataset {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::int64_t rows_of(const fs::path& path) {
  return TableReader(path, {{.name = "index", .type = ValueType::kInt64, .components = {}}}).rows();
}

/// The first line in which two texts differ, as both have it.
std::string difference(std::string_view there, std::string_view here) {
  const auto cut = [](std::string_view& text) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(text.size(), line.size() + 1));
    return line;
  };
  for (int number = 1; !there.empty() || !here.empty(); ++number) {
    const std::string_view one = cut(there);
    const std::string_view other = cut(here);
    if (one != other) {
      return fmt::format("line {}: '{}' there, '{}' here", number, one, other);
    }
  }
  return "nothing";
}

}  // namespace

struct DatasetWriter::Impl {
  Layout layout;
  DatasetSpec spec;
  DatasetInfo info;
  std::optional<FolderLock> lock;
  std::vector<StatisticsByFeature> statistics;  // of each episode
  Json hashes = Json::object();                 // by path from the root

  [[nodiscard]] std::string relative(const fs::path& path) const {
    return path.lexically_relative(layout.root()).generic_string();
  }
  [[nodiscard]] fs::path aside(const char* name) const { return layout.unfinished() / name; }

  [[noreturn]] void refuse(const std::string& why) const {
    throw UsageError(fmt::format("{}: {}", layout.root().string(), why));
  }
  [[noreturn]] void damaged(const std::string& why) const {
    throw std::runtime_error(fmt::format("{}: damaged: {}; look at it with `pacer inspect`",
                                         layout.root().string(), why));
  }

  // Opening.

  void create() {
    for (const fs::directory_entry& entry : fs::directory_iterator(layout.root())) {
      const fs::path name = entry.path().filename();
      if (name != "meta" && name != ".unfinished") {
        refuse("neither a dataset nor empty; choose another folder");
      }
    }
    make_folder(layout.root() / "meta");
    make_folder(layout.unfinished());
    replace_text(layout.scenario(), aside("scenario.yaml"), spec.scenario);
    write_tasks_file(aside("tasks.parquet"), spec.task);
    sync(aside("tasks.parquet"));
    move(aside("tasks.parquet"), layout.tasks());
    write_summary();  // with info.json last: from now on it is a dataset
    sync(layout.root());
  }

  void require_same_spec(const DatasetInfo& there) const {
    constexpr const char* kRemedy = "record to another folder";
    const ImageSize size = there.image_size;
    if (size != spec.image_size || there.camera != spec.camera) {
      refuse(fmt::format("recorded with another camera ('{}', {} x {}, not '{}', {} x {}); {}",
                         there.camera, size.width, size.height, spec.camera, spec.image_size.width,
                         spec.image_size.height, kRemedy));
    }
    if (there.rate_hz != spec.rate_hz) {
      refuse(fmt::format("recorded at {} frames a second, not {}; {}", there.rate_hz, spec.rate_hz,
                         kRemedy));
    }
    if (there.robot_type != spec.robot_type) {
      refuse(fmt::format("recorded with a '{}', not a '{}'; {}", there.robot_type, spec.robot_type,
                         kRemedy));
    }
    if (there.features != info.features) {
      refuse(fmt::format("recorded with other columns; {}", kRemedy));
    }
    if (read_tasks_file(layout.tasks()) != std::vector<std::string>{spec.task}) {
      refuse(fmt::format("recorded for another task; {}", kRemedy));
    }
    const std::string scenario = fs::exists(layout.scenario()) ? read_text(layout.scenario()) : "";
    if (scenario != spec.scenario) {
      refuse(fmt::format("recorded from another scenario ({}); {}",
                         difference(scenario, spec.scenario), kRemedy));
    }
  }

  /// Counts the episodes that are whole, and removes what a killed commit left of the next.
  void recover(std::int64_t promised) {
    if (fs::exists(layout.hashes())) {
      const Json there = Json::parse(read_text(layout.hashes()), nullptr, false);
      if (there.is_object()) hashes = there;
    }
    Json found = Json::object();
    while (fs::exists(layout.episode_file(info.episodes))) {
      adopt(info.episodes);
      for (const fs::path& path : {layout.data_file(info.episodes - 1),
                                   layout.video_file(spec.camera, info.episodes - 1)}) {
        const std::string key = relative(path);
        found[key] = hashes.contains(key) ? hashes[key] : Json(hash_of_file(path));
      }
    }
    hashes = found;
    if (info.episodes < promised) {
      damaged(
          fmt::format("info.json speaks of {} episodes, {} are there", promised, info.episodes));
    }
    for (std::int64_t episode = 0; episode < info.episodes; ++episode) {
      fs::remove_all(layout.unfinished(episode));
    }
    const std::int64_t next = info.episodes;
    const fs::path folder = layout.unfinished(next);
    if (fs::exists(folder / kStagedEpisode) && !fs::exists(folder / kStagedVideo) &&
        fs::exists(layout.video_file(spec.camera, next))) {
      move(layout.video_file(spec.camera, next), folder / kStagedVideo);
    }
    fs::remove(layout.video_file(spec.camera, next));
    fs::remove(layout.data_file(next));
    write_summary();
  }

  /// Takes in an episode whose entry is there.
  void adopt(std::int64_t episode) {
    const fs::path path = layout.episode_file(episode);
    const std::vector<EpisodeEntry> entries = read_episode_file(path, info, true);
    if (entries.size() != 1 || entries[0].episode != episode ||
        entries[0].data_chunk * Layout::kFilesInChunk + entries[0].data_file != episode ||
        entries[0].statistics.empty()) {
      refuse("written by another program; record to another folder");
    }
    if (entries[0].first_index != info.frames) {
      damaged(fmt::format("{} does not follow the episode before", relative(path)));
    }
    const fs::path data = layout.data_file(episode);
    if (!fs::exists(data) || rows_of(data) != entries[0].length) {
      damaged(
          fmt::format("{} has not the {} rows of its episode", relative(data), entries[0].length));
    }
    const fs::path video = layout.video_file(spec.camera, episode);
    if (!fs::exists(video) || fs::file_size(video) == 0) {
      damaged(fmt::format("{} is missing", relative(video)));
    }
    statistics.push_back(entries[0].statistics);
    ++info.episodes;
    info.frames += entries[0].length;
  }

  // Committing.

  /// Writes the files that are about the whole dataset to the side.
  void stage_summary() const {
    write_text(aside("stats.json"), statistics_json(aggregate(statistics), info).dump(4));
    write_text(aside("hashes.json"), hashes.dump(1));
    write_text(aside("info.json"), info_text(info));
  }
  void place_summary() const {
    move(aside("stats.json"), layout.statistics());
    move(aside("hashes.json"), layout.hashes());
    move(aside("info.json"), layout.info());
  }
  void write_summary() const {
    stage_summary();
    place_summary();
    sync(layout.root() / "meta");
  }

  /// Copies the table with the place of its rows among all of the dataset's.
  void number_rows(const fs::path& from, const fs::path& to) const {
    const std::size_t place = row_offset(info.features, "index");
    TableReader reader(from, info.features);
    TableWriter writer(to, info.features);
    std::vector<double> row;
    for (;;) {
      const std::span<const double> values = reader.next();
      if (values.empty()) break;
      row.assign(values.begin(), values.end());
      row[place] += static_cast<double>(info.frames);
      writer.append(row);
    }
    writer.close();
    sync(to);
  }

  void commit() {
    const std::int64_t episode = info.episodes;
    const fs::path folder = layout.unfinished(episode);
    StagedEpisode staged = read_staged(folder, spec);
    const fs::path table = folder / "numbered.parquet";
    const fs::path entry_file = folder / "entry.parquet";
    number_rows(folder / kStagedTable, table);
    const StatisticsByFeature index =
        measure_table(table, {{.name = "index", .type = ValueType::kInt64, .components = {}}});
    for (auto& feature : staged.statistics) {
      if (feature.first == "index") feature = index.front();
    }
    const EpisodeEntry entry{
        .episode = episode,
        .length = staged.length,
        .first_index = info.frames,
        .data_chunk = episode / Layout::kFilesInChunk,
        .data_file = episode % Layout::kFilesInChunk,
        .video_chunk = episode / Layout::kFilesInChunk,
        .video_file = episode % Layout::kFilesInChunk,
        .video_to = static_cast<double>(staged.length) / spec.rate_hz,
        .tasks = {spec.task},
        .statistics = staged.statistics,
    };
    write_episode_file(entry_file, entry, info);
    sync(entry_file);

    Impl after{.layout = layout, .spec = spec, .info = info, .lock = {}, .statistics = statistics};
    after.hashes = hashes;
    after.info.episodes += 1;
    after.info.frames += staged.length;
    after.statistics.push_back(std::move(staged.statistics));
    const fs::path data_to = layout.data_file(episode);
    const fs::path video_to = layout.video_file(spec.camera, episode);
    const fs::path entry_to = layout.episode_file(episode);
    after.hashes[relative(data_to)] = hash_of_file(table);
    after.hashes[relative(video_to)] = staged.video_hash;
    after.stage_summary();
    for (const fs::path& to : {data_to, video_to, entry_to}) make_folder(to.parent_path());

    // Everything is on the disk. From here to the end it is names alone, and no time to be killed
    // in; if so, the frames without an entry are taken back when the dataset is opened again.
    move(folder / kStagedVideo, video_to);
    move(table, data_to);
    move(entry_file, entry_to);
    place_summary();
    for (const fs::path& to : {data_to, video_to, entry_to, layout.info()}) sync(to.parent_path());
    info = after.info;
    statistics = std::move(after.statistics);
    hashes = std::move(after.hashes);
    fs::remove_all(folder);
  }
};

DatasetWriter::DatasetWriter(fs::path root, DatasetSpec spec)
    : impl_(new Impl{.layout = Layout(std::move(root)),
                     .spec = std::move(spec),
                     .info = {},
                     .lock = {},
                     .statistics = {}}) {
  Impl& my = *impl_;
  my.spec.validate();
  my.info = empty_info(my.spec);
  const Layout& layout = my.layout;
  if (fs::exists(layout.root()) && !fs::is_directory(layout.root())) {
    my.refuse("a file, not a folder; choose another name");
  }
  make_folder(layout.root());
  my.lock.emplace(layout.root());
  if (!fs::exists(layout.info())) {
    my.create();
    return;
  }
  const DatasetInfo there = read_info(layout.info());
  my.require_same_spec(there);
  make_folder(layout.unfinished());
  my.recover(there.episodes);
}

DatasetWriter::~DatasetWriter() {
  std::error_code ignored;  // it stays when episodes wait in it
  fs::remove(impl_->layout.unfinished(), ignored);
}

std::int64_t DatasetWriter::episodes() const { return impl_->info.episodes; }
std::int64_t DatasetWriter::frames() const { return impl_->info.frames; }

bool DatasetWriter::is_finished(std::int64_t episode) const {
  const fs::path folder = impl_->layout.unfinished(episode);
  return fs::exists(folder / kStagedEpisode) && fs::exists(folder / kStagedVideo) &&
         fs::exists(folder / kStagedTable);
}

void DatasetWriter::commit() { impl_->commit(); }

std::int64_t DatasetWriter::commit_finished() {
  std::int64_t count = 0;
  for (; is_finished(episodes()); ++count) commit();
  return count;
}

}  // namespace pacer::dataset
