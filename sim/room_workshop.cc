// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "sim/furniture.h"
#include "sim/room_builder.h"

namespace pacer::sim {

void furnish_workshop(RoomBuilder& room) {
  using namespace furniture;
  Random draw = room.random("colours");
  const std::array<Palette, 3> palettes = {{
      {{150, 82, 62},
       {215, 160, 40},
       {170, 130, 85},
       {140, 105, 70},
       {175, 40, 35},
       {50, 85, 130},
       {120, 124, 130}},
      {{172, 166, 156},
       {60, 120, 160},
       {150, 112, 72},
       {185, 150, 105},
       {210, 110, 30},
       {60, 110, 70},
       {96, 100, 106}},
      {{132, 100, 84},
       {70, 140, 80},
       {120, 88, 60},
       {170, 138, 96},
       {40, 70, 140},
       {190, 60, 50},
       {150, 150, 148}},
  }};
  room.palette = palettes.at(draw.below(palettes.size()));
  room.palette.wall = texture::vary(room.palette.wall, 10.0, draw);
  room.wall_height = 2.8;

  const bool tiled = draw.chance(0.3);
  room.shell(tiled ? texture::tiles({512, 512}, texture::vary({138, 132, 122}, 14.0, draw),
                                    {86, 82, 78}, 6, room.random("floor"))
                   : texture::concrete({512, 512}, texture::vary({134, 131, 126}, 12.0, draw),
                                       room.random("floor")),
             1.05,
             texture::brick({384, 384}, room.palette.wall, {176, 170, 160}, room.random("wall")),
             draw.uniform(0.95, 1.1));
  room.light(draw.uniform(0.28, 0.36), draw.uniform(0.6, 0.8), draw.uniform(0.04, 0.12));

  room.line_up(0, {storage_rack, workbench, tool_cabinet, workbench, barrel, storage_rack, tyres},
               {pegboard, poster});
  room.line_up(1, {tyres, storage_rack, crates, workbench, barrel}, {pegboard, window});
  room.line_up(2, {crates, tool_cabinet, storage_rack, door, workbench, barrel, tyres, crates},
               {poster, pegboard, window});
  room.line_up(3, {workbench, barrel, storage_rack, tool_cabinet, crates}, {window, pegboard});
  room.island(sawhorses(room, room.random("table")), {0.45 * room.half().x(), draw.uniform(-1, 1)},
              0.4, 0.05);
  room.scatter({carton, product, crates, carton, tyres, product}, 16);
}

}  // namespace pacer::sim
