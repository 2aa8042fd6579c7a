// SPDX-License-Identifier: Apache-2.0
#include "sim/furniture_parts.h"

#include "sim/print.h"

namespace pacer::sim::furniture {

Piece named(const char* name, double half_x, double half_y, double height) {
  Piece piece;
  piece.name = name;
  piece.half = {half_x, half_y};
  piece.height = height;
  return piece;
}

void legs(Piece& piece, double half_x, double half_y, double height, double thick,
          const Skin& skin) {
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      piece.part({x * (half_x - thick), y * (half_y - thick), 0.5 * height},
                 {thick, thick, 0.5 * height}, BoxSkins::all(skin));
    }
  }
}

Skin goods(RoomBuilder& room, Random& random) {
  return room.one_of("product", 7, random, [](Random r) { return print::product({104, 112}, r); });
}

Skin board(RoomBuilder& room, Random& random) {
  return room.one_of("carton", 5, random, [](Random r) { return print::carton({160, 128}, r); });
}

Skin paint(RoomBuilder& room, int variant) {
  return room.skin(
      "paint " + std::to_string(variant),
      [&](Random r) {
        const texture::Colour tone =
            variant == 0 ? room.palette.accent : room.palette.second_fabric;
        return texture::metal({160, 160}, tone, r);
      },
      0.6);
}

}  // namespace pacer::sim::furniture
