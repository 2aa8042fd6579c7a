// SPDX-License-Identifier: Apache-2.0
#include "sim/room.h"

#include <algorithm>
#include <array>

#include "core/check.h"
#include "sim/room_builder.h"

namespace pacer::sim {
namespace {

struct Kind {
  const char* name;
  void (*furnish)(RoomBuilder&);
};

constexpr std::array<Kind, 3> kKinds = {{
    {"living", furnish_living},
    {"office", furnish_office},
    {"workshop", furnish_workshop},
}};

}  // namespace

const std::vector<std::string>& room_kinds() {
  static const std::vector<std::string> kinds = [] {
    std::vector<std::string> names;
    for (const Kind& kind : kKinds) names.emplace_back(kind.name);
    return names;
  }();
  return kinds;
}

void require_room_kind(const std::string& field, const std::string& kind) {
  std::string names;
  for (const std::string& known : room_kinds()) {
    if (known == kind) return;
    names += (names.empty() ? "" : ", ") + known;
  }
  throw std::invalid_argument(field + ": there is no room \"" + kind + "\"; there are " + names);
}

void RoomConfig::validate() const {
  require(!kinds.empty(), "kinds: names no room");
  for (const std::string& kind : kinds) require_room_kind("kinds", kind);
  length.validate("length_m", 6.5, 12.0);
  width.validate("width_m", 5.8, 12.0);
  clutter.validate("clutter", 0.0, 1.0);
  light.validate("light", 0.2, 2.0);
  warmth.validate("warmth", -1.0, 1.0);
}

RoomPlan build_room(mjSpec& spec, const RoomConfig& config, const Random& random) {
  config.validate();
  Random draw = random.fork("kind");
  const std::string& name = config.kinds[draw.below(config.kinds.size())];
  const auto* const kind =
      std::ranges::find_if(kKinds, [&name](const Kind& one) { return name == one.name; });
  RoomBuilder room(spec, config, name, random.fork(name));
  kind->furnish(room);
  return room.finish();
}

}  // namespace pacer::sim
