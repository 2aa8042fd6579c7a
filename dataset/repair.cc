// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "core/check.h"
#include "dataset/episode_file.h"
#include "dataset/files.h"
#include "dataset/info.h"
#include "dataset/inspect.h"
#include "dataset/layout.h"
#include "dataset/table.h"
#include "dataset/video.h"
#include "dataset/writer.h"

namespace pacer::dataset {
namespace {

namespace fs = std::filesystem;

/// The spec that a dataset was recorded with, from what it says of itself.
DatasetSpec spec_of(const Layout& layout, const DatasetInfo& info, const std::string& task) {
  DatasetSpec spec;
  spec.task = task;
  spec.image_size = info.image_size;
  spec.rate_hz = info.rate_hz;
  spec.camera = info.camera;
  spec.robot_type = info.robot_type;
  if (fs::exists(layout.scenario())) spec.scenario = read_text(layout.scenario());
  const std::vector<Feature> common = spec.features();
  for (const Feature& feature : info.features) {
    if (std::ranges::find(common, feature.name, &Feature::name) == common.end()) {
      spec.signals.push_back({.name = feature.name, .components = feature.components});
    }
  }
  if (spec.features() == info.features && fs::exists(layout.hashes()) && spec.scenario.empty()) {
    throw UsageError(fmt::format("{}: is lost, and cannot be made up; put it back, or record anew",
                                 layout.scenario().string()));
  }
  if (spec.features() != info.features || spec.scenario.empty()) {
    throw UsageError(fmt::format("{}: written by another program, which has to repair it",
                                 layout.root().string()));
  }
  try {
    const std::vector<std::string> tasks = read_tasks_file(layout.tasks());
    if (tasks.size() == 1) spec.task = tasks.front();
  } catch (const std::runtime_error&) {  // written anew
  }
  return spec;
}

/// Why an episode is not whole; empty when it is.
std::string broken(const Layout& layout, const DatasetInfo& info,
                   const nlohmann::ordered_json& hashes, std::int64_t episode,
                   std::int64_t first_index) {
  try {
    const auto entries = read_episode_file(layout.episode_file(episode), info, true);
    if (entries.size() != 1 || entries[0].episode != episode || entries[0].statistics.empty() ||
        entries[0].first_index != first_index || entries[0].length < 1) {
      return "its entry is not as it was written";
    }
    std::int64_t rows = 0;
    for (TableReader table(layout.data_file(episode), info.features); !table.next().empty();) {
      ++rows;
    }
    std::int64_t frames = 0;
    VideoDecoder video(layout.video_file(info.camera, episode));
    for (Frame frame; video.next(frame);) ++frames;
    if (rows != entries[0].length || frames != entries[0].length) {
      return fmt::format("it has {} rows and {} frames, not {}", rows, frames, entries[0].length);
    }
    for (const fs::path& path :
         {layout.data_file(episode), layout.video_file(info.camera, episode)}) {
      const std::string key = path.lexically_relative(layout.root()).generic_string();
      if (hashes.contains(key) && hashes.at(key) != hash_of_file(path)) {
        return key + " is not as it was written: its hash differs";
      }
    }
    return {};
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

/// Where what is taken out goes: a folder of its own for each repair, so that none is overwritten.
fs::path folder_for_dropped(const Layout& layout) {
  fs::path folder = layout.root() / ".dropped";
  for (int i = 2; fs::exists(folder); ++i) folder = layout.root() / fmt::format(".dropped-{}", i);
  return folder;
}

/// Moves all files below a folder that belong to an episode from `first` on; returns how many.
int drop_from(const Layout& layout, const fs::path& folder, const char* extension,
              std::int64_t first, const fs::path& dropped_to) {
  if (!fs::is_directory(folder)) return 0;
  std::vector<fs::path> kept;
  for (std::int64_t i = 0; i < first; ++i)
    kept.push_back(folder / Layout::of_episode(i, extension));
  std::ranges::sort(kept);
  std::vector<fs::path> dropped;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file() && !std::ranges::binary_search(kept, entry.path())) {
      dropped.push_back(entry.path());
    }
  }
  for (const fs::path& path : dropped) {
    const fs::path to = dropped_to / path.lexically_relative(layout.root());
    make_folder(to.parent_path());
    move(path, to);
  }
  return static_cast<int>(dropped.size());
}

}  // namespace

std::vector<std::string> repair(const fs::path& root, const std::string& task) {
  const Layout layout(root);
  if (!fs::exists(layout.info())) {
    throw UsageError(fmt::format("{}: no dataset: it has no meta/info.json", root.string()));
  }
  DatasetInfo info = read_info(layout.info());
  const DatasetSpec spec = spec_of(layout, info, task);
  std::vector<std::string> done;
  {
    const FolderLock lock(root);
    std::int64_t whole = 0;
    std::int64_t frames = 0;
    auto hashes = nlohmann::ordered_json::object();
    if (fs::exists(layout.hashes())) {
      const auto there =
          nlohmann::ordered_json::parse(read_text(layout.hashes()), nullptr, /*throws=*/false);
      if (there.is_object()) hashes = there;
    }
    while (fs::exists(layout.episode_file(whole))) {
      const std::string why = broken(layout, info, hashes, whole, frames);
      if (!why.empty()) {
        done.push_back(fmt::format("episode {} is broken: {}", whole, why));
        break;
      }
      frames += read_episode_file(layout.episode_file(whole), info, false).front().length;
      ++whole;
    }
    const fs::path to = folder_for_dropped(layout);
    int dropped = drop_from(layout, layout.episodes(), ".parquet", whole, to);
    dropped += drop_from(layout, layout.data(), ".parquet", whole, to);
    dropped += drop_from(layout, layout.videos(info.camera), ".mp4", whole, to);
    if (dropped > 0) {
      done.push_back(fmt::format("moved {} files to {}", dropped, to.string()));
    }
    if (info.episodes != whole || info.frames != frames) {
      done.push_back(fmt::format("counted {} episodes, {} frames", whole, frames));
    }
    info.episodes = whole;
    info.frames = frames;
    make_folder(layout.unfinished());
    replace_text(layout.info(), layout.unfinished() / "info.json", info_text(info));
    write_tasks_file(layout.unfinished() / "tasks.parquet", spec.task);
    sync(layout.unfinished() / "tasks.parquet");
    move(layout.unfinished() / "tasks.parquet", layout.tasks());
  }
  const std::string before = fs::exists(layout.statistics()) ? read_text(layout.statistics()) : "";
  const DatasetWriter reopened(root, spec);  // writes statistics and hashes anew
  if (read_text(layout.statistics()) != before) done.emplace_back("wrote the statistics anew");
  return done;
}

}  // namespace pacer::dataset
