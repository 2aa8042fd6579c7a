// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/bit_table.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/random.h"

namespace pacer::affordance {
namespace {

/// The same table as plain values.
struct PlainTable {
  std::vector<std::vector<bool>> rows;
  BitTable bits;

  PlainTable(std::size_t row_count, std::size_t columns, const BitLoops& loops, Random& random)
      : rows(row_count, std::vector<bool>(columns)), bits(loops) {
    bits.reset(row_count, columns);
    const double density = random.uniform(0.0, 1.0);
    for (std::size_t row = 0; row < row_count; ++row) {
      for (std::size_t column = 0; column < columns; ++column) {
        if (!random.chance(density)) continue;
        rows[row][column] = true;
        bits.set(row, column);
      }
    }
  }
};

/// With each kind of loop that this processor has.
class BitTables : public ::testing::TestWithParam<std::size_t> {};
INSTANTIATE_TEST_SUITE_P(OfEachKind, BitTables, ::testing::Range<std::size_t>(0, bit_loop_count()));

TEST_P(BitTables, CountsTheBitsThatTwoRowsShare) {
  Random random(1);
  for (int trial = 0; trial < 50; ++trial) {
    const std::size_t columns = 1 + random.below(trial % 5 == 0 ? 5000 : 300);
    const PlainTable table(2 + random.below(90), columns, bit_loops(GetParam()), random);
    const std::size_t row = 1 + random.below(table.rows.size() - 1);
    std::vector<BitTable::Word> mask;
    table.bits.copy_row(row, mask);
    std::vector<std::uint32_t> counts(padded_rows(row));
    const std::size_t middle = random.below(mask.size() + 1);
    table.bits.add_shared(mask, 0, middle, row, counts);
    table.bits.add_shared(mask, middle, mask.size(), row, counts);
    for (std::size_t other = 0; other < row; ++other) {
      std::uint32_t expected = 0;
      for (std::size_t column = 0; column < columns; ++column) {
        if (table.rows[row][column] && table.rows[other][column]) ++expected;
      }
      ASSERT_EQ(counts[other], expected);
    }
  }
}

TEST_P(BitTables, SelectsTheRowsOfEnoughCount) {
  Random random(3);
  for (int trial = 0; trial < 200; ++trial) {
    const PlainTable table(100, 1, bit_loops(GetParam()), random);
    const std::size_t rows = 1 + random.below(99);
    std::vector<std::uint32_t> counts(padded_rows(rows));
    for (std::uint32_t& count : counts) {
      count = random.chance(0.8) ? 0 : static_cast<std::uint32_t>(random.below(6) << 30);
    }
    std::vector<std::uint32_t> expected;
    for (std::uint32_t row = 0; row < rows; ++row) {
      if (counts[row] >= 3U << 30) expected.push_back(row);
    }
    std::vector<std::uint32_t> selected = {1, 2, 3};
    table.bits.select_rows(counts, 3U << 30, rows, selected);
    ASSERT_EQ(selected, expected);
  }
}

TEST_P(BitTables, ProjectsTheAskedRowsOntoTheColumnsOfAMask) {
  Random random(2);
  for (int trial = 0; trial < 200; ++trial) {
    const std::size_t columns = 1 + random.below(400);
    const PlainTable table(2 + random.below(20), columns, bit_loops(GetParam()), random);
    std::vector<std::uint32_t> rows;
    for (std::uint32_t row = 0; row < table.rows.size(); ++row) {
      if (random.chance(0.5)) rows.push_back(row);
    }
    std::vector<BitTable::Word> mask;
    table.bits.copy_row(table.rows.size() - 1, mask);
    BitTable projected(bit_loops(GetParam()));
    projected.reset(3, 1000);  // what was there before does not matter
    projected.project(table.bits, rows, mask);
    ASSERT_EQ(projected.rows(), rows.size());
    std::size_t column = 0;
    for (std::size_t from = 0; from < columns; ++from) {
      if (!table.rows.back()[from]) continue;
      for (std::size_t row = 0; row < rows.size(); ++row) {
        ASSERT_EQ(projected.word(row, column / 64) >> (column % 64) & 1,
                  table.rows[rows[row]][from] ? 1U : 0U);
      }
      ++column;
    }
    ASSERT_EQ(projected.columns(), column);
  }
}

}  // namespace
}  // namespace pacer::affordance
