// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/config.h"

#include <stdexcept>
#include <string>
#include <type_traits>

#include "core/check.h"

namespace pacer::tracking {

void PredictorConfig::validate() const {
  require(support_pixels >= 1 && support_pixels <= 4096, "support_pixels: must be 1 to 4096");
  require(samples >= 2 && samples <= 4096, "samples: must be 2 to 4096");
  require(support_range >= 0.0 && support_range <= 500.0, "support_range: must be 0 to 500 pixels");
  require(training_range >= 1.0 && training_range <= 500.0,
          "training_range: must be 1 to 500 pixels");
  // With less, single precision could not tell a system of more samples than pixels from a
  // singular one.
  require(ridge >= 1e-5 && ridge <= 1e3, "ridge: must be 0.00001 to 1000");
}

void RegistrationConfig::validate() const {
  require(most_steps >= 1 && most_steps <= 1000, "most_steps: must be 1 to 1000");
  require(damping > 0.0 && damping <= 1e3, "damping: must be above 0, and 1000 at most");
}

void SmatConfig::validate() const {
  require(components >= 1 && components <= 100, "components: must be 1 to 100");
  require(templates >= 2 && templates <= 1000, "templates: must be 2 to 1000");
  require(learning_rate > 0.0 && learning_rate <= 1.0,
          "learning_rate: must be above 0, and 1 at most");
}

void MedoidshiftConfig::validate() const {
  require(templates >= 2 && templates <= 256, "templates: must be 2 to 256");
  require(fewest >= 2 && fewest <= templates, "fewest: must be 2 to the number of templates");
  require(quantile > 0.0 && quantile < 1.0, "quantile: must be between 0 and 1");
}

void TrackingConfig::validate() const {
  // Every section in turn; the message gains the section's name.
  TrackingConfig copy = *this;
  copy.fields([](const char* name, auto& section) {
    if constexpr (std::is_class_v<std::remove_reference_t<decltype(section)>>) {
      validate_section(name, section);
    }
  });
  require(template_pixels >= 4 && template_pixels <= 16384, "template_pixels: must be 4 to 16384");
  require(registered_pixels >= 4 && registered_pixels <= 16384,
          "registered_pixels: must be 4 to 16384");
  require(flock_predictors >= 1, "flock_predictors: must be at least 1");
  require(smat_predictors >= smat.components,
          "smat_predictors: must be at least one for each component");
  require(med_predictors >= 1, "med_predictors: must be at least 1");
  require(forgetting > 0.0 && forgetting <= 1.0, "forgetting: must be above 0, and 1 at most");
}

}  // namespace pacer::tracking
