// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/config.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace pacer::tracking {
namespace {

TEST(TrackingConfigs, AreTable42UnlessToldOtherwise) {
  const TrackingConfig config;
  config.validate();
  EXPECT_EQ(config.predictor.support_range, 20.0);
  EXPECT_EQ(config.predictor.training_range, 30.0);
  EXPECT_EQ(config.predictor.support_pixels, 150);
  EXPECT_EQ(config.predictor.samples, 100);
  EXPECT_EQ(config.smat_predictors, 160);
  EXPECT_EQ(config.med_predictors, 80);
  EXPECT_EQ(config.smat.components, 4);
  EXPECT_EQ(config.medoidshift.templates, 200);
  EXPECT_EQ(config.smat.learning_rate, 0.2);
  EXPECT_EQ(config.forgetting, 0.1);
  EXPECT_EQ(config.smat.templates, 60);    // 4.2.1
  EXPECT_EQ(config.flock_predictors, 60);  // 4.4
}

TEST(TrackingConfigs, NameTheFieldThatMakesNoSense) {
  const auto message = [](const auto& change) -> std::string {
    TrackingConfig config;
    change(config);
    try {
      config.validate();
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message([](auto& config) { config.predictor.support_pixels = 5000; }),
            "predictor.support_pixels: must be 1 to 4096");
  EXPECT_EQ(message([](auto& config) { config.smat.templates = 1; }),
            "smat.templates: must be 2 to 1000");
  EXPECT_EQ(message([](auto& config) { config.template_pixels = 0; }),
            "template_pixels: must be 4 to 16384");
  EXPECT_EQ(message([](auto& config) { config.smat_predictors = 3; }),
            "smat_predictors: must be at least one for each component");
  EXPECT_EQ(message([](auto& config) { config.forgetting = 0.0; }),
            "forgetting: must be above 0, and 1 at most");
}

}  // namespace
}  // namespace pacer::tracking
