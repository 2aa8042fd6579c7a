// SPDX-License-Identifier: Apache-2.0
#include "studies/chapter5.h"

#include <cmath>

#include "dataset/demonstration.h"
#include "studies/materials.h"

namespace pacer::chapter5 {

exemplar::DemonstratedExemplars demonstrated(const StudyContext& context,
                                             std::uint64_t demonstrations) {
  const dataset::RecordedDemonstration demonstration(
      Materials(context).recording(Purpose::kCollect, demonstrations));
  TrainingOptions options;
  options.stop = context.control.stop;
  return exemplar::exemplars_of(demonstration, context.scenario.exemplar.percept, options);
}

double prediction_error(std::span<const double> predicted, std::span<const double> expected) {
  constexpr double kPercent = 100.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    squares += (predicted[i] - expected[i]) * (predicted[i] - expected[i]);
  }
  return kPercent * std::sqrt(squares);
}

std::vector<double> taus(double first, double last, double step) {
  std::vector<double> values;
  for (int i = 0; first + step * i <= last + 1e-9; ++i) values.push_back(first + step * i);
  return values;
}

}  // namespace pacer::chapter5
