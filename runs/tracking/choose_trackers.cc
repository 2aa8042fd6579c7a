// SPDX-License-Identifier: Apache-2.0
#include "runs/tracking/choose_trackers.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

#include "core/check.h"

namespace pacer {

using tracking::TrackerKind;

namespace {

/// Whether two names differ in no more than capitals.
bool same_letters(const std::string& one, const std::string& other) {
  return std::ranges::equal(one, other, [](unsigned char a, unsigned char b) {
    return std::tolower(a) == std::tolower(b);
  });
}

}  // namespace

std::vector<TrackerKind> choose_trackers(const std::vector<std::string>& names,
                                         const std::vector<TrackerKind>& known) {
  check(!known.empty(), "there is a tracker to choose");
  if (names.empty()) return {known.front()};
  if (std::ranges::find(names, "all") != names.end()) {
    if (names.size() > 1) throw UsageError("all: names every tracker, so no other beside it");
    return known;
  }
  std::vector<TrackerKind> chosen;
  for (const std::string& name : names) {
    const auto found = std::ranges::find_if(
        known, [&](const TrackerKind& kind) { return same_letters(kind.name, name); });
    if (found == known.end()) {
      std::vector<std::string> there;
      for (const TrackerKind& kind : known) there.push_back(kind.name);
      throw UsageError(fmt::format("{}: no such tracker; there are {}, or all of them with all",
                                   name, fmt::join(there, ", ")));
    }
    if (std::ranges::find(chosen, found->name, &TrackerKind::name) != chosen.end()) {
      throw UsageError(found->name + ": is named twice");
    }
    chosen.push_back(*found);
  }
  return chosen;
}

}  // namespace pacer
