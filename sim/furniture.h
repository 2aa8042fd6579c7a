// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sim/room_builder.h"

/// Things to furnish rooms with. Each is made for one room, whose colours and pictures it wears,
/// and varies with its random. Sizes are those of the furniture one can buy.
namespace pacer::sim::furniture {

// For living.
[[nodiscard]] Piece sofa(RoomBuilder& room, Random random);
[[nodiscard]] Piece armchair(RoomBuilder& room, Random random);
[[nodiscard]] Piece bookcase(RoomBuilder& room, Random random);
[[nodiscard]] Piece television(RoomBuilder& room, Random random);
[[nodiscard]] Piece sideboard(RoomBuilder& room, Random random);
[[nodiscard]] Piece coffee_table(RoomBuilder& room, Random random);
[[nodiscard]] Piece plant(RoomBuilder& room, Random random);
[[nodiscard]] Piece floor_lamp(RoomBuilder& room, Random random);
[[nodiscard]] Piece pouf(RoomBuilder& room, Random random);
[[nodiscard]] Piece toys(RoomBuilder& room, Random random);

// For work.
[[nodiscard]] Piece desk(RoomBuilder& room, Random random);
[[nodiscard]] Piece filing_cabinet(RoomBuilder& room, Random random);
[[nodiscard]] Piece binder_shelf(RoomBuilder& room, Random random);
[[nodiscard]] Piece copier(RoomBuilder& room, Random random);
[[nodiscard]] Piece office_chair(RoomBuilder& room, Random random);
[[nodiscard]] Piece bin(RoomBuilder& room, Random random);
[[nodiscard]] Piece meeting_table(RoomBuilder& room, Random random);

// For tools.
[[nodiscard]] Piece workbench(RoomBuilder& room, Random random);
[[nodiscard]] Piece tool_cabinet(RoomBuilder& room, Random random);
[[nodiscard]] Piece storage_rack(RoomBuilder& room, Random random);
[[nodiscard]] Piece crates(RoomBuilder& room, Random random);
[[nodiscard]] Piece tyres(RoomBuilder& room, Random random);
[[nodiscard]] Piece barrel(RoomBuilder& room, Random random);
[[nodiscard]] Piece sawhorses(RoomBuilder& room, Random random);

// Small things for the floor.
[[nodiscard]] Piece carton(RoomBuilder& room, Random random);
[[nodiscard]] Piece product(RoomBuilder& room, Random random);
[[nodiscard]] Piece stack_of_books(RoomBuilder& room, Random random);

// On walls; they take no floor.
[[nodiscard]] Piece painting(RoomBuilder& room, Random random);
[[nodiscard]] Piece poster(RoomBuilder& room, Random random);
[[nodiscard]] Piece whiteboard(RoomBuilder& room, Random random);
[[nodiscard]] Piece pegboard(RoomBuilder& room, Random random);
[[nodiscard]] Piece window(RoomBuilder& room, Random random);
[[nodiscard]] Piece door(RoomBuilder& room, Random random);

}  // namespace pacer::sim::furniture
