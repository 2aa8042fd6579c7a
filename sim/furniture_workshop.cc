// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "sim/furniture.h"
#include "sim/furniture_parts.h"
#include "sim/print.h"

// What stands in workshops.
namespace pacer::sim::furniture {

Piece workbench(RoomBuilder& room, Random random) {
  const double width = random.uniform(1.5, 2.0);
  Piece piece = named("workbench", 0.5 * width, 0.34, 0.95);
  const Skin wood = room.wood();
  piece.part({0.0, 0.0, 0.85}, {0.5 * width, 0.34, 0.035}, BoxSkins::six(wood));
  for (const double side : {-1.0, 1.0}) {
    for (const double depth : {-1.0, 1.0}) {
      piece.part({side * (0.5 * width - 0.06), depth * 0.28, 0.41}, {0.045, 0.045, 0.41},
                 BoxSkins::all(wood));
    }
  }
  piece.part({0.0, 0.0, 0.2}, {0.5 * width - 0.1, 0.28, 0.015}, BoxSkins::six(wood));
  for (double x = -0.5 * width + 0.3; x < 0.5 * width - 0.25; x += random.uniform(0.34, 0.5)) {
    const double rise = random.uniform(0.1, 0.19);
    piece.shape.box({x, random.uniform(-0.08, 0.08), 0.215 + rise}, {0.15, 0.15, rise},
                    BoxSkins::all(random.chance(0.5) ? board(room, random) : goods(room, random)),
                    random.uniform(-0.2, 0.2));
  }
  const Skin drawers = room.skin("bench drawers", [&](Random r) {
    return print::drawers({200, 80}, room.palette.accent, 3, 2, r);
  });
  piece.shape.box({0.25 * width, 0.05, 0.69}, {0.22 * width, 0.27, 0.12},
                  {drawers, {}, wood, wood, {}, wood});
  for (double x = -0.5 * width + 0.2; x < 0.5 * width - 0.2; x += random.uniform(0.3, 0.5)) {
    if (!random.chance(room.clutter())) continue;
    const double rise = random.uniform(0.05, 0.12);
    piece.shape.box({x, -0.1, 0.885 + rise}, {0.09, 0.09, rise}, BoxSkins::all(goods(room, random)),
                    random.uniform(-0.5, 0.5));
  }
  return piece;
}

Piece tool_cabinet(RoomBuilder& room, Random random) {
  const double height = random.uniform(0.8, 1.0);
  Piece piece = named("tool_cabinet", 0.34, 0.24, height);
  const Skin front = room.skin("tool drawers", [&](Random r) {
    return print::drawers({176, 224}, room.palette.fabric, 1, 7, r);
  });
  const Skin side = room.skin(
      "tool side",
      [&](Random r) {
        return texture::metal({128, 128}, room.palette.fabric, r);
      },
      0.6);
  piece.part({0.0, 0.0, 0.5 * height + 0.05}, {0.33, 0.23, 0.5 * height - 0.05},
             {front, {}, side, side, side, side});
  for (const double x : {-0.27, 0.27}) {
    piece.part({x, 0.16, 0.05}, {0.03, 0.04, 0.05}, BoxSkins::all(room.dark()));
  }
  piece.shape.box({0.0, 0.0, height + 0.1}, {0.2, 0.1, 0.1}, BoxSkins::all(goods(room, random)),
                  random.uniform(-0.2, 0.2));
  return piece;
}

Piece storage_rack(RoomBuilder& room, Random random) {
  const double width = random.uniform(1.1, 1.6);
  const double depth = 0.5;
  Piece piece = named("storage_rack", 0.5 * width, 0.5 * depth, 1.9);
  const Skin post = paint(room, 0);
  for (const double side : {-1.0, 1.0}) {
    for (const double back : {-1.0, 1.0}) {
      piece.part({side * (0.5 * width - 0.025), back * (0.5 * depth - 0.025), 0.95},
                 {0.025, 0.025, 0.95}, BoxSkins::all(post));
    }
  }
  for (int level = 0; level < 4; ++level) {
    const double z = 0.14 + 0.55 * level;
    piece.part({0.0, 0.0, z}, {0.5 * width - 0.02, 0.5 * depth - 0.01, 0.02},
               BoxSkins::six(room.wood()));
    for (double x = -0.5 * width + 0.22; x < 0.5 * width - 0.15;) {
      const double half = random.uniform(0.12, 0.18);
      const double rise = random.uniform(0.1, 0.21);
      if (random.chance(0.5 + 0.5 * room.clutter())) {
        piece.shape.box(
            {x, random.uniform(0.0, 0.06), z + 0.02 + rise}, {half, 0.17, rise},
            BoxSkins::all(random.chance(0.6) ? board(room, random) : goods(room, random)),
            random.uniform(-0.12, 0.12));
      }
      x += 2.0 * half + 0.04;
    }
  }
  return piece;
}

Piece crates(RoomBuilder& room, Random random) {
  const double half_x = random.uniform(0.28, 0.34);
  Piece piece = named("crates", half_x, 0.25, 0.7);
  const Skin slats = room.skin("slats", [&](Random r) {
    return print::drawers({160, 120}, room.palette.second_wood, 1, 4, r);
  });
  const int levels = static_cast<int>(1 + random.below(3));
  for (int i = 0; i < levels; ++i) {
    piece.part({random.uniform(-0.02, 0.02), 0.0, 0.16 + 0.32 * i}, {half_x - 0.02, 0.22, 0.155},
               BoxSkins::all(slats));
  }
  piece.height = 0.32 * levels;
  piece.shape.box({0.0, 0.0, 0.32 * levels + 0.08}, {0.14, 0.1, 0.08},
                  BoxSkins::all(goods(room, random)), random.uniform(-0.4, 0.4));
  return piece;
}

Piece tyres(RoomBuilder& room, Random random) {
  Piece piece = named("tyres", 0.32, 0.32, 0.8);
  const Skin tread = room.skin("tread", [](Random r) {
    cv::Mat picture = texture::tiles({256, 64}, {48, 48, 50}, {18, 18, 18}, 24, r);
    return picture;
  });
  const Skin wheel = room.skin("wheel", [](Random r) {
    cv::Mat picture = texture::rug({128, 128}, {60, 60, 62}, {150, 150, 155}, r);
    return picture;
  });
  const int count = static_cast<int>(2 + random.below(3));
  for (int i = 0; i < count; ++i) {
    piece.shape.cylinder({random.uniform(-0.02, 0.02), random.uniform(-0.02, 0.02), 0.205 * i},
                         0.31, 0.31, 0.2, tread, wheel, 16);
  }
  piece.height = 0.205 * count;
  piece.solids.push_back({{0.0, 0.0, 0.5 * piece.height}, {0.3, 0.3, 0.5 * piece.height}});
  return piece;
}

Piece barrel(RoomBuilder& room, Random random) {
  Piece piece = named("barrel", 0.29, 0.29, 0.88);
  const Skin mantle = room.one_of("barrel", 2, random, [&](Random r) {
    cv::Mat picture = texture::metal({288, 144}, room.palette.accent, r.fork("metal"));
    print::product({96, 96}, r.fork("label")).copyTo(picture(cv::Rect(20, 24, 96, 96)));
    print::carton({96, 96}, r.fork("other")).copyTo(picture(cv::Rect(164, 24, 96, 96)));
    return picture;
  });
  piece.solids.push_back({{0.0, 0.0, 0.44}, {0.27, 0.27, 0.44}});
  piece.shape.cylinder({0.0, 0.0, 0.0}, 0.285, 0.285, 0.88, mantle, room.metal(), 16);
  return piece;
}

Piece sawhorses(RoomBuilder& room, Random random) {
  const double half_x = random.uniform(0.5, 0.65);
  Piece piece = named("sawhorses", half_x, 0.3, 0.7);
  const Skin wood = room.second_wood();
  for (const double side : {-0.62, 0.62}) {
    for (const double depth : {-0.22, 0.22}) {
      piece.part({side * half_x, depth, 0.3}, {0.03, 0.03, 0.3}, BoxSkins::all(wood));
    }
    piece.part({side * half_x, 0.0, 0.62}, {0.04, 0.27, 0.035}, BoxSkins::six(wood));
  }
  piece.part({0.0, 0.0, 0.675}, {half_x, 0.25, 0.02}, BoxSkins::six(room.wood()));
  piece.part({0.0, 0.0, 0.15}, {0.16, 0.16, 0.15}, BoxSkins::all(board(room, random)));
  return piece;
}

}  // namespace pacer::sim::furniture
