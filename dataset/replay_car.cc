// SPDX-License-Identifier: Apache-2.0
#include "dataset/replay_car.h"

#include <algorithm>

namespace pacer::dataset {
namespace {

/// What the loop or the format adds to every recording is no signal of the car.
std::vector<SignalColumn> signals_in(const DatasetInfo& info) {
  const std::vector<Feature> common = DatasetSpec{}.features();
  std::vector<SignalColumn> signals;
  for (const Feature& feature : info.features) {
    if (std::ranges::find(common, feature.name, &Feature::name) != common.end()) continue;
    SignalColumn& signal = signals.emplace_back();
    signal.name = feature.name;
    signal.components = feature.components;
    while (signal.components.size() < feature.width) {
      signal.components.push_back(std::to_string(signal.components.size()));
    }
    signal.components.resize(feature.width);
  }
  return signals;
}

std::vector<std::string> names_of(const std::vector<SignalColumn>& columns) {
  std::vector<std::string> names;
  for (const SignalColumn& column : columns) names.push_back(column.name);
  return names;
}

}  // namespace

ReplayCar::ReplayCar(const Dataset& dataset, std::size_t episode)
    : columns_(signals_in(dataset.info())), reader_(dataset, episode, names_of(columns_)) {}

const Frame* ReplayCar::look() {
  const RecordedStep* step = reader_.next();
  if (step == nullptr) return nullptr;
  values_.clear();
  for (const double value : step->values) values_.push_back(static_cast<float>(value));
  return step->frame;
}

}  // namespace pacer::dataset
