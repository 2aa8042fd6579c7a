// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/random.h"
#include "sim/room_builder.h"

/// What several pieces of furniture are made of.
namespace pacer::sim::furniture {

/// A piece without parts yet: half its sides on the floor and its height, metres.
[[nodiscard]] Piece named(const char* name, double half_x, double half_y, double height);

/// Legs at the corners of a table top; `thick` is half a leg's side. Metres.
void legs(Piece& piece, double half_x, double half_y, double height, double thick,
          const Skin& skin);

[[nodiscard]] Skin goods(RoomBuilder& room, Random& random);  ///< a printed package
[[nodiscard]] Skin board(RoomBuilder& room, Random& random);  ///< a cardboard box
[[nodiscard]] Skin paint(RoomBuilder& room, int variant);     ///< painted metal

}  // namespace pacer::sim::furniture
