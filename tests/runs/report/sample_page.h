// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace pacer::report::testing {

/// How many charts and videos the sample page holds.
inline constexpr int kSampleCharts = 9;
inline constexpr int kSampleVideos = 2;

/// A page with one of every element, filled with generated data and hostile names. Videos are made
/// in `scratch`.
[[nodiscard]] std::string sample_page(const std::filesystem::path& scratch);

}  // namespace pacer::report::testing
