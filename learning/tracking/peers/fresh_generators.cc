// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/peers/fresh_generators.h"

#include <cstdlib>
#include <opencv2/core.hpp>

namespace pacer::tracking {

FreshGenerators::FreshGenerators(std::uint64_t seed) : cv_(cv::RNG().state) {
  constexpr std::uint64_t kApart = 0x9E3779B97F4A7C15;  // the golden ratio: any two are far apart
  cv_ += kApart * (seed - 1);
  const auto rand_seed = static_cast<unsigned>(seed ^ (seed >> 32U));  // rand() itself begins at 1
  char* const process = initstate(rand_seed, rand_.data(), rand_.size());
  setstate(process);
}

FreshGenerators::Loan::Loan(FreshGenerators& generators)
    : generators_(generators),
      process_rand_(setstate(generators.rand_.data())),
      process_cv_(cv::theRNG().state) {
  cv::theRNG().state = generators_.cv_;
}

FreshGenerators::Loan::~Loan() {
  generators_.cv_ = cv::theRNG().state;
  cv::theRNG().state = process_cv_;
  setstate(process_rand_);
}

}  // namespace pacer::tracking
