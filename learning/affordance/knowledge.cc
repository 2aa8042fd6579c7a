// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/knowledge.h"

#include <Eigen/LU>
#include <cmath>
#include <utility>

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
  // It takes none for less than a thousandth: that of a stick that nobody moved is not its own.
  constexpr double kMoved = 2e-3;
  const Eigen::Vector2d deviation = model.actions.whiten.inverse().rowwise().norm();
  std::size_t errors = 0;
  for (const auto& [row, stick] : {std::pair(0, &Command::steering), {1, &Command::throttle}}) {
    if (deviation[row] <= kMoved) continue;
    for (const Mapping& mapping : model.mappings) {
      knowledge.error += mapping.held_out.*stick / deviation[row];
      ++errors;
    }
  }
  if (errors > 0) knowledge.error /= static_cast<double>(errors);
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
