// SPDX-License-Identifier: Apache-2.0
#include "runs/model_kinds.h"

#include <algorithm>
#include <array>

#include "learning/affordance/policy_model.h"
#include "learning/baselines/nearest_model.h"
#include "learning/baselines/ridge_model.h"
#include "learning/baselines/supervised_model.h"
#include "learning/baselines/tracker_model.h"
#include "learning/exemplar/policy_model.h"
#include "runs/model_description.h"

namespace pacer {
namespace {

template <class Model>
const std::string& scenario_of(const Model& model) {
  if constexpr (requires { model.origin; }) {
    return model.origin.scenario;
  } else {
    return model.scenario;
  }
}

/// A kind of file that holds a `Model`, which drives as an `Adaptor`.
template <class Model, class Adaptor, Model (*kRead)(std::string_view, std::string_view)>
ModelKind kind() {
  return {
      .file = Model::kFile,
      .read = [](std::string_view bytes,
                 std::string_view source) -> std::shared_ptr<const PolicyModel> {
        return std::make_shared<const Adaptor>(std::make_shared<const Model>(kRead(bytes, source)));
      },
      .describe =
          [](const PolicyModel& model) {
            return describe(*static_cast<const Adaptor&>(model).model());
          },
      .scenario = [](const PolicyModel& model) -> const std::string& {
        return scenario_of(*static_cast<const Adaptor&>(model).model());
      }};
}

const auto& kinds() {
  using namespace baselines;
  static const std::array all = {
      kind<affordance::Model, affordance::AffordancePolicyModel, affordance::from_bytes>(),
      kind<exemplar::Model, exemplar::ExemplarPolicyModel, exemplar::from_bytes>(),
      kind<SupervisedModel, SupervisedPolicyModel, supervised_from_bytes>(),
      kind<NearestModel, NearestPolicyModel, nearest_from_bytes>(),
      kind<RidgeModel, RidgePolicyModel, ridge_from_bytes>(),
      kind<TrackerModel, TrackerPolicyModel, tracker_from_bytes>()};
  return all;
}

}  // namespace

LoadedModel read_model(std::string_view bytes, std::string_view source) {
  const auto found = std::ranges::find_if(
      kinds(), [&](const ModelKind& kind) { return bytes.starts_with(kind.file.magic); });
  if (found == kinds().end()) {
    throw std::runtime_error(std::string(source) + ": not a model; `pacer train` makes one");
  }
  return {.kind = &*found, .model = found->read(bytes, source)};
}

LoadedModel load_model(const std::filesystem::path& file) {
  return read_model(read_model_file(file), file.string());
}

}  // namespace pacer
