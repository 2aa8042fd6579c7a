// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/knowledge.h"

#include <Eigen/LU>
#include <cmath>

namespace pacer::affordance {

Knowledge knowledge_of(const Model& model) {
  Knowledge knowledge;
  knowledge.types = model.actions.count();
  knowledge.rules = model.rules.size();
  std::vector<char> known(static_cast<std::size_t>(knowledge.types), 0);
  for (const Rule& rule : model.rules) known[rule.type] = 1;
  for (const char type : known) knowledge.known_types += type;
  if (model.frames_learnt > 0) {
    knowledge.matched =
        static_cast<double>(model.frames_matched) / static_cast<double>(model.frames_learnt);
  }
  // Whitening undoes the commands' deviations: those are the lengths of the rows of its inverse.
  const Eigen::Matrix2d spread = model.actions.whiten.inverse();
  const double steering = spread.row(0).norm();
  const double throttle = spread.row(1).norm();
  for (const Mapping& mapping : model.mappings) {
    knowledge.error +=
        0.5 * (mapping.residual.steering / steering + mapping.residual.throttle / throttle);
  }
  if (!model.mappings.empty()) knowledge.error /= static_cast<double>(model.mappings.size());
  return knowledge;
}

std::string to_text(const Knowledge& knowledge) {
  const auto percent = [](double share) { return std::to_string(std::lround(100.0 * share)); };
  return std::string(knowledge.little() ? "knows little: " : "knows ") +
         std::to_string(knowledge.known_types) + " of " + std::to_string(knowledge.types) +
         " action types by " + std::to_string(knowledge.rules) + " rules, which match in " +
         percent(knowledge.matched) + " % of the pictures learnt from and are " +
         percent(knowledge.error) + " % of the commands' deviation off" +
         (knowledge.little() ? "; demonstrate more, with the target in view" : "");
}

}  // namespace pacer::affordance
