// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/peers/fresh_generators.h"

#include <cstdlib>
#include <opencv2/core.hpp>

namespace pacer::tracking {

FreshGenerators::FreshGenerators() : cv_(cv::RNG().state) {
  char* const process = initstate(1, rand_.data(), rand_.size());  // rand()'s seed unless told
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
