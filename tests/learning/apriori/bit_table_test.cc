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

  PlainTable(std::size_t row_count, std::size_t columns, Random& random)
      : rows(row_count, std::vector<bool>(columns)) {
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

TEST(BitTable, CountsTheBitsThatTwoRowsShare) {
  Random random(1);
  for (int trial = 0; trial < 50; ++trial) {
    const std::size_t columns = 1 + random.below(300);
    const PlainTable table(2 + random.below(40), columns, random);
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

TEST(BitTable, ProjectsTheAskedRowsOntoTheColumnsOfAMask) {
  Random random(2);
  for (int trial = 0; trial < 200; ++trial) {
    const std::size_t columns = 1 + random.below(400);
    const PlainTable table(2 + random.below(20), columns, random);
    std::vector<std::uint32_t> rows;
    for (std::uint32_t row = 0; row < table.rows.size(); ++row) {
      if (random.chance(0.5)) rows.push_back(row);
    }
    std::vector<BitTable::Word> mask;
    table.bits.copy_row(table.rows.size() - 1, mask);
    BitTable projected;
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
