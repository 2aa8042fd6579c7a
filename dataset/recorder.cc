// SPDX-License-Identifier: Apache-2.0
#include "dataset/recorder.h"

#include <fmt/format.h>

#include <array>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "core/check.h"
#include "dataset/files.h"
#include "dataset/info.h"
#include "dataset/layout.h"
#include "dataset/table.h"

namespace pacer::dataset {
namespace {

void clear_folder(const std::filesystem::path& folder) {
  for (const char* name : {kStagedEpisode, kStagedVideo, kStagedTable}) {
    std::filesystem::remove(folder / name);
  }
}

}  // namespace

struct EpisodeRecorder::Impl {
  /// What waits for the encoder. Slots are used over and over: nothing is allocated on the way.
  struct Slot {
    Frame frame;
    std::vector<double> row;
  };

  Impl(const std::filesystem::path& root, DatasetSpec dataset, std::int64_t number,
       const VideoSettings& settings)
      : spec(std::move(dataset)),
        episode(number),
        folder(Layout(root).unfinished(number)),
        lock((make_folder(folder), folder)),
        video((clear_folder(folder), folder / kStagedVideo), spec.image_size, spec.rate_hz,
              settings),
        table(folder / kStagedTable, spec.features()) {
    const std::size_t width = row_width(spec.features());
    const std::size_t bytes = static_cast<std::size_t>(spec.image_size.width) *
                              static_cast<std::size_t>(spec.image_size.height) * 3U;
    for (Slot& slot : slots) {
      slot.frame.rgb.reserve(bytes);
      slot.row.reserve(width);
    }
    for (const SignalColumn& signal : spec.signals) signal_width += signal.components.size();
    encoder = std::jthread([this] { encode(); });
  }

  ~Impl() {
    if (encoder.joinable()) {
      end_of_steps(/*drop=*/true);
      encoder.join();
    }
    std::error_code ignored;  // what stays is cleared by the next run
    if (!finished) std::filesystem::remove_all(folder, ignored);
  }

  // On the encoder's thread.

  void encode() {
    try {
      while (const Slot* slot = oldest()) {
        video.write(slot->frame);
        pictures.see(slot->frame);
        table.append(slot->row);
        release();
      }
    } catch (...) {
      const std::lock_guard hold(mutex);
      failure = std::current_exception();
      changed.notify_all();
    }
  }

  /// The oldest waiting slot; null when there will be none.
  const Slot* oldest() {
    std::unique_lock hold(mutex);
    changed.wait(hold, [&] { return waiting > 0 || ended; });
    return waiting == 0 || dropped ? nullptr : &slots[first];
  }
  void release() {
    const std::lock_guard hold(mutex);
    first = (first + 1) % slots.size();
    --waiting;
    changed.notify_all();
  }

  // On the caller's thread.

  Slot& free_slot() {
    std::unique_lock hold(mutex);
    changed.wait(hold, [&] { return waiting < slots.size() || failure != nullptr; });
    if (failure) std::rethrow_exception(failure);
    return slots[(first + waiting) % slots.size()];
  }
  void publish() {
    const std::lock_guard hold(mutex);
    ++waiting;
    changed.notify_all();
  }
  void end_of_steps(bool drop) {
    const std::lock_guard hold(mutex);
    ended = true;
    dropped = drop;
    changed.notify_all();
  }

  void fill(std::vector<double>& row, const Frame& frame, const Step& step) {
    const auto index = static_cast<double>(length);
    row.assign({last.steering, last.throttle, step.sent.steering, step.sent.throttle,
                step.wanted.steering, step.wanted.throttle, static_cast<double>(step.driver),
                microseconds(step.pulses.steering), microseconds(step.pulses.throttle),
                (frame.time - start).count()});
    row.insert(row.end(), step.signals.begin(), step.signals.end());
    row.insert(row.end(), {index / spec.rate_hz, index, static_cast<double>(episode),
                           index,  // among all frames: known at the commit
                           0.0});
  }

  DatasetSpec spec;
  std::int64_t episode;
  std::filesystem::path folder;
  FolderLock lock;

  VideoEncoder video;  // these three are the encoder thread's while it runs
  TableWriter table;
  ImageStatistics pictures;

  std::size_t signal_width = 0;
  std::int64_t length = 0;
  Seconds start{};
  Command last;
  bool finished = false;

  std::mutex mutex;  // over everything below
  std::condition_variable changed;
  std::array<Slot, kFramesBehind> slots;  // a ring: `waiting` of them from `first` on
  std::size_t first = 0;
  std::size_t waiting = 0;
  bool ended = false;
  bool dropped = false;
  std::exception_ptr failure;
  std::jthread encoder;
};

EpisodeRecorder::EpisodeRecorder(const std::filesystem::path& root, const DatasetSpec& spec,
                                 std::int64_t episode, const VideoSettings& video) {
  spec.validate();
  require(episode >= 0, "episode: must not be negative");
  impl_ = std::make_unique<Impl>(root, spec, episode, video);
}

EpisodeRecorder::~EpisodeRecorder() = default;

bool EpisodeRecorder::write(const Frame& frame, const Step& step) {
  Impl& my = *impl_;
  check(!my.ended, "steps are written before the episode is finished");
  check(step.signals.size() == my.signal_width, "a step's signals fill the dataset's columns");
  if (frame.size != my.spec.image_size) {
    throw std::invalid_argument(fmt::format(
        "the camera's frames are {} x {} pixels, the dataset's {} x {}", frame.size.width,
        frame.size.height, my.spec.image_size.width, my.spec.image_size.height));
  }
  if (my.length == 0) my.start = frame.time;
  Impl::Slot& slot = my.free_slot();
  slot.frame.index = frame.index;
  slot.frame.time = frame.time;
  slot.frame.size = frame.size;
  slot.frame.rgb.assign(frame.rgb.begin(), frame.rgb.end());
  my.fill(slot.row, frame, step);
  my.last = step.sent;
  ++my.length;
  my.publish();
  return true;
}

void EpisodeRecorder::finish() {
  Impl& my = *impl_;
  check(!my.ended, "an episode is finished once");
  my.end_of_steps(/*drop=*/false);
  my.encoder.join();
  if (my.failure) std::rethrow_exception(my.failure);
  if (my.length == 0) {
    throw std::runtime_error(fmt::format("{}: the episode has no frame", my.folder.string()));
  }
  my.video.close();
  my.table.close();
  sync(my.folder / kStagedVideo);
  sync(my.folder / kStagedTable);

  const DatasetInfo info = empty_info(my.spec);
  StatisticsByFeature statistics{{my.spec.camera, my.pictures.finish()}};
  for (auto& feature : measure_table(my.folder / kStagedTable, info.features)) {
    statistics.push_back(std::move(feature));
  }
  const nlohmann::ordered_json json{{"length", my.length},
                                    {"video_hash", hash_of_file(my.folder / kStagedVideo)},
                                    {"statistics", statistics_json(statistics, info)}};
  replace_text(my.folder / kStagedEpisode, my.folder / "episode.json.new", json.dump());
  sync(my.folder);
  my.finished = true;
}

StagedEpisode read_staged(const std::filesystem::path& folder, const DatasetSpec& spec) {
  const std::filesystem::path path = folder / kStagedEpisode;
  const std::string text = read_text(path);
  try {
    const auto json = nlohmann::ordered_json::parse(text);
    return {.length = json.at("length"),
            .video_hash = json.at("video_hash"),
            .statistics = parse_statistics(json.at("statistics"), empty_info(spec))};
  } catch (const nlohmann::json::exception& error) {
    throw std::runtime_error(fmt::format("{}: not of a finished episode: {}", path.string(),
                                         std::string_view(error.what())));
  }
}

StatisticsByFeature measure_table(const std::filesystem::path& path,
                                  const std::vector<Feature>& features) {
  StatisticsBuilder builder(row_width(features));
  std::int64_t rows = 0;
  for (TableReader table(path, features);; ++rows) {
    const std::span<const double> row = table.next();
    if (row.empty()) break;
    builder.see(row);
  }
  for (TableReader table(path, features);;) {
    const std::span<const double> row = table.next();
    if (row.empty()) break;
    builder.see_again(row);
  }
  const std::vector<ValueStatistics> values = builder.finish();
  StatisticsByFeature all;
  auto next = values.begin();
  for (const Feature& feature : features) {
    const auto end = next + static_cast<std::ptrdiff_t>(feature.width);
    all.emplace_back(feature.name, FeatureStatistics{.components = {next, end}, .count = rows});
    next = end;
  }
  return all;
}

}  // namespace pacer::dataset
