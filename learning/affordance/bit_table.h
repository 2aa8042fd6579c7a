// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "learning/affordance/bit_loops.h"

namespace pacer::affordance {

/// Which transactions (columns) hold which items (rows), a bit each, 64 transactions a word.
///
/// Words lie by transactions, not by items: the words of all rows for the same 64 transactions are
/// neighbours, rows padded to a multiple of eight. So one row is counted against all others, and
/// all rows are projected at once, in loops over neighbouring words whatever the row's length.
class BitTable {
 public:
  using Word = std::uint64_t;

  explicit BitTable(const BitLoops& loops = fastest_bit_loops()) noexcept : loops_(&loops) {}

  /// `rows` x `columns`, all clear. Keeps its memory.
  void reset(std::size_t rows, std::size_t columns);
  void set(std::size_t row, std::size_t column) noexcept {
    bits_[(column / 64) * stride_ + row] |= Word{1} << (column % 64);
  }

  [[nodiscard]] std::size_t rows() const noexcept { return rows_; }
  [[nodiscard]] std::size_t columns() const noexcept { return columns_; }
  [[nodiscard]] std::size_t words() const noexcept { return (columns_ + 63) / 64; }
  [[nodiscard]] Word word(std::size_t row, std::size_t index) const noexcept {
    return bits_[index * stride_ + row];
  }

  /// The words of `row`, one after the other.
  void copy_row(std::size_t row, std::vector<Word>& to) const;

  /// Adds to counts[r], for each r < `rows`, the set bits that row r and `mask` share in the words
  /// [first, last). `counts` must have room for `rows` rounded up to eight; the excess is written.
  void add_shared(std::span<const Word> mask, std::size_t first, std::size_t last, std::size_t rows,
                  std::vector<std::uint32_t>& counts) const;

  /// The rows < `rows` whose count is at least `least`, ascending; `counts` as of add_shared from
  /// zeros, `least` at least 1.
  void select_rows(const std::vector<std::uint32_t>& counts, std::uint32_t least, std::size_t rows,
                   std::vector<std::uint32_t>& to) const;

  /// Becomes the given rows of `from`, of the columns that are set in `mask` alone, in order.
  void project(const BitTable& from, std::span<const std::uint32_t> rows,
               std::span<const Word> mask);

 private:
  const BitLoops* loops_;
  std::size_t rows_ = 0;
  std::size_t columns_ = 0;
  std::size_t stride_ = 0;  ///< rows, rounded up to eight
  std::vector<Word> bits_;  ///< [words][stride]
};

/// `count` rounded up to the eight rows that BitTable::add_shared counts at once.
[[nodiscard]] constexpr std::size_t padded_rows(std::size_t count) noexcept {
  return (count + 7) / 8 * 8;
}

}  // namespace pacer::affordance
