// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "sim/furniture.h"
#include "sim/print.h"

// What stands in offices and workshops.
namespace pacer::sim::furniture {
namespace {

Piece named(const char* name, double half_x, double half_y, double height) {
  Piece piece;
  piece.name = name;
  piece.half = {half_x, half_y};
  piece.height = height;
  return piece;
}

Skin binders(RoomBuilder& room, Random& random) {
  const Skin row = room.one_of("binders", 3, random, [](Random r) {
    return print::binders({560, 112}, r);
  });
  const auto left = static_cast<float>(random.uniform(0.0, 0.45));
  return row.part(left, 0.0F, left + 0.5F, 1.0F);
}

Skin board(RoomBuilder& room, Random& random) {
  return room.one_of("carton", 5, random, [](Random r) { return print::carton({160, 128}, r); });
}

Skin goods(RoomBuilder& room, Random& random) {
  return room.one_of("product", 7, random, [](Random r) { return print::product({104, 112}, r); });
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
