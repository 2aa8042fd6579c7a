// SPDX-License-Identifier: Apache-2.0
#include "learning/baselines/nearest.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/random.h"

namespace pacer::baselines {
namespace {

PictureTable draw(std::size_t count, std::size_t pixels, std::uint64_t seed, int levels = 255) {
  Random random(seed);
  PictureTable table{.pixels = pixels, .values = std::vector<std::int8_t>(count * pixels)};
  for (std::int8_t& value : table.values) {
    value = static_cast<std::int8_t>(
        static_cast<int>(random.below(static_cast<std::uint64_t>(levels))) - levels / 2);
  }
  return table;
}

TEST(Nearest, IsWhatSortingAllDistancesGives) {
  const PictureTable table = draw(500, 37, 1);
  const PictureTable asked = draw(20, 37, 2);
  for (const std::size_t most :
       {std::size_t{1}, std::size_t{7}, std::size_t{499}, std::size_t{600}}) {
    Nearest nearest(most);
    for (std::size_t q = 0; q < asked.size(); ++q) {
      std::vector<Nearest::Neighbour> all;
      for (std::size_t i = 0; i < table.size(); ++i) {
        double sum = 0.0;
        for (std::size_t p = 0; p < 37; ++p) {
          sum += std::pow(
              static_cast<double>(table.picture(i)[p]) - static_cast<double>(asked.picture(q)[p]),
              2.0);
        }
        all.push_back(
            {.distance = static_cast<std::int32_t>(sum), .index = static_cast<std::uint32_t>(i)});
      }
      std::ranges::stable_sort(all, {}, &Nearest::Neighbour::distance);
      all.resize(std::min(most, all.size()));
      const auto found = nearest.search(table, asked.picture(q));
      EXPECT_TRUE(std::ranges::equal(found, all)) << most << " of question " << q;
    }
  }
}

TEST(Nearest, AmongEqualsTakesTheFirst) {
  const PictureTable table = draw(300, 3, 3, 3);  // 27 pictures, many times each
  Nearest nearest(40);
  const auto found = nearest.search(table, table.picture(0));
  for (std::size_t i = 1; i < found.size(); ++i) {
    EXPECT_LE(found[i - 1].distance, found[i].distance);
    if (found[i - 1].distance == found[i].distance) {
      EXPECT_LT(found[i - 1].index, found[i].index);
    }
  }
}

TEST(Nearest, StepsAreRoundedAndClamped) {
  const std::vector<float> values = {0.0F, 1.0F, -1.0F, 0.02F, 100.0F, -100.0F};
  std::vector<std::int8_t> steps(values.size());
  quantise(values, steps);
  EXPECT_EQ(steps, (std::vector<std::int8_t>{0, 32, -32, 1, 127, -127}));
}

}  // namespace
}  // namespace pacer::baselines
