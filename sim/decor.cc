// SPDX-License-Identifier: Apache-2.0
#include "sim/furniture.h"
#include "sim/furniture_parts.h"
#include "sim/print.h"

// What lies on any floor and what hangs on walls.
namespace pacer::sim::furniture {
namespace {

/// A flat picture at a height, hung on the wall behind the piece's origin.
Piece hung(const char* name, double width, double height, double bottom, const Skin& skin,
           const Skin& edge) {
  Piece piece = named(name, 0.5 * width, 0.0, bottom + height);
  const double thick = 0.02;
  piece.shape.box({0.0, 0.0, bottom + 0.5 * height}, {0.5 * width, 0.5 * thick, 0.5 * height},
                  {skin, {}, edge, edge, edge, edge});
  return piece;
}

}  // namespace

Piece carton(RoomBuilder& room, Random random) {
  const double half_x = random.uniform(0.14, 0.24);
  const double half_y = random.uniform(0.12, 0.2);
  Piece piece = named("carton", half_x + 0.03, half_y + 0.03, 0.4);
  double top = 0.0;
  const int levels = static_cast<int>(1 + random.below(3));
  for (int i = 0; i < levels; ++i) {
    const double rise = random.uniform(0.08, 0.15);
    const double smaller = 1.0 - 0.14 * i;
    const Skin side = room.one_of("carton", 5, random, [](Random r) {
      return print::carton({160, 128}, r);
    });
    piece.shape.box({0.0, 0.0, top + rise}, {smaller * half_x, smaller * half_y, rise},
                    BoxSkins::all(side), random.uniform(-0.12, 0.12));
    top += 2.0 * rise;
  }
  piece.solids.push_back({{0.0, 0.0, 0.5 * top}, {half_x, half_y, 0.5 * top}});
  return piece;
}

Piece product(RoomBuilder& room, Random random) {
  const double half = random.uniform(0.06, 0.1);
  const double rise = random.uniform(0.07, 0.14);
  Piece piece = named("product", half, half, 2.0 * rise);
  if (random.chance(0.35)) {
    piece.shape.cylinder({0.0, 0.0, 0.0}, half, half, 2.0 * rise, goods(room, random), room.metal(),
                         12);
    piece.solids.push_back({{0.0, 0.0, rise}, {half, half, rise}});
  } else {
    piece.part({0.0, 0.0, rise}, {half, half, rise}, BoxSkins::all(goods(room, random)));
  }
  return piece;
}

Piece stack_of_books(RoomBuilder& room, Random random) {
  Piece piece = named("books", 0.15, 0.12, 0.3);
  double top = 0.0;
  const int count = static_cast<int>(3 + random.below(5));
  for (int i = 0; i < count; ++i) {
    const double rise = random.uniform(0.012, 0.028);
    piece.shape.box({0.0, 0.0, top + rise}, {random.uniform(0.1, 0.14), 0.09, rise},
                    BoxSkins::all(goods(room, random)), random.uniform(-0.25, 0.25));
    top += 2.0 * rise;
  }
  piece.solids.push_back({{0.0, 0.0, 0.5 * top}, {0.14, 0.11, 0.5 * top}});
  return piece;
}

Piece painting(RoomBuilder& room, Random random) {
  const double width = random.uniform(0.7, 1.2);
  const Skin skin = room.one_of("painting", 5, random, [](Random r) {
    return print::painting({224, 176}, r);
  });
  return hung("painting", width, 0.78 * width, random.uniform(1.0, 1.15), skin, room.dark());
}

Piece poster(RoomBuilder& room, Random random) {
  const double width = random.uniform(0.55, 0.75);
  const Skin skin = room.one_of("poster", 4, random, [](Random r) {
    return print::poster({168, 232}, r);
  });
  return hung("poster", width, 1.38 * width, random.uniform(0.95, 1.1), skin, room.dark());
}

Piece whiteboard(RoomBuilder& room, Random random) {
  const Skin skin = room.one_of("whiteboard", 2, random, [](Random r) {
    return print::whiteboard({352, 208}, r);
  });
  return hung("whiteboard", random.uniform(1.2, 1.5), 0.85, 0.95, skin, room.metal());
}

Piece pegboard(RoomBuilder& room, Random random) {
  const Skin skin = room.one_of("pegboard", 2, random, [&](Random r) {
    return print::pegboard({400, 208}, room.palette.accent, r);
  });
  return hung("pegboard", random.uniform(1.3, 1.8), 0.85, 0.98, skin, room.wood());
}

Piece window(RoomBuilder& room, Random random) {
  const Skin skin = room.one_of("window", 2, random, [](Random r) {
    return print::window({256, 224}, r);
  });
  return hung("window", random.uniform(1.2, 1.6), 1.25, 0.95, skin, room.second_wood());
}

Piece door(RoomBuilder& room, Random random) {
  (void)random;
  const Skin skin = room.skin("door", [&](Random r) {
    return print::door({144, 304}, room.palette.second_wood, r);
  });
  return hung("door", 0.95, 2.05, 0.0, skin, room.wood());
}

}  // namespace pacer::sim::furniture
