// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "dataset/feature.h"
#include "dataset/statistics.h"

namespace pacer::dataset {

/// What meta/info.json says.
struct DatasetInfo {
  ImageSize image_size;
  int rate_hz = 0;
  std::string robot_type;
  std::string camera;             ///< the video's feature name; the first one's, if there are more
  std::vector<Feature> features;  ///< the columns of numbers, in their order
  std::int64_t episodes = 0;
  std::int64_t frames = 0;
  friend bool operator==(const DatasetInfo&, const DatasetInfo&) = default;
};

/// The info of a dataset of `spec` that is still empty.
[[nodiscard]] DatasetInfo empty_info(const DatasetSpec& spec);

/// The text of meta/info.json.
[[nodiscard]] std::string info_text(const DatasetInfo& info);

/// Reads meta/info.json, of any writer. The file is not trusted: throws std::runtime_error that
/// names it when it is not of LeRobotDataset v3.0 with a video.
[[nodiscard]] DatasetInfo read_info(const std::filesystem::path& path);

/// Whether the statistics of a feature are shaped [3][1][1], whether its extremes are integers.
[[nodiscard]] bool is_image(const DatasetInfo& info, const std::string& feature);
[[nodiscard]] bool is_integer(const DatasetInfo& info, const std::string& feature);

/// The features that have statistics, in their order: the video, then the columns of numbers.
[[nodiscard]] std::vector<Feature> measured_features(const DatasetInfo& info);

/// Statistics as JSON, as in meta/stats.json.
[[nodiscard]] nlohmann::ordered_json statistics_json(const StatisticsByFeature& statistics,
                                                     const DatasetInfo& info);

/// The way back. Throws std::runtime_error unless every feature has all of its statistics.
[[nodiscard]] StatisticsByFeature parse_statistics(const nlohmann::ordered_json& json,
                                                   const DatasetInfo& info);

}  // namespace pacer::dataset
