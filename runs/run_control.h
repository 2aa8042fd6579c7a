// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <stop_token>
#include <string_view>

namespace pacer {

/// How whoever started a run watches it and ends it.
struct RunControl {
  int jobs = 2;  ///< worker processes; what is written does not depend on it
  /// Told about ten times a second how many of `total` units of `what` are done.
  std::function<void(std::uint64_t done, std::uint64_t total, std::string_view what)> progress =
      [](std::uint64_t, std::uint64_t, std::string_view) {};
  std::stop_token stop;
};

}  // namespace pacer
