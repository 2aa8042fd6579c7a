// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "sim/furniture.h"
#include "sim/room_builder.h"

namespace pacer::sim {

void furnish_office(RoomBuilder& room) {
  using namespace furniture;
  Random draw = room.random("colours");
  const std::array<Palette, 3> palettes = {{
      {{214, 220, 224},
       {40, 90, 150},
       {205, 180, 145},
       {170, 172, 176},
       {50, 60, 85},
       {70, 120, 130},
       {165, 170, 176}},
      {{226, 222, 210},
       {190, 100, 40},
       {120, 85, 60},
       {222, 222, 218},
       {60, 62, 66},
       {200, 120, 60},
       {140, 146, 150}},
      {{206, 216, 204},
       {45, 110, 80},
       {222, 205, 170},
       {104, 110, 116},
       {120, 50, 55},
       {90, 140, 100},
       {190, 190, 186}},
  }};
  room.palette = palettes.at(draw.below(palettes.size()));
  room.palette.wall = texture::vary(room.palette.wall, 8.0, draw);
  room.palette.wood = texture::vary(room.palette.wood, 10.0, draw);
  room.wall_height = 2.6;
  const bool papered = draw.chance(0.5);

  room.shell(
      texture::carpet({512, 512}, texture::vary({104, 112, 124}, 18.0, draw),
                      texture::shade(room.palette.accent, 0.25), room.random("floor")),
      1.0,
      papered ? texture::wallpaper({384, 384}, room.palette.wall,
                                   texture::shade(room.palette.accent, 0.45), room.random("wall"))
              : texture::plaster({384, 384}, room.palette.wall, room.random("wall")),
      draw.uniform(0.9, 1.2));
  room.light(draw.uniform(0.36, 0.46), draw.uniform(0.55, 0.7), draw.uniform(0.06, 0.16));

  room.line_up(0, {binder_shelf, desk, filing_cabinet, desk, binder_shelf, plant, copier, bin},
               {whiteboard, poster, window});
  room.line_up(1, {copier, desk, filing_cabinet, binder_shelf, bin}, {window, whiteboard});
  room.line_up(2, {plant, desk, binder_shelf, filing_cabinet, desk, door, filing_cabinet},
               {poster, whiteboard, window});
  room.line_up(3, {binder_shelf, filing_cabinet, desk, binder_shelf, plant}, {whiteboard, poster});
  room.island(meeting_table(room, room.random("table")),
              {draw.uniform(-1.2, 1.2), -0.42 * room.half().y()}, 0.4, 0.05);
  for (int i = 0; i < 3; ++i) {
    const double side = i % 2 == 0 ? 1.0 : -1.0;
    room.island(office_chair(room, room.random("chair").fork("number", static_cast<unsigned>(i))),
                {draw.uniform(-2.0, 2.0), side * (room.half().y() - 1.15)}, 0.3, 0.03);
  }
  room.scatter({carton, bin, stack_of_books, carton, product}, 16);
}

}  // namespace pacer::sim
