// SPDX-License-Identifier: Apache-2.0
#include "studies/chapter5.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <variant>

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

Split draw_split(std::size_t count, double share, Random random) {
  std::vector<std::size_t> shuffled(count);
  std::iota(shuffled.begin(), shuffled.end(), std::size_t{0});
  for (std::size_t i = count; i > 1; --i) std::swap(shuffled[i - 1], shuffled[random.below(i)]);
  const auto middle = shuffled.begin() +
                      static_cast<std::ptrdiff_t>(std::lround(share * static_cast<double>(count)));
  return {.trained = {shuffled.begin(), middle}, .held_out = {middle, shuffled.end()}};
}

double plateau_start(std::span<const double> taus, std::span<const double> errors) {
  constexpr double kFlat = 1.05;
  for (std::size_t t = 0; t < taus.size(); ++t) {
    const std::span<const double> from = errors.subspan(t);
    const double mean =
        std::accumulate(from.begin(), from.end(), 0.0) / static_cast<double>(from.size());
    if (*std::ranges::max_element(from) <= kFlat * mean) return taus[t];
  }
  return taus.back();
}

double level(std::span<const double> taus, std::span<const double> errors, double start) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t t = 0; t < taus.size(); ++t) {
    if (taus[t] < start) continue;
    sum += errors[t];
    ++count;
  }
  return sum / count;
}

double spread_within(std::span<const float> values, std::size_t width, std::size_t column,
                     std::span<const std::size_t> labels) {
  const std::size_t clusters = *std::ranges::max_element(labels) + 1;
  const auto scatter = [&](std::size_t from, std::size_t to) {
    double count = 0.0;
    double mean = 0.0;
    double sum = 0.0;
    for (std::size_t n = 0; n < labels.size(); ++n) {
      if (labels[n] < from || labels[n] >= to) continue;
      const auto value = static_cast<double>(values[n * width + column]);
      count += 1.0;
      const double off = value - mean;
      mean += off / count;
      sum += off * (value - mean);
    }
    return sum;
  };
  double within = 0.0;
  for (std::size_t c = 0; c < clusters; ++c) within += scatter(c, c + 1);
  return within / scatter(0, clusters);
}

ImpulseRatio impulses_over(const PolicyEvaluation& policy, const PolicyEvaluation& teacher) {
  double impulses = 0.0;
  double of_teacher = 0.0;
  ImpulseRatio ratio;
  for (std::size_t i = 0; i < policy.episodes.size(); ++i) {
    const auto& one = std::get<ReachingResult>(policy.episodes[i]);
    const auto& other = std::get<ReachingResult>(teacher.episodes[i]);
    if (!one.reached || !other.reached) continue;
    impulses += one.impulses;
    of_teacher += other.impulses;
    ++ratio.shared;
  }
  ratio.over = ratio.shared == 0 ? std::numeric_limits<double>::infinity() : impulses / of_teacher;
  return ratio;
}

std::vector<double> taus(double first, double last, double step) {
  std::vector<double> values;
  for (int i = 0; first + step * i <= last + 1e-9; ++i) values.push_back(first + step * i);
  return values;
}

}  // namespace pacer::chapter5
