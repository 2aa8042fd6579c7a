// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/frame.h"
#include "core/signals.h"

namespace pacer::dataset {

enum class ValueType { kFloat32, kFloat64, kInt64 };

/// `type` as the format spells it, e.g. "float32".
[[nodiscard]] std::string_view name_of(ValueType type) noexcept;

/// A column of numbers: one value a frame, or a list of `width` of them.
struct Feature {
  std::string name;
  ValueType type = ValueType::kFloat32;
  std::size_t width = 1;
  std::vector<std::string> components;  ///< their names; may be empty
  friend bool operator==(const Feature&, const Feature&) = default;
};

/// Values in one row of `features`: the sum of their widths.
[[nodiscard]] std::size_t row_width(const std::vector<Feature>& features) noexcept;

/// Where the values of feature `name` start in a row.
/// Throws std::out_of_range, naming it, when there is none.
[[nodiscard]] std::size_t row_offset(const std::vector<Feature>& features, std::string_view name);

/// The feature of ground truth, which no learner may see: `privileged.*`.
[[nodiscard]] bool is_privileged(std::string_view feature) noexcept;

inline constexpr std::string_view kState = "observation.state";  ///< the action of the frame before
inline constexpr std::string_view kAction = "action";            ///< what was sent, after limits
inline constexpr std::string_view kWanted = "wanted";            ///< what the driver asked for
inline constexpr std::string_view kDriver = "driver";            ///< the number of a pacer::Driver
inline constexpr std::string_view kPulses = "pulses";            ///< microseconds
inline constexpr std::string_view kCaptureTime = "capture_time";  ///< s since the first frame

/// What all episodes of a dataset have in common. A dataset is never continued with another.
struct DatasetSpec {
  ImageSize image_size{.width = 320, .height = 240};
  int rate_hz = 25;
  std::string camera = "observation.images.front";  ///< the video's feature name
  std::string robot_type = "pacer-rc-car";
  std::string task = "follow the lead vehicle";  ///< in words, for policies that read
  std::vector<SignalColumn> signals;             ///< the car's
  std::string scenario;                          ///< the whole resolved scenario, YAML

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  /// The columns of the data files, in their order.
  [[nodiscard]] std::vector<Feature> features() const;
};

}  // namespace pacer::dataset
