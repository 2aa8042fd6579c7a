// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "sim/furniture.h"
#include "sim/furniture_parts.h"
#include "sim/print.h"

// What stands in living rooms.
namespace pacer::sim::furniture {
namespace {

Skin spines(RoomBuilder& room, Random& random) {
  const Skin row = room.one_of("books", 3, random, [](Random r) {
    return print::books({640, 104}, r);
  });
  const auto left = static_cast<float>(random.uniform(0.0, 0.45));
  return row.part(left, 0.0F, left + 0.5F, 1.0F);
}

}  // namespace

Piece sofa(RoomBuilder& room, Random random) {
  const double width = random.uniform(1.7, 2.2);
  const double depth = 0.86;
  Piece piece = named("sofa", 0.5 * width, 0.5 * depth, 0.85);
  const Skin cover = room.fabric();
  const Skin cushion = room.second_fabric();
  const double arm = 0.17;
  piece.part({0.0, -0.5 * depth + 0.13, 0.44}, {0.5 * width, 0.13, 0.38}, BoxSkins::six(cover));
  for (const double side : {-1.0, 1.0}) {
    piece.part({side * 0.5 * (width - arm), 0.0, 0.33}, {0.5 * arm, 0.5 * depth, 0.27},
               BoxSkins::six(cover));
  }
  piece.part({0.0, 0.06, 0.17}, {0.5 * width - arm, 0.5 * depth - 0.08, 0.11},
             BoxSkins::all(cover));
  const int seats = 3;
  const double seat = (width - 2.0 * arm) / seats;
  for (int i = 0; i < seats; ++i) {
    const double x = -0.5 * width + arm + (i + 0.5) * seat;
    piece.shape.box({x, 0.08, 0.35}, {0.48 * seat, 0.35, 0.07}, BoxSkins::all(cover));
    if (random.chance(0.7)) {
      piece.shape.box({x + random.uniform(-0.06, 0.06), -0.09, 0.6}, {0.22, 0.07, 0.2},
                      BoxSkins::all(cushion), random.uniform(-0.3, 0.3));
    }
  }
  for (const double side : {-1.0, 1.0}) {
    piece.shape.box({side * (0.5 * width - 0.1), 0.5 * depth - 0.06, 0.03}, {0.03, 0.03, 0.03},
                    BoxSkins::all(room.wood()));
  }
  return piece;
}

Piece armchair(RoomBuilder& room, Random random) {
  const double half = random.uniform(0.37, 0.43);
  Piece piece = named("armchair", half, half, 0.9);
  const Skin cover = room.second_fabric();
  piece.part({0.0, -half + 0.1, 0.5}, {half, 0.1, 0.42}, BoxSkins::six(cover));
  for (const double side : {-1.0, 1.0}) {
    piece.part({side * (half - 0.07), 0.02, 0.36}, {0.07, half - 0.02, 0.24}, BoxSkins::six(cover));
  }
  piece.part({0.0, 0.05, 0.26}, {half - 0.14, half - 0.08, 0.16}, BoxSkins::all(cover));
  piece.shape.box({0.0, -0.06, 0.55}, {0.2, 0.06, 0.17}, BoxSkins::all(room.fabric()));
  legs(piece, half, half, 0.12, 0.025, room.wood());
  return piece;
}

Piece bookcase(RoomBuilder& room, Random random) {
  const double width = random.uniform(0.8, 1.3);
  const double depth = 0.3;
  const int shelves = static_cast<int>(4 + random.below(3));
  const double pitch = 0.34;
  const double height = shelves * pitch + 0.08;
  Piece piece = named("bookcase", 0.5 * width, 0.5 * depth, height);
  const Skin wood = random.chance(0.5) ? room.wood() : room.second_wood();
  const double board = 0.014;
  piece.solids.push_back({{0.0, 0.0, 0.5 * height}, {0.5 * width, 0.5 * depth, 0.5 * height}});
  for (const double side : {-1.0, 1.0}) {
    piece.shape.box({side * (0.5 * width - board), 0.0, 0.5 * height},
                    {board, 0.5 * depth, 0.5 * height}, BoxSkins::all(wood));
  }
  for (int i = 0; i <= shelves; ++i) {
    piece.shape.box({0.0, 0.0, 0.05 + i * pitch}, {0.5 * width, 0.5 * depth, board},
                    {wood, {}, {}, {}, wood, wood});
    if (i == shelves) break;
    const double floor = 0.05 + i * pitch + board;
    const double tall = pitch - 2.0 * board;
    piece.shape.rectangle({0.5 * width, -0.5 * depth + 0.02, floor}, {-width, 0.0, 0.0},
                          {0.0, 0.0, tall}, room.dark());
    if (random.chance(0.25)) {  // things instead of books
      for (double x = -0.5 * width + 0.12; x < 0.5 * width - 0.12; x += random.uniform(0.18, 0.3)) {
        const double half = random.uniform(0.05, 0.08);
        const double rise = random.uniform(0.07, 0.13);
        piece.shape.box({x, 0.02, floor + rise}, {half, half, rise},
                        BoxSkins::all(goods(room, random)), random.uniform(-0.4, 0.4));
      }
      continue;
    }
    piece.shape.box({0.0, -0.02, floor + 0.5 * tall}, {0.5 * width - 2.0 * board, 0.1, 0.5 * tall},
                    {spines(room, random), {}, {}, {}, room.dark(), {}});
  }
  return piece;
}

Piece television(RoomBuilder& room, Random random) {
  const double width = random.uniform(1.3, 1.7);
  Piece piece = named("television", 0.5 * width, 0.21, 1.3);
  const Skin front = room.skin("tv bench", [&](Random r) {
    return print::drawers({320, 80}, room.palette.second_wood, 4, 1, r);
  });
  const Skin wood = room.second_wood();
  piece.part({0.0, 0.0, 0.25}, {0.5 * width, 0.2, 0.19}, {front, {}, wood, wood, wood, wood});
  legs(piece, 0.5 * width, 0.2, 0.06, 0.03, room.dark());
  const Skin picture = room.skin("tv picture", [](Random r) {
    return print::painting({288, 160}, r);
  });
  piece.shape.box({0.0, -0.06, 0.86}, {0.42 * width, 0.025, 0.25 * width},
                  {picture, {}, room.dark(), room.dark(), room.dark(), room.dark()});
  piece.shape.box({0.0, -0.06, 0.46}, {0.2, 0.09, 0.02}, BoxSkins::all(room.dark()));
  for (const double side : {-1.0, 1.0}) {
    piece.shape.box({side * 0.46 * width, 0.04, 0.56}, {0.06, 0.07, 0.12},
                    BoxSkins::all(goods(room, random)));
  }
  return piece;
}

Piece sideboard(RoomBuilder& room, Random random) {
  const double width = random.uniform(1.0, 1.7);
  const double height = random.uniform(0.72, 0.9);
  Piece piece = named("sideboard", 0.5 * width, 0.22, height);
  const Skin front = room.one_of("sideboard", 2, random, [&](Random r) {
    Random choice = r.fork("kind");
    return print::drawers({320, 176}, choice.chance(0.5) ? room.palette.wood : room.palette.accent,
                          static_cast<int>(2 + choice.below(2)), 3, r);
  });
  const Skin wood = room.wood();
  piece.part({0.0, 0.0, 0.5 * height + 0.04}, {0.5 * width, 0.21, 0.5 * height - 0.04},
             {front, {}, wood, wood, wood, wood});
  legs(piece, 0.5 * width, 0.21, 0.08, 0.03, room.dark());
  for (double x = -0.5 * width + 0.15; x < 0.5 * width - 0.15; x += random.uniform(0.2, 0.4)) {
    if (!random.chance(room.clutter())) continue;
    const double rise = random.uniform(0.07, 0.16);
    piece.shape.box({x, 0.0, height + rise}, {random.uniform(0.06, 0.11), 0.07, rise},
                    BoxSkins::all(goods(room, random)), random.uniform(-0.3, 0.3));
  }
  return piece;
}

Piece coffee_table(RoomBuilder& room, Random random) {
  const double half_x = random.uniform(0.4, 0.5);
  const double half_y = random.uniform(0.25, 0.3);
  Piece piece = named("coffee_table", half_x, half_y, 0.42);
  piece.part({0.0, 0.0, 0.39}, {half_x, half_y, 0.025}, BoxSkins::six(room.wood()));
  legs(piece, half_x, half_y, 0.37, 0.028, room.wood());
  piece.shape.box({0.0, 0.0, 0.12}, {half_x - 0.05, half_y - 0.05, 0.012},
                  BoxSkins::six(room.wood()));
  piece.shape.box({0.1, 0.0, 0.16}, {0.16, 0.12, 0.03}, BoxSkins::all(goods(room, random)), 0.3);
  piece.shape.box({-0.15, 0.0, 0.46}, {0.13, 0.1, 0.045}, BoxSkins::all(goods(room, random)), 0.5);
  return piece;
}

Piece plant(RoomBuilder& room, Random random) {
  Piece piece = named("plant", 0.17, 0.17, 1.2);
  const Skin pot = room.one_of("pot", 2, random, [&](Random r) {
    return texture::fabric({160, 64}, room.palette.second_fabric, room.palette.accent, r);
  });
  const Skin green = room.skin("leaves", [](Random r) { return print::leaves({192, 192}, r); });
  piece.solids.push_back({{0.0, 0.0, 0.18}, {0.16, 0.16, 0.18}});
  piece.shape.cylinder({0.0, 0.0, 0.0}, 0.13, 0.17, 0.34, pot, room.dark(), 12);
  const int count = 22;
  for (int i = 0; i < count; ++i) {  // each leaf is seen from both sides
    const double turn = 2.4 * i + random.uniform(-0.3, 0.3);
    const double lift = random.uniform(0.25, 0.95);
    const double length = random.uniform(0.2, 0.38);
    const Eigen::Vector3d out(std::cos(turn), std::sin(turn), 0.0);
    const Eigen::Vector3d side(-std::sin(turn), std::cos(turn), 0.0);
    const Eigen::Vector3d along = length * (0.62 * out + lift * Eigen::Vector3d::UnitZ());
    const Eigen::Vector3d root = Eigen::Vector3d(0.0, 0.0, 0.32 + 0.5 * i / count) - 0.06 * side;
    const auto at = static_cast<float>(random.uniform(0.0, 0.6));
    const Skin leaf = green.part(at, at, at + 0.4F, at + 0.4F);
    piece.shape.rectangle(root, 0.12 * side, along, leaf);
    piece.shape.rectangle(root + 0.12 * side, -0.12 * side, along, leaf);
  }
  return piece;
}

Piece floor_lamp(RoomBuilder& room, Random random) {
  Piece piece = named("floor_lamp", 0.15, 0.15, 1.6);
  const double height = random.uniform(1.35, 1.6);
  piece.solids.push_back({{0.0, 0.0, 0.02}, {0.14, 0.14, 0.02}});
  piece.solids.push_back({{0.0, 0.0, 0.5 * height}, {0.015, 0.015, 0.5 * height}});
  piece.shape.cylinder({0.0, 0.0, 0.0}, 0.14, 0.13, 0.03, room.metal(), room.metal(), 12);
  piece.shape.cylinder({0.0, 0.0, 0.03}, 0.014, 0.014, height, room.metal(), {}, 6);
  const Skin shade = room.skin("lamp shade", [](Random r) {
    return texture::fabric({128, 64}, {250, 238, 205}, {235, 205, 150}, r);
  });
  piece.shape.cylinder({0.0, 0.0, height - 0.1}, 0.2, 0.13, 0.26, shade, shade, 12);
  return piece;
}

Piece pouf(RoomBuilder& room, Random random) {
  const double radius = random.uniform(0.2, 0.26);
  Piece piece = named("pouf", radius, radius, 0.4);
  const double height = random.uniform(0.32, 0.4);
  piece.solids.push_back({{0.0, 0.0, 0.5 * height}, {0.9 * radius, 0.9 * radius, 0.5 * height}});
  const Skin cover = random.chance(0.5) ? room.fabric() : room.second_fabric();
  piece.shape.cylinder({0.0, 0.0, 0.0}, radius, radius, height, cover, cover, 14);
  return piece;
}

Piece toys(RoomBuilder& room, Random random) {
  Piece piece = named("toys", 0.24, 0.17, 0.4);
  const double half = random.uniform(0.07, 0.09);
  for (int level = 0, count = 3; count > 0; --count, ++level) {  // a pyramid of blocks
    for (int i = 0; i < count; ++i) {
      if (level > 0 && random.chance(0.25)) continue;
      piece.part({(i - 0.5 * (count - 1)) * 2.0 * half, random.uniform(-0.05, 0.05),
                  (2 * level + 1) * 0.85 * half},
                 {0.95 * half, 0.85 * half, 0.85 * half}, BoxSkins::all(goods(room, random)));
    }
  }
  return piece;
}

}  // namespace pacer::sim::furniture
