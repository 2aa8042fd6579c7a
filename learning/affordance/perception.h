// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/annotation.h"
#include "core/frame.h"
#include "learning/affordance/model.h"

namespace pacer::affordance {

/// One rule matched by one configuration, and the action it predicts (6.4).
struct Vote {
  std::uint32_t rule = 0;
  std::uint32_t centre = 0;  ///< the configuration's feature
  float tile_side = 0.0F;    ///< pixels, of the configuration's grid
  Command action;
};

/// Where to look (6.6.2); everywhere by default.
struct SearchRegion {
  float x = 0.0F, y = 0.0F;  ///< pixels
  float range = -1.0F;  ///< pixels around (x, y), of configurations' centres; below 0: everywhere

  [[nodiscard]] bool holds(float px, float py) const noexcept {
    return range < 0.0F || (px - x) * (px - x) + (py - y) * (py - y) <= range * range;
  }
};

/// How long the stages of one response took.
struct ResponseTimes {
  Seconds features{};  ///< of every kind
  Seconds words{};
  Seconds matching{};  ///< configurations, subset tests, mappings, median
  [[nodiscard]] Seconds total() const noexcept { return features + words + matching; }
};

/// What a model makes of one frame. Holds buffers: one a thread. The model must outlive it.
class Perception {
 public:
  explicit Perception(const Model& model);

  /// Finds the features of `frame` and their words. Throws std::runtime_error when the frame's
  /// size is not the demonstration's.
  void look(const Frame& frame);
  /// Takes features from elsewhere instead, e.g. recorded ones.
  void look(const Features& features);

  /// Matches the configurations whose centres lie in `region`. The votes live until the next call,
  /// ordered by centre.
  std::span<const Vote> match(const SearchRegion& region = {});

  [[nodiscard]] const Features& features() const noexcept { return features_; }
  [[nodiscard]] const Words& words() const noexcept { return words_; }
  [[nodiscard]] const ResponseTimes& times() const noexcept { return times_; }

 private:
  void predict(const Configuration& configuration, std::size_t rule);

  const Model& model_;
  ItemLayout layout_;
  FeatureExtractor extractor_;
  Features features_;
  Words words_;
  Configuration configuration_;
  std::vector<Vote> votes_;
  ResponseTimes times_;
};

/// The distinct features that the items of a vote's rule name, ascending; the centre is not among
/// them. `scratch` and `named` are the caller's buffers; `named` is replaced.
void named_features(const Model& model, const Perception& perception, const Vote& vote,
                    Configuration& scratch, std::vector<std::uint16_t>& named);

/// One rule matched in a frame, with what to draw and to score.
struct MatchedRule {
  std::size_t rule = 0;  ///< index into the model's rules
  ActionType type = 0;
  PixelPoint centre;
  float tile_side = 0.0F;  ///< pixels
  std::vector<PixelPoint>
      points;      ///< the distinct features that the rule's items name, centre aside
  Command action;  ///< what its mapping predicts
};

/// Every rule that matches in the frame that `perception` looked at last (Table 6.1, Figure 6.14).
[[nodiscard]] std::vector<MatchedRule> matched_rules(const Model& model, Perception& perception);

}  // namespace pacer::affordance
