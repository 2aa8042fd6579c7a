// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "sim/furniture.h"
#include "sim/room_builder.h"

namespace pacer::sim {

void furnish_living(RoomBuilder& room) {
  using namespace furniture;
  Random draw = room.random("colours");
  const std::array<Palette, 3> palettes = {{
      {{222, 210, 190},
       {150, 70, 55},
       {150, 100, 60},
       {232, 226, 214},
       {70, 105, 120},
       {205, 170, 90},
       {130, 125, 118}},
      {{190, 205, 200},
       {55, 95, 100},
       {196, 152, 104},
       {120, 82, 55},
       {165, 80, 70},
       {225, 210, 180},
       {150, 140, 125}},
      {{228, 214, 205},
       {120, 95, 140},
       {112, 74, 50},
       {222, 212, 196},
       {95, 125, 85},
       {215, 150, 110},
       {110, 112, 116}},
  }};
  room.palette = palettes.at(draw.below(palettes.size()));
  room.palette.wall = texture::vary(room.palette.wall, 9.0, draw);
  room.palette.fabric = texture::vary(room.palette.fabric, 14.0, draw);
  room.palette.wood = texture::vary(room.palette.wood, 12.0, draw);

  const bool carpeted = draw.chance(0.35);
  room.shell(carpeted ? texture::carpet({512, 512}, texture::vary({168, 150, 126}, 16.0, draw),
                                        room.palette.accent, room.random("floor"))
                      : texture::parquet({512, 512}, texture::vary({168, 122, 78}, 16.0, draw), 12,
                                         room.random("floor")),
             carpeted ? 1.1 : 1.4,
             texture::wallpaper({384, 384}, room.palette.wall, room.palette.accent,
                                room.random("wallpaper")),
             draw.uniform(1.2, 1.6));
  room.light(draw.uniform(0.3, 0.4), draw.uniform(0.5, 0.65), draw.uniform(0.16, 0.3));

  room.line_up(0, {floor_lamp, bookcase, sofa, sideboard, plant, bookcase, armchair},
               {window, painting});
  room.line_up(1, {plant, television, bookcase, toys, door}, {painting, poster});
  room.line_up(2, {door, sideboard, armchair, bookcase, sofa, plant, bookcase, floor_lamp},
               {painting, window});
  room.line_up(3, {bookcase, sideboard, armchair, bookcase, plant}, {painting, window});

  // A rug lies flat under the car; the table and a pouf are to be driven around.
  const double rug_x = draw.uniform(0.8, 1.1);
  const double rug_y = draw.uniform(0.6, 0.85);
  Piece mat;
  mat.name = "rug";
  const Skin pattern = room.skin("rug", [&](Random r) {
    return texture::rug({448, 352}, room.palette.fabric, room.palette.second_fabric, r);
  });
  mat.shape.rectangle({-rug_x, -rug_y, 0.0015}, {2.0 * rug_x, 0.0, 0.0}, {0.0, 2.0 * rug_y, 0.0},
                      pattern);
  room.put(std::move(mat),
           {{draw.uniform(-0.8, 0.8), draw.uniform(-0.6, 0.6)}, draw.uniform(-0.3, 0.3)});
  room.island(coffee_table(room, room.random("table")),
              {draw.uniform(-1.0, 1.0), 0.45 * room.half().y()}, 0.5, 0.05);
  room.scatter({toys, stack_of_books, product, carton, pouf}, 16);
}

}  // namespace pacer::sim
