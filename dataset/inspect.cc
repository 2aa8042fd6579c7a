// SPDX-License-Identifier: Apache-2.0
#include "dataset/inspect.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/check.h"
#include "core/policy.h"
#include "dataset/episode_file.h"
#include "dataset/files.h"
#include "dataset/layout.h"
#include "dataset/reader.h"
#include "dataset/recorder.h"
#include "dataset/table.h"
#include "dataset/video.h"
#include "dataset/writer.h"

namespace pacer::dataset {
namespace {

namespace fs = std::filesystem;

constexpr double kTimestampSlack = 1e-4;  // s; the format's loader accepts no more
constexpr double kRateSlack = 0.1;        // of the frame period: slower than this is worth knowing

std::string place_in(const fs::path& root, const fs::path& path) {
  return path.lexically_relative(root).generic_string();
}

/// `what` without the path that it begins with, where that ends in `where`: a finding says where.
std::string without_place(const std::string& what, const std::string& where) {
  const std::size_t end = what.find(where + ": ");
  const std::size_t colon = what.find(": ");
  return end == std::string::npos || end > colon ? what : what.substr(end + where.size() + 2);
}

/// Runs `work`; whatever it throws is a finding.
template <class Work>
void finding_errors(std::vector<Finding>& findings, const std::string& where, Work&& work) {
  try {
    work();
  } catch (const std::exception& error) {
    findings.push_back({.where = where, .what = without_place(error.what(), where)});
  }
}

void count_driver(DatasetSummary& summary, double driver) {
  if (driver == static_cast<double>(Driver::kTeacher)) ++summary.driven_by["teacher"];
  if (driver == static_cast<double>(Driver::kPolicy)) ++summary.driven_by["policy"];
  if (driver == static_cast<double>(Driver::kPerson)) ++summary.driven_by["person"];
}

/// Reads an episode's rows: their numbers, their times, who drove.
void check_rows(const Dataset& dataset, std::size_t episode, Inspection& into) {
  const EpisodeEntry& entry = dataset.episodes()[episode];
  const auto& all = dataset.info().features;
  const auto has = [&](std::string_view name) {
    return std::ranges::find(all, name, &Feature::name) != all.end();
  };
  std::vector<std::string> columns{"index", "timestamp", "frame_index"};
  if (has(kCaptureTime)) columns.emplace_back(kCaptureTime);
  if (has(kDriver)) columns.emplace_back(kDriver);
  EpisodeReader reader(dataset, episode, columns, EpisodeReader::Frames::kLeave);
  const std::string where = place_in(dataset.root(), dataset.data_file(episode));
  const double rate = dataset.info().rate_hz;
  bool times_fit = true;
  bool indices_fit = true;
  double captured = 0.0;
  auto expected = static_cast<double>(entry.first_index);
  while (const RecordedStep* step = reader.next()) {
    indices_fit = indices_fit && step->values[0] == expected;
    times_fit = times_fit && std::abs(step->values[1] - step->values[2] / rate) <= kTimestampSlack;
    if (has(kCaptureTime)) captured = step->values[3];
    if (has(kDriver)) count_driver(into.summary, step->values.back());
    expected += 1.0;
  }
  if (!indices_fit) into.findings.push_back({where, "its indices are not contiguous", true});
  if (!times_fit)
    into.findings.push_back({where, "its timestamps are not frame_index / fps", true});
  const double nominal = static_cast<double>(entry.length - 1) / rate;
  if (has(kCaptureTime) && std::abs(captured - nominal) > kRateSlack * nominal) {
    into.findings.push_back(
        {where, fmt::format("was captured in {:.1f} s, not {:.1f} s", captured, nominal), false});
  }
}

void check_video(const Dataset& dataset, std::size_t episode, Depth depth, Inspection& into) {
  const EpisodeEntry& entry = dataset.episodes()[episode];
  const fs::path path = dataset.video_file(episode);
  const std::string where = place_in(dataset.root(), path);
  VideoDecoder video(path);
  const ImageSize size = video.size();
  if (size != dataset.info().image_size) {
    into.findings.push_back(
        {where, fmt::format("its pictures are {} x {}", size.width, size.height), true});
  }
  const double rate = video.rate_hz();
  if (rate > 0.0 && std::abs(rate - dataset.info().rate_hz) > 0.01 * rate) {
    into.findings.push_back(
        {where,
         fmt::format("has {:.4g} pictures a second, its dataset {}", rate, dataset.info().rate_hz),
         true});
  }
  if (depth != Depth::kAll) return;
  if (entry.video_from > 0.0) video.seek(Seconds{entry.video_from});
  const double end = entry.video_to - 0.5 / dataset.info().rate_hz;
  std::int64_t frames = 0;
  for (Frame frame; video.next(frame) && frame.time.count() < end;) {
    const double shown = entry.video_from + static_cast<double>(frames) / dataset.info().rate_hz;
    if (std::abs(frame.time.count() - shown) > kTimestampSlack) {
      into.findings.push_back(
          {where, fmt::format("frame {} is not shown at its time", frames), true});
      return;
    }
    ++frames;
  }
  if (frames != entry.length) {
    into.findings.push_back(
        {where, fmt::format("has {} frames, its episode {}", frames, entry.length), true});
  }
}

/// Every column of the episodes' tables can be read.
void check_episode_tables(const Dataset& dataset, Inspection& into) {
  const Layout layout(dataset.root());
  if (!fs::is_directory(layout.episodes())) return;
  for (const auto& entry : fs::recursive_directory_iterator(layout.episodes())) {
    if (!entry.is_regular_file()) continue;
    finding_errors(into.findings, place_in(layout.root(), entry.path()), [&] {
      (void)read_episode_file(entry.path(), dataset.info(), /*with_statistics=*/true);
    });
  }
}

void check_statistics(const Dataset& dataset, Inspection& into) {
  if (dataset.episodes().empty()) return;
  const Layout layout(dataset.root());
  const std::string where = place_in(layout.root(), layout.statistics());
  finding_errors(into.findings, where, [&] {
    const auto json = nlohmann::ordered_json::parse(read_text(layout.statistics()));
    for (const auto& [name, statistics] : parse_statistics(json, dataset.info())) {
      if (!is_image(dataset.info(), name) && statistics.count != dataset.info().frames) {
        into.findings.push_back({where,
                                 fmt::format("'{}' counts {} frames, not {}", name,
                                             statistics.count, dataset.info().frames),
                                 true});
      }
    }
  });
}

void check_hashes(const Dataset& dataset, Inspection& into) {
  const Layout layout(dataset.root());
  const bool hashed = fs::exists(layout.hashes());
  const bool described = fs::exists(layout.scenario()) && fs::file_size(layout.scenario()) > 0;
  if (!hashed && !described) return;  // another program's
  if (!hashed || !described) {
    const fs::path& lost = hashed ? layout.scenario() : layout.hashes();
    into.findings.push_back({.where = place_in(layout.root(), lost),
                             .what = hashed ? "is lost, and cannot be made up; put it back, or "
                                              "record anew"
                                            : "is missing",
                             .lost = hashed});
    if (!hashed) return;
  }
  finding_errors(into.findings, place_in(layout.root(), layout.hashes()), [&] {
    const auto hashes = nlohmann::ordered_json::parse(read_text(layout.hashes()));
    for (std::size_t i = 0; i < dataset.episodes().size(); ++i) {
      for (const fs::path& path : {dataset.data_file(i), dataset.video_file(i)}) {
        const std::string where = place_in(layout.root(), path);
        if (!fs::exists(path)) continue;  // found missing already
        if (!hashes.contains(where)) {
          into.findings.push_back({where, "has no hash", true});
        } else if (hashes.at(where) != hash_of_file(path)) {
          into.findings.push_back({where, "is not as it was written: its hash differs", true});
        }
      }
    }
  });
}

/// What lies in the loader's folders and belongs to no episode would be loaded all the same.
void check_strays(const Dataset& dataset, Inspection& into) {
  const Layout layout(dataset.root());
  std::set<fs::path> known;
  for (std::size_t i = 0; i < dataset.episodes().size(); ++i) {
    known.insert(dataset.data_file(i));
    known.insert(dataset.video_file(i));
  }
  for (const fs::path& folder : {layout.data(), layout.videos(dataset.info().camera)}) {
    if (!fs::is_directory(folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      if (entry.is_regular_file() && !known.contains(entry.path())) {
        into.findings.push_back(
            {place_in(layout.root(), entry.path()), "belongs to no episode", true});
      }
    }
  }
}

void summarise(const Dataset& dataset, DatasetSummary& summary) {
  const DatasetInfo& info = dataset.info();
  summary.image_size = info.image_size;
  summary.rate_hz = info.rate_hz;
  summary.robot_type = info.robot_type;
  summary.episodes = static_cast<std::int64_t>(dataset.episodes().size());
  for (const Feature& feature : info.features) summary.columns.push_back(feature.name);
  for (const EpisodeEntry& entry : dataset.episodes()) {
    summary.frames += entry.length;
    summary.lengths.push_back(entry.length);
  }
  summary.seconds = static_cast<double>(summary.frames) / info.rate_hz;
  for (const auto& entry : fs::recursive_directory_iterator(dataset.root())) {
    if (entry.is_regular_file()) summary.bytes += entry.file_size();
  }
  const fs::path unfinished = Layout(dataset.root()).unfinished();
  if (fs::is_directory(unfinished)) {
    summary.unfinished = std::distance(fs::directory_iterator(unfinished), {});
  }
}

}  // namespace

bool Inspection::whole() const {
  return std::ranges::none_of(findings, [](const Finding& finding) { return finding.harms; });
}

Inspection inspect(const fs::path& root, Depth depth) {
  const Layout layout(root);
  if (!fs::exists(layout.info())) {
    throw UsageError(fmt::format("{}: no dataset: it has no meta/info.json", root.string()));
  }
  Inspection inspection;
  auto& findings = inspection.findings;
  finding_errors(findings, "meta/info.json", [&] { (void)read_info(layout.info()); });
  if (!findings.empty()) {
    findings.back().lost = true;
    return inspection;
  }
  finding_errors(findings, "meta", [&] {
    const Dataset dataset(root);
    summarise(dataset, inspection.summary);
    finding_errors(findings, "meta/tasks.parquet",
                   [&] { inspection.summary.task = dataset.task(); });
    if (dataset.info().episodes != inspection.summary.episodes ||
        dataset.info().frames != inspection.summary.frames) {
      findings.push_back({"meta/info.json",
                          fmt::format("speaks of {} episodes and {} frames, {} and {} are there",
                                      dataset.info().episodes, dataset.info().frames,
                                      inspection.summary.episodes, inspection.summary.frames),
                          true});
    }
    std::int64_t next = 0;
    for (std::size_t i = 0; i < dataset.episodes().size(); ++i) {
      const EpisodeEntry& entry = dataset.episodes()[i];
      const std::string data = place_in(root, dataset.data_file(i));
      if (entry.first_index != next || entry.length < 1) {
        findings.push_back(
            {data, fmt::format("episode {} does not follow the one before", i), true});
      }
      next = entry.first_index + entry.length;
      finding_errors(findings, data, [&] { check_rows(dataset, i, inspection); });
      const std::string video = place_in(root, dataset.video_file(i));
      if (!fs::exists(dataset.video_file(i))) {
        findings.push_back({video, "is missing", true});
      } else if (depth != Depth::kTables) {
        finding_errors(findings, video, [&] { check_video(dataset, i, depth, inspection); });
      }
    }
    check_episode_tables(dataset, inspection);
    check_statistics(dataset, inspection);
    check_strays(dataset, inspection);
    if (depth != Depth::kTables) check_hashes(dataset, inspection);
  });
  return inspection;
}

}  // namespace pacer::dataset
