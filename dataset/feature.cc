// SPDX-License-Identifier: Apache-2.0
#include "dataset/feature.h"

#include <fmt/format.h>

#include <set>
#include <stdexcept>

#include "core/check.h"

namespace pacer::dataset {
namespace {

/// A name that is also a folder's and a column's: nothing that leads out of either.
bool is_plain_name(std::string_view name) {
  return !name.empty() && name.size() <= 100 && name.front() != '.' &&
         name.find_first_not_of(
             "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._-") ==
             std::string_view::npos;
}

}  // namespace

std::string_view name_of(ValueType type) noexcept {
  switch (type) {
    case ValueType::kFloat32:
      return "float32";
    case ValueType::kFloat64:
      return "float64";
    case ValueType::kInt64:
      break;
  }
  return "int64";
}

std::size_t row_width(const std::vector<Feature>& features) noexcept {
  std::size_t width = 0;
  for (const Feature& feature : features) width += feature.width;
  return width;
}

std::size_t row_offset(const std::vector<Feature>& features, std::string_view name) {
  std::size_t offset = 0;
  for (const Feature& feature : features) {
    if (feature.name == name) return offset;
    offset += feature.width;
  }
  throw std::out_of_range(fmt::format("the dataset has no column '{}'", name));
}

bool is_privileged(std::string_view feature) noexcept { return feature.starts_with("privileged."); }

void DatasetSpec::validate() const {
  require(image_size.width >= 16 && image_size.width <= 8192 && image_size.width % 2 == 0 &&
              image_size.height >= 16 && image_size.height <= 8192 && image_size.height % 2 == 0,
          "image_size: both sides must be even and lie in [16, 8192]");
  require(rate_hz >= 1 && rate_hz <= 1000, "rate_hz: must lie in [1, 1000]");
  require(is_plain_name(camera), "camera: must be of letters, digits, '.', '_' and '-'");
  require(!task.empty(), "task: say in words what the driver does");
  std::set<std::string> names{camera};
  for (const Feature& feature : features()) {
    require(is_plain_name(feature.name), "signals: the name '" + feature.name +
                                             "' must be of letters, digits, '.', '_' and '-'");
    require(names.insert(feature.name).second, "signals: '" + feature.name + "' is there twice");
    require(feature.width >= 1 && feature.width <= 1000,
            "signals: '" + feature.name + "' must have 1 to 1000 components");
  }
}

std::vector<Feature> DatasetSpec::features() const {
  const std::vector<std::string> sticks{"steering", "throttle"};
  std::vector<Feature> all{
      {std::string(kState), ValueType::kFloat32, 2, sticks},
      {std::string(kAction), ValueType::kFloat32, 2, sticks},
      {std::string(kWanted), ValueType::kFloat32, 2, sticks},
      {std::string(kDriver), ValueType::kInt64, 1, {}},
      {std::string(kPulses), ValueType::kFloat32, 2, sticks},
      {std::string(kCaptureTime), ValueType::kFloat64, 1, {}},
  };
  for (const SignalColumn& signal : signals) {
    all.push_back({signal.name, ValueType::kFloat32, signal.components.size(), signal.components});
  }
  all.push_back({"timestamp", ValueType::kFloat32, 1, {}});
  for (const char* name : {"frame_index", "episode_index", "index", "task_index"}) {
    all.push_back({name, ValueType::kInt64, 1, {}});
  }
  return all;
}

}  // namespace pacer::dataset
