// SPDX-License-Identifier: Apache-2.0
#include "studies/trials.h"

#include <numeric>

#include "runs/worker_pool.h"
#include "studies/materials.h"

namespace pacer {

std::vector<nlohmann::json> run_trials(
    const StudyContext& context, std::uint32_t count, std::string_view what,
    const std::function<nlohmann::json(std::uint32_t index)>& trial) {
  std::vector<std::uint32_t> indices(count);
  std::iota(indices.begin(), indices.end(), 0U);
  std::vector<nlohmann::json> results;
  const auto tick = [&] { context.control.progress(results.size(), count, what); };
  const bool whole = run_in_workers(
      context.control.jobs, indices,
      [&](std::uint32_t index) {
        const std::vector<std::uint8_t> packed = nlohmann::json::to_cbor(trial(index));
        return std::string(packed.begin(), packed.end());
      },
      [&](std::uint32_t, const std::string& packed) {
        results.push_back(nlohmann::json::from_cbor(packed.begin(), packed.end()));
      },
      context.control.stop, tick);
  if (!whole) throw StudyStopped();
  tick();
  return results;
}

std::shared_ptr<const affordance::Model> responding(const affordance::Model& model,
                                                    const affordance::ResponseConfig& response) {
  affordance::Model changed = model;
  changed.config.response = response;
  changed.config.response.validate();
  return std::make_shared<const affordance::Model>(std::move(changed));
}

}  // namespace pacer
