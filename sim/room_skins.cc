// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "sim/room_builder.h"

// What a room's things are covered with.
namespace pacer::sim {

Skin RoomBuilder::skin(const std::string& key, const std::function<cv::Mat(Random)>& make,
                       double metres) {
  const auto found = skins_.find(key);
  if (found != skins_.end()) return found->second;
  const Skin made = atlas_.add(make(random_.fork("skin").fork(key)), metres);
  skins_.emplace(key, made);
  return made;
}

Skin RoomBuilder::wood() {
  return skin(
      "wood",
      [&](Random r) {
        return texture::wood({256, 192}, palette.wood, r);
      },
      0.8);
}
Skin RoomBuilder::second_wood() {
  return skin(
      "second wood",
      [&](Random r) {
        return texture::wood({256, 192}, palette.second_wood, r);
      },
      0.8);
}
Skin RoomBuilder::fabric() {
  return skin(
      "fabric",
      [&](Random r) {
        return texture::fabric({192, 192}, palette.fabric, palette.accent, r);
      },
      0.5);
}
Skin RoomBuilder::second_fabric() {
  return skin(
      "second fabric",
      [&](Random r) {
        return texture::fabric({192, 192}, palette.second_fabric, palette.fabric, r);
      },
      0.4);
}
Skin RoomBuilder::metal() {
  return skin(
      "metal",
      [&](Random r) {
        return texture::metal({160, 160}, palette.metal, r);
      },
      0.5);
}
Skin RoomBuilder::dark() {
  return skin(
      "dark",
      [](Random r) {
        return texture::plain({64, 64}, {34, 33, 36}, 5.0, r);
      },
      0.4);
}
Skin RoomBuilder::one_of(const std::string& key, int count, Random& random,
                         const std::function<cv::Mat(Random)>& make) {
  return skin(key + " " + std::to_string(random.below(static_cast<std::uint64_t>(count))), make);
}

}  // namespace pacer::sim
