// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/transactions.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/check.h"

namespace pacer::affordance {

void TransactionConfig::validate() const {
  require(wanted >= 1 && wanted <= 20'000'000, "wanted: must lie in [1, 20000000]");
  require(most_frames >= 1 && most_frames <= 10'000'000, "most_frames: must lie in [1, 10000000]");
  require(common_item_percent > 0.0 && common_item_percent <= 100.0,
          "common_item_percent: must lie in (0, 100]");
  require(picture_change >= 0.0, "picture_change: must not be negative");
  require(action_change >= 0.0, "action_change: must not be negative");
  require(stretch.count() > 0.0, "stretch_s: must be above 0");
  const std::optional<Seconds> given = given_lag();
  require(!given || (given->count() >= 0.0 && *given <= kLongestLag),
          "lag_s: must be 'found' or lie in [0, 0.8]");
}

std::optional<Seconds> TransactionConfig::given_lag() const {
  if (lag == "found") return std::nullopt;
  double seconds = 0.0;
  const auto [end, error] = std::from_chars(lag.data(), lag.data() + lag.size(), seconds);
  const bool whole = error == std::errc{} && end == lag.data() + lag.size();
  return Seconds{whole ? seconds : -1.0};  // what is no number is out of range
}

bool ChangeDetector::counts(const Frame& frame, const Command& command) {
  std::array<float, kColumns * kRows> blocks{};
  const int width = frame.size.width;
  const int height = frame.size.height;
  for (int row = 0; row < kRows; ++row) {
    const int top = row * height / kRows;
    const int bottom = (row + 1) * height / kRows;
    for (int column = 0; column < kColumns; ++column) {
      const int left = column * width / kColumns;
      const int right = (column + 1) * width / kColumns;
      std::uint32_t sum = 0;
      for (int y = top; y < bottom; ++y) {
        const std::uint8_t* pixel =
            frame.rgb.data() + 3 * (static_cast<std::ptrdiff_t>(y) * width + left);
        for (int i = 0; i < 3 * (right - left); ++i) sum += pixel[i];
      }
      const int samples = std::max(1, 3 * (bottom - top) * (right - left));
      blocks[static_cast<std::size_t>(row * kColumns + column)] =
          static_cast<float>(sum) / static_cast<float>(samples);
    }
  }
  double difference = 0.0;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    difference += static_cast<double>(std::abs(blocks[i] - blocks_[i]));
  }
  difference /= static_cast<double>(blocks.size());
  const double moved = std::max(std::abs(command.steering - command_.steering),
                                std::abs(command.throttle - command_.throttle));
  if (!first_ && difference <= config_.picture_change && moved <= config_.action_change) {
    return false;
  }
  first_ = false;
  blocks_ = blocks;
  command_ = command;
  return true;
}

void FeatureLog::add(const Features& features, const Words& labels, const Command& command,
                     ActionType type, std::uint32_t stretch) {
  const auto append = [](auto& to, const auto& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  append(poses.x, features.poses.x);
  append(poses.y, features.poses.y);
  append(poses.size, features.poses.size);
  append(poses.angle, features.poses.angle);
  append(words.descriptor, labels.descriptor);
  append(words.scale, labels.scale);
  append(words.orientation, labels.orientation);
  offsets.push_back(static_cast<std::uint32_t>(poses.count()));
  commands.push_back(command);
  types.push_back(type);
  stretches.push_back(stretch);
}

namespace {

/// `database` without the items that more than `percent` of its transactions hold.
TransactionDatabase without_common_items(const TransactionDatabase& database, double percent) {
  std::vector<std::size_t> held(static_cast<std::size_t>(database.item_count));
  for (const Item item : database.items) ++held[item];
  const double most = percent / 100.0 * static_cast<double>(database.size());
  TransactionDatabase rest;
  rest.item_count = database.item_count;
  rest.type_count = database.type_count;
  std::vector<Item> items;
  for (std::size_t t = 0; t < database.size(); ++t) {
    items.clear();
    for (const Item item : database.transaction(t)) {
      if (static_cast<double>(held[item]) <= most) items.push_back(item);
    }
    rest.add(items, database.types[t], database.stretches[t]);
  }
  return rest;
}

}  // namespace

TransactionDatabase build_transactions(std::span<const FeatureLog> episodes,
                                       const ItemLayout& layout, const GridConfig& grid,
                                       const TransactionConfig& config, int type_count) {
  TransactionDatabase database;
  database.item_count = layout.count();
  database.type_count = type_count;
  std::size_t features = 0;
  for (const FeatureLog& episode : episodes) features += episode.poses.count();
  if (features == 0) return database;
  const double share =
      std::min(1.0, static_cast<double>(config.wanted) / static_cast<double>(features));

  constexpr std::size_t kItemsOfOneNeighbour = 3;
  Configuration configuration;
  std::vector<Item> items;
  std::uint32_t first_stretch = 0;
  double due = 1.0;  // a frame is taken each time this reaches 1: the first, then evenly
  for (const FeatureLog& episode : episodes) {
    std::uint32_t stretches = 0;
    for (std::size_t f = 0; f < episode.frame_count(); ++f) {
      stretches = std::max(stretches, episode.stretches[f] + 1);
      const bool taken = due >= 1.0;
      due += share - (taken ? 1.0 : 0.0);
      if (!taken) continue;
      const LabelledFeatures frame = episode.frame(f);
      for (std::size_t centre = 0; centre < frame.count(); ++centre) {
        build_configuration(frame, layout, grid, centre, configuration);
        items.clear();
        configuration.for_each([&](Item item) { items.push_back(item); });
        if (items.size() <= kItemsOfOneNeighbour) continue;
        database.add(items, episode.types[f], first_stretch + episode.stretches[f]);
      }
    }
    first_stretch += stretches;
  }
  return without_common_items(database, config.common_item_percent);
}

}  // namespace pacer::affordance
