// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace pacer::affordance {

/// The bits of a word that a mask selects, moved together at the low end, in six steps that depend
/// on the mask alone (Warren, Hacker's Delight, 7-4).
struct Compression {
  explicit Compression(std::uint64_t mask) noexcept;
  std::uint64_t selected;
  std::array<std::uint64_t, 6> moves{};
};

/// The loops that mining spends its time in, over eight neighbouring words at a time, compiled
/// for several processors and chosen at start. All give the same numbers.
struct BitLoops {
  /// counts[row] += bits that mask[w] and bits[w * stride + row] share, over all w < words, for
  /// each row < rows. `rows` is a multiple of eight.
  void (*add_shared)(const std::uint64_t* mask, const std::uint64_t* bits, std::size_t stride,
                     std::size_t words, std::size_t rows, std::uint32_t* counts);

  /// Appends the selected bits of from[rows[i]] to to[i], which holds `filled` (< 64) bits. What
  /// does not fit goes to next[i]; null where all fits.
  void (*append)(const Compression& how, const std::uint64_t* from, const std::uint32_t* rows,
                 std::size_t count, int filled, std::uint64_t* to, std::uint64_t* next);

  /// Writes each row < `rows` whose count is at least `least`; returns how many. `rows` is a
  /// multiple of eight; `selected` has room for them all.
  std::size_t (*select)(const std::uint32_t* counts, std::size_t rows, std::uint32_t least,
                        std::uint32_t* selected);
};

/// Any processor's first, then those that this one has, the fastest last.
[[nodiscard]] std::size_t bit_loop_count() noexcept;
[[nodiscard]] const BitLoops& bit_loops(std::size_t kind) noexcept;
[[nodiscard]] const BitLoops& fastest_bit_loops() noexcept;

}  // namespace pacer::affordance
