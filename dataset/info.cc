// SPDX-License-Identifier: Apache-2.0
#include "dataset/info.h"

#include <fmt/format.h>

#include <functional>

#include "dataset/files.h"
#include "dataset/layout.h"

namespace pacer::dataset {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kVersion = "v3.0";
constexpr const char* kDataPath = "data/chunk-{chunk_index:03d}/file-{file_index:03d}.parquet";
constexpr const char* kVideoPath =
    "videos/{video_key}/chunk-{chunk_index:03d}/file-{file_index:03d}.mp4";

Json video_feature(const DatasetInfo& info) {
  return {{"dtype", "video"},
          {"shape", {info.image_size.height, info.image_size.width, 3}},
          {"names", {"height", "width", "channels"}},
          {"info",
           {{"video.height", info.image_size.height},
            {"video.width", info.image_size.width},
            {"video.codec", "h264"},
            {"video.pix_fmt", "yuv420p"},
            {"video.is_depth_map", false},
            {"video.fps", info.rate_hz},
            {"video.channels", 3},
            {"has_audio", false}}}};
}

/// Null where the type is none of ours, e.g. a text.
bool parse_type(const std::string& name, ValueType& type) {
  for (const ValueType each : {ValueType::kFloat32, ValueType::kFloat64, ValueType::kInt64}) {
    type = each;
    if (name == name_of(each)) return true;
  }
  return false;
}

std::vector<std::string> parse_names(const Json& names) {
  std::vector<std::string> all;
  if (!names.is_array()) return all;
  for (const Json& name : names) {
    if (name.is_string()) all.push_back(name);
  }
  return all;
}

void parse_features(const Json& features, DatasetInfo& info) {
  for (const auto& [name, feature] : features.items()) {
    const std::string type = feature.at("dtype");
    const Json& shape = feature.at("shape");
    if (type == "video" && info.camera.empty()) {
      info.camera = name;
      info.image_size = {.width = shape.at(1), .height = shape.at(0)};
    }
    Feature column{.name = name, .components = {}};
    if (!parse_type(type, column.type) || shape.size() != 1) continue;
    column.width = shape.at(0);
    if (column.width < 1 || column.width > 100'000) {
      throw std::runtime_error(fmt::format("feature '{}' is {} wide", name, column.width));
    }
    if (feature.contains("names")) column.components = parse_names(feature.at("names"));
    info.features.push_back(std::move(column));
  }
  if (info.camera.empty()) throw std::runtime_error("it has no video");
  if (info.camera.find("..") != std::string::npos || info.camera.front() == '/') {
    throw std::runtime_error("its video's name leads out of the dataset");
  }
}

double number_in(const Json& json) {  // however deep: an image's statistics are [3][1][1]
  return json.is_array() ? number_in(json.at(0)) : json.get<double>();
}

}  // namespace

DatasetInfo empty_info(const DatasetSpec& spec) {
  return {.image_size = spec.image_size,
          .rate_hz = spec.rate_hz,
          .robot_type = spec.robot_type,
          .camera = spec.camera,
          .features = spec.features()};
}

std::string info_text(const DatasetInfo& info) {
  Json features;
  features[info.camera] = video_feature(info);
  for (const Feature& feature : info.features) {
    features[feature.name] = {
        {"dtype", name_of(feature.type)},
        {"shape", {feature.width}},
        {"names", feature.components.empty() ? Json() : Json(feature.components)}};
  }
  const Json json{{"codebase_version", kVersion},
                  {"robot_type", info.robot_type},
                  {"total_episodes", info.episodes},
                  {"total_frames", info.frames},
                  {"total_tasks", 1},
                  {"chunks_size", Layout::kFilesInChunk},
                  {"data_files_size_in_mb", 100},
                  {"video_files_size_in_mb", 200},
                  {"fps", info.rate_hz},
                  {"splits", {{"train", fmt::format("0:{}", info.episodes)}}},
                  {"data_path", kDataPath},
                  {"video_path", kVideoPath},
                  {"features", features}};
  return json.dump(4);
}

DatasetInfo read_info(const std::filesystem::path& path) {
  const std::string text = read_text(path);
  try {
    const Json json = Json::parse(text);
    if (json.at("codebase_version") != kVersion) {
      throw std::runtime_error("its version is not v3.0; convert it with lerobot first");
    }
    if (json.at("data_path") != kDataPath || json.at("video_path") != kVideoPath) {
      throw std::runtime_error("its files do not lie as those of LeRobotDataset v3.0");
    }
    DatasetInfo info;
    info.rate_hz = json.at("fps");
    if (json.at("robot_type").is_string()) info.robot_type = json.at("robot_type");
    info.episodes = json.at("total_episodes");
    info.frames = json.at("total_frames");
    if (info.rate_hz < 1 || info.rate_hz > 1000 || info.episodes < 0 || info.frames < 0) {
      throw std::runtime_error("its rate or its counts cannot be");
    }
    parse_features(json.at("features"), info);
    return info;
  } catch (const Json::exception&) {
    throw std::runtime_error(fmt::format(
        "{}: not the info of a LeRobotDataset v3.0: it is cut, or lacks a value; put the "
        "file back, or record anew",
        path.string()));
  } catch (const std::exception& error) {
    throw std::runtime_error(fmt::format("{}: not the info of a dataset: {}", path.string(),
                                         std::string_view(error.what())));
  }
}

bool is_image(const DatasetInfo& info, const std::string& feature) {
  return feature == info.camera;
}

bool is_integer(const DatasetInfo& info, const std::string& feature) {
  for (const Feature& each : info.features) {
    if (each.name == feature) return each.type == ValueType::kInt64;
  }
  return false;
}

std::vector<Feature> measured_features(const DatasetInfo& info) {
  std::vector<Feature> all{{.name = info.camera, .width = 3, .components = {}}};
  all.insert(all.end(), info.features.begin(), info.features.end());
  return all;
}

Json statistics_json(const StatisticsByFeature& statistics, const DatasetInfo& info) {
  Json json = Json::object();
  for (const auto& [name, feature] : statistics) {
    const bool image = is_image(info, name);
    const bool integer = is_integer(info, name);
    const auto values = [&, &components = feature.components](auto&& of, bool whole) {
      Json list = Json::array();
      for (const ValueStatistics& value : components) {
        Json number = whole ? Json(static_cast<std::int64_t>(of(value))) : Json(of(value));
        list.push_back(image ? Json::array({Json::array({number})}) : number);
      }
      return list;
    };
    Json& into = json[name];
    into["min"] = values([](const ValueStatistics& value) { return value.min; }, integer);
    into["max"] = values([](const ValueStatistics& value) { return value.max; }, integer);
    into["mean"] = values([](const ValueStatistics& value) { return value.mean; }, false);
    into["std"] = values([](const ValueStatistics& value) { return value.deviation; }, false);
    into["count"] = Json::array({feature.count});
    for (std::size_t q = 0; q < kQuantiles.size(); ++q) {
      into[kQuantileNames[q]] =
          values([q](const ValueStatistics& value) { return value.quantiles[q]; }, false);
    }
  }
  return json;
}

StatisticsByFeature parse_statistics(const Json& json, const DatasetInfo& info) {
  StatisticsByFeature all;
  for (const Feature& feature : measured_features(info)) {
    const Json& from = json.at(feature.name);
    FeatureStatistics statistics;
    statistics.count = from.at("count").at(0);
    for (std::size_t i = 0; i < feature.width; ++i) {
      ValueStatistics& value = statistics.components.emplace_back();
      value.min = number_in(from.at("min").at(i));
      value.max = number_in(from.at("max").at(i));
      value.mean = number_in(from.at("mean").at(i));
      value.deviation = number_in(from.at("std").at(i));
      for (std::size_t q = 0; q < kQuantiles.size(); ++q) {
        value.quantiles[q] = number_in(from.at(kQuantileNames[q]).at(i));
      }
    }
    all.emplace_back(feature.name, std::move(statistics));
  }
  return all;
}

}  // namespace pacer::dataset
