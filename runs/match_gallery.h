// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/annotation.h"
#include "core/frame.h"
#include "learning/affordance/model.h"
#include "learning/affordance/perception.h"

namespace pacer {

/// Keeps, for each action type, the frame in which most of its rules matched, with the
/// configurations drawn in (Figure 6.14).
class MatchGallery {
 public:
  explicit MatchGallery(std::shared_ptr<const affordance::Model> model);

  void look(const Frame& frame);

  struct Picture {
    std::string action_type;
    int rules = 0;  ///< that matched
    std::string jpg;
  };
  /// One picture for each action type that matched at all.
  [[nodiscard]] std::vector<Picture> pictures() const;

 private:
  struct Best {
    int rules = 0;
    Frame frame;
    Annotations marks;
  };

  std::shared_ptr<const affordance::Model> model_;
  affordance::Perception perception_;
  std::vector<Best> best_;
};

}  // namespace pacer
