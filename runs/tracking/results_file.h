// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/box.h"
#include "learning/tracking/tracker.h"

namespace pacer {

/// Results in OTB's form: a line a picture, `x,y,width,height` in pixels, the top-left one being
/// 1,1; `NaN,NaN,NaN,NaN` for each of the `first` pictures before the tracker started. Eight
/// digits: a thousandth of a pixel, however large the picture.
[[nodiscard]] std::string results_text(std::size_t first, std::span<const tracking::Track> tracks);

/// What results_text() (or OTB) wrote, with commas, tabs or blanks between numbers; none for a line
/// that holds a NaN. Throws std::runtime_error naming the file, the line and what is wrong.
[[nodiscard]] std::vector<std::optional<Box>> read_results(const std::filesystem::path& file);

}  // namespace pacer
