// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "sim/furniture.h"
#include "sim/furniture_parts.h"
#include "sim/print.h"

// What stands in offices.
namespace pacer::sim::furniture {
namespace {

Skin binders(RoomBuilder& room, Random& random) {
  const Skin row = room.one_of("binders", 3, random, [](Random r) {
    return print::binders({560, 112}, r);
  });
  const auto left = static_cast<float>(random.uniform(0.0, 0.45));
  return row.part(left, 0.0F, left + 0.5F, 1.0F);
}

}  // namespace

Piece desk(RoomBuilder& room, Random random) {
  const double width = random.uniform(1.3, 1.6);
  const double depth = 0.72;
  Piece piece = named("desk", 0.5 * width, 0.5 * depth, 1.12);
  const Skin top = room.wood();
  piece.part({0.0, 0.0, 0.725}, {0.5 * width, 0.5 * depth, 0.018}, BoxSkins::six(top));
  const Skin front = room.skin("pedestal", [&](Random r) {
    return print::drawers({112, 160}, room.palette.second_wood, 1, 4, r);
  });
  const Skin side = room.second_wood();
  const double left = random.chance(0.5) ? -1.0 : 1.0;
  piece.part({left * (0.5 * width - 0.22), 0.0, 0.33}, {0.2, 0.32, 0.31},
             {front, {}, side, side, side, {}});
  piece.part({-left * (0.5 * width - 0.03), 0.0, 0.35}, {0.025, 0.32, 0.35}, BoxSkins::all(side));
  piece.shape.box({0.0, -0.3, 0.45}, {0.5 * width - 0.05, 0.012, 0.22}, BoxSkins::six(side));
  const Skin picture = room.one_of("screen", 3, random, [](Random r) {
    return print::screen({240, 152}, r);
  });
  const int monitors = random.chance(0.4) ? 2 : 1;
  for (int i = 0; i < monitors; ++i) {
    const double x = monitors == 1 ? random.uniform(-0.15, 0.15) : (i == 0 ? -0.32 : 0.32);
    piece.shape.box({x, -0.12, 1.0}, {0.29, 0.025, 0.17},
                    {picture, room.dark(), room.dark(), room.dark(), room.dark(), room.dark()},
                    random.uniform(-0.2, 0.2));
    piece.shape.box({x, -0.14, 0.79}, {0.03, 0.03, 0.05}, BoxSkins::all(room.dark()));
  }
  const Skin keys = room.skin("keyboard", [](Random r) { return print::keyboard({192, 64}, r); });
  piece.shape.box({0.0, 0.15, 0.753}, {0.22, 0.07, 0.01}, BoxSkins::all(keys));
  // A case of the computer stands under the desk, with its lights and vents.
  piece.part({-left * (0.5 * width - 0.2), 0.02, 0.21}, {0.09, 0.2, 0.2},
             BoxSkins::all(goods(room, random)));
  for (int i = 0; i < 2; ++i) {
    piece.shape.box({left * (0.5 * width - 0.2), random.uniform(-0.2, 0.2), 0.79 + 0.02 * i},
                    {0.12, 0.1, 0.05}, BoxSkins::all(goods(room, random)),
                    random.uniform(-0.4, 0.4));
  }
  return piece;
}

Piece filing_cabinet(RoomBuilder& room, Random random) {
  const int rows = static_cast<int>(2 + random.below(3));
  const double height = 0.12 + 0.31 * rows;
  Piece piece = named("filing_cabinet", 0.23, 0.3, height);
  const Skin front = room.one_of("files", 2, random, [&](Random r) {
    Random tone = r.fork("tone");
    return print::drawers({128, 224}, texture::vary(room.palette.metal, 25.0, tone), 1, 3, r);
  });
  piece.part({0.0, 0.0, 0.5 * height}, {0.22, 0.29, 0.5 * height},
             {front, {}, room.metal(), room.metal(), room.metal(), {}});
  piece.shape.box({0.0, 0.0, height + 0.09}, {0.12, 0.14, 0.09}, BoxSkins::all(board(room, random)),
                  random.uniform(-0.3, 0.3));
  return piece;
}

Piece binder_shelf(RoomBuilder& room, Random random) {
  const double width = random.uniform(0.8, 1.25);
  const int shelves = static_cast<int>(3 + random.below(3));
  const double pitch = 0.37;
  const double height = shelves * pitch + 0.1;
  Piece piece = named("binder_shelf", 0.5 * width, 0.19, height);
  const Skin frame = random.chance(0.5) ? room.second_wood() : room.metal();
  piece.solids.push_back({{0.0, 0.0, 0.5 * height}, {0.5 * width, 0.19, 0.5 * height}});
  for (const double side : {-1.0, 1.0}) {
    piece.shape.box({side * (0.5 * width - 0.015), 0.0, 0.5 * height}, {0.015, 0.19, 0.5 * height},
                    BoxSkins::all(frame));
  }
  for (int i = 0; i <= shelves; ++i) {
    piece.shape.box({0.0, 0.0, 0.06 + i * pitch}, {0.5 * width, 0.19, 0.014},
                    {frame, {}, {}, {}, frame, frame});
    if (i == shelves) break;
    const double floor = 0.074 + i * pitch;
    piece.shape.rectangle({0.5 * width, -0.17, floor}, {-width, 0.0, 0.0}, {0.0, 0.0, 0.34},
                          room.dark());
    if (random.chance(0.7)) {
      piece.shape.box({0.0, -0.02, floor + 0.16}, {0.5 * width - 0.035, 0.14, 0.16},
                      {binders(room, random), {}, {}, {}, room.dark(), {}});
    } else {
      for (double x = -0.5 * width + 0.18; x < 0.5 * width - 0.16; x += 0.31) {
        piece.shape.box({x, 0.0, floor + 0.11}, {0.14, 0.15, 0.11},
                        BoxSkins::all(board(room, random)), random.uniform(-0.1, 0.1));
      }
    }
  }
  return piece;
}

Piece copier(RoomBuilder& room, Random random) {
  Piece piece = named("copier", 0.32, 0.31, 1.1);
  const Skin body = room.skin(
      "copier",
      [](Random r) {
        return texture::plain({96, 96}, {205, 204, 198}, 7.0, r);
      },
      0.5);
  const Skin trays = room.skin("trays", [](Random r) {
    return print::drawers({144, 160}, {196, 196, 192}, 1, 4, r);
  });
  piece.part({0.0, 0.0, 0.32}, {0.31, 0.29, 0.3}, {trays, {}, body, body, body, {}});
  piece.part({0.0, 0.0, 0.75}, {0.31, 0.29, 0.12}, BoxSkins::all(body));
  piece.shape.box({0.0, 0.0, 0.9}, {0.31, 0.28, 0.03}, BoxSkins::all(room.dark()));
  const Skin panel = room.one_of("screen", 3, random, [](Random r) {
    return print::screen({240, 152}, r);
  });
  piece.shape.box({0.16, 0.3, 0.82}, {0.11, 0.015, 0.05}, BoxSkins::all(panel));
  return piece;
}

Piece office_chair(RoomBuilder& room, Random random) {
  Piece piece = named("office_chair", 0.28, 0.28, 1.0);
  const double turn = random.uniform(-0.8, 0.8);
  piece.solids.push_back({{0.0, 0.0, 0.05}, {0.26, 0.26, 0.05}});
  piece.solids.push_back({{0.0, 0.0, 0.28}, {0.04, 0.04, 0.2}});
  piece.solids.push_back({{0.0, 0.0, 0.48}, {0.22, 0.22, 0.04}});
  for (int i = 0; i < 3; ++i) {
    piece.shape.box({0.0, 0.0, 0.07}, {0.26, 0.025, 0.02}, BoxSkins::six(room.dark()),
                    turn + 1.0472 * i);
  }
  piece.shape.cylinder({0.0, 0.0, 0.08}, 0.03, 0.03, 0.38, room.metal(), {}, 8);
  piece.shape.box({0.0, 0.0, 0.48}, {0.23, 0.22, 0.04}, BoxSkins::six(room.fabric()), turn);
  piece.shape.box({-0.2 * -std::sin(turn), -0.2 * std::cos(turn), 0.77}, {0.21, 0.035, 0.24},
                  BoxSkins::six(room.fabric()), turn);
  return piece;
}

Piece bin(RoomBuilder& room, Random random) {
  Piece piece = named("bin", 0.14, 0.14, 0.32);
  piece.solids.push_back({{0.0, 0.0, 0.16}, {0.12, 0.12, 0.16}});
  piece.shape.cylinder({0.0, 0.0, 0.0}, 0.11, 0.14, 0.32,
                       random.chance(0.5) ? goods(room, random) : paint(room, 1), room.dark(), 12);
  return piece;
}

Piece meeting_table(RoomBuilder& room, Random random) {
  const double half_x = random.uniform(0.55, 0.7);
  const double half_y = 0.38;
  Piece piece = named("meeting_table", half_x, half_y, 0.74);
  piece.part({0.0, 0.0, 0.72}, {half_x, half_y, 0.02}, BoxSkins::six(room.wood()));
  for (const double side : {-1.0, 1.0}) {
    piece.part({side * (half_x - 0.12), 0.0, 0.35}, {0.035, half_y - 0.06, 0.35},
               BoxSkins::all(room.second_wood()));
  }
  piece.shape.box({0.0, 0.0, 0.5}, {half_x - 0.12, 0.012, 0.14}, BoxSkins::six(room.second_wood()));
  piece.part({random.uniform(-0.1, 0.1), 0.0, 0.13}, {0.17, 0.14, 0.13},
             BoxSkins::all(board(room, random)));
  return piece;
}

}  // namespace pacer::sim::furniture
