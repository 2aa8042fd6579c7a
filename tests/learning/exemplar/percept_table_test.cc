// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/percept_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "core/random.h"

namespace pacer::exemplar {
namespace {

TEST(PerceptTable, GrownOneByOneIsTheOneThatIsBuilt) {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    // Few percepts and few actions: leaves that share percepts are cut again and again.
    Random random(seed);
    const auto number = [&] { return static_cast<double>(random.below(2 + seed)); };
    Exemplars exemplars(2, 2, {number(), 1.0}, {number(), number()});
    ActionTree tree(exemplars);
    PerceptTable grown(exemplars, tree);
    for (int n = 1; n < 120; ++n) {
      const std::vector<double> percept = {number(), number()};
      exemplars.add(percept, std::vector<double>{number() + 0.5 * number(), number()});
      grown.add(exemplars, tree, tree.insert(exemplars));
      const PerceptTable built(exemplars, tree);
      for (std::size_t k = 0; k < exemplars.size(); ++k) {
        ASSERT_TRUE(std::ranges::equal(grown.candidates(exemplars.percept(k)),
                                       built.candidates(exemplars.percept(k))))
            << seed << ' ' << n;
      }
    }
  }
}

}  // namespace
}  // namespace pacer::exemplar
