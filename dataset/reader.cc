// SPDX-License-Identifier: Apache-2.0
#include "dataset/reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/check.h"
#include "dataset/files.h"
#include "dataset/layout.h"
#include "dataset/table.h"
#include "dataset/video.h"

namespace pacer::dataset {
namespace {

namespace fs = std::filesystem;

/// The files `*/*extension` below a folder, sorted.
std::vector<fs::path> files_below(const fs::path& folder, const char* extension) {
  std::vector<fs::path> files;
  if (!fs::is_directory(folder)) return files;
  for (const fs::directory_entry& chunk : fs::directory_iterator(folder)) {
    if (!chunk.is_directory()) continue;
    for (const fs::directory_entry& file : fs::directory_iterator(chunk.path())) {
      if (file.path().extension() == extension) files.push_back(file.path());
    }
  }
  std::ranges::sort(files);
  return files;
}

}  // namespace

Dataset::Dataset(fs::path root) : root_(std::move(root)) {
  const Layout layout(root_);
  if (!fs::exists(layout.info())) {
    throw UsageError(fmt::format("{}: no dataset: it has no meta/info.json", root_.string()));
  }
  info_ = read_info(layout.info());
  for (const fs::path& file : files_below(layout.episodes(), ".parquet")) {
    for (EpisodeEntry& entry : read_episode_file(file, info_, /*with_statistics=*/false)) {
      if (entry.episode != static_cast<std::int64_t>(episodes_.size())) {
        throw std::runtime_error(fmt::format("{}: holds episode {} where {} was expected",
                                             file.string(), entry.episode, episodes_.size()));
      }
      episodes_.push_back(std::move(entry));
    }
  }
}

std::string Dataset::scenario() const {
  const fs::path path = Layout(root_).scenario();
  return fs::exists(path) ? read_text(path) : std::string();
}

std::string Dataset::task() const {
  const std::vector<std::string> tasks = read_tasks_file(Layout(root_).tasks());
  return tasks.empty() ? std::string() : tasks.front();
}

std::string Dataset::fingerprint() const {
  const Layout layout(root_);
  std::vector<fs::path> files{layout.info(), layout.tasks()};
  if (fs::exists(layout.scenario())) files.push_back(layout.scenario());
  for (const fs::path& folder : {layout.episodes(), layout.data()}) {
    for (fs::path& file : files_below(folder, ".parquet")) files.push_back(std::move(file));
  }
  for (fs::path& file : files_below(layout.videos(info_.camera), ".mp4")) {
    files.push_back(std::move(file));
  }
  ContentHash hash;
  for (const fs::path& file : files) {
    hash.add(fmt::format("{} {}\n", file.lexically_relative(root_).generic_string(),
                         fs::file_size(file)));
    hash.add_file(file);
  }
  return hash.finish();
}

std::vector<Feature> Dataset::features(const std::vector<std::string>& names) const {
  std::vector<Feature> found;
  for (const std::string& name : names) {
    const auto feature = std::ranges::find(info_.features, name, &Feature::name);
    if (feature == info_.features.end()) {
      throw UsageError(fmt::format("{}: has no column '{}'", root_.string(), name));
    }
    found.push_back(*feature);
  }
  return found;
}

fs::path Dataset::data_file(std::size_t episode) const {
  const EpisodeEntry& entry = episodes_.at(episode);
  return Layout(root_).data() / Layout::numbered(entry.data_chunk, entry.data_file, ".parquet");
}

fs::path Dataset::video_file(std::size_t episode) const {
  const EpisodeEntry& entry = episodes_.at(episode);
  return Layout(root_).videos(info_.camera) /
         Layout::numbered(entry.video_chunk, entry.video_file, ".mp4");
}

struct EpisodeReader::Impl {
  static constexpr std::size_t kOwnColumns = 3;  // episode_index, frame_index, time

  const Dataset& dataset;
  const EpisodeEntry& entry;
  fs::path data_path;
  fs::path video_path;
  TableReader table;
  std::optional<VideoDecoder> video;
  Frame frame;
  RecordedStep step;
  double time = -1.0;     // s, of the last row
  std::int64_t read = 0;  // rows

  Impl(const Dataset& from, std::size_t episode, const std::vector<std::string>& columns,
       Frames frames)
      : dataset(from),
        entry(from.episodes()[episode]),
        data_path(from.data_file(episode)),
        video_path(from.video_file(episode)),
        table(data_path, own_and(columns)) {
    if (frames == Frames::kLeave) return;
    video.emplace(video_path);
    const ImageSize size = video->size();
    if (size != dataset.info().image_size) {
      throw std::runtime_error(fmt::format(
          "{}: its pictures are {} x {}, the dataset's {} x {}", video_path.string(), size.width,
          size.height, dataset.info().image_size.width, dataset.info().image_size.height));
    }
    if (entry.video_from > 0.0) video->seek(Seconds{entry.video_from});
  }

  [[nodiscard]] std::vector<Feature> own_and(const std::vector<std::string>& columns) const {
    const auto& all = dataset.info().features;
    const bool captured = std::ranges::find(all, kCaptureTime, &Feature::name) != all.end();
    std::vector<Feature> features = dataset.features(
        {"episode_index", "frame_index", std::string(captured ? kCaptureTime : "timestamp")});
    for (Feature& feature : dataset.features(columns)) features.push_back(std::move(feature));
    return features;
  }

  [[noreturn]] void fail(const fs::path& path, const char* what) const {
    throw std::runtime_error(
        fmt::format("{}: {} at frame {} of episode {}", path.string(), what, read, entry.episode));
  }

  const RecordedStep* next() {
    if (read == entry.length) return nullptr;
    std::span<const double> row = table.next();
    while (read == 0 && !row.empty() && row[0] != static_cast<double>(entry.episode)) {
      row = table.next();  // another episode of the same file
    }
    if (row.empty()) fail(data_path, "ends early");
    if (row[0] != static_cast<double>(entry.episode) || row[1] != static_cast<double>(read)) {
      fail(data_path, "rows are out of order");
    }
    if (!(row[2] > time)) fail(data_path, "time does not rise");
    time = row[2];
    if (video) {
      if (!video->next(frame)) fail(video_path, "ends early");
      frame.index = static_cast<std::uint64_t>(read);
      frame.time = Seconds{row[2]};
      step.frame = &frame;
    }
    step.values = row.subspan(kOwnColumns);
    ++read;
    return &step;
  }
};

EpisodeReader::EpisodeReader(const Dataset& dataset, std::size_t episode,
                             const std::vector<std::string>& columns, Frames frames) {
  if (episode >= dataset.episodes().size()) {
    throw UsageError(fmt::format("{}: has no episode {}, only {}", dataset.root().string(), episode,
                                 dataset.episodes().size()));
  }
  impl_ = std::make_unique<Impl>(dataset, episode, columns, frames);
}

EpisodeReader::~EpisodeReader() = default;
EpisodeReader::EpisodeReader(EpisodeReader&&) noexcept = default;

const RecordedStep* EpisodeReader::next() { return impl_->next(); }

}  // namespace pacer::dataset
