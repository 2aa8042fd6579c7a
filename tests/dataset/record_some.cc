// SPDX-License-Identifier: Apache-2.0
// record_some FOLDER N: records made-up episodes until there are N. Takes up what is there.
#include <cstdio>
#include <string>

#include "tests/dataset/recording.h"

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  pacer::dataset::testing::record_dataset(argv[1], pacer::dataset::testing::small_spec(),
                                          std::stoll(argv[2]), 20);
  return 0;
}
