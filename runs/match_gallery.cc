// SPDX-License-Identifier: Apache-2.0
#include "runs/match_gallery.h"

#include "runs/report/draw.h"
#include "runs/report/picture.h"

namespace pacer {
namespace {

/// Marks one matched configuration: its centre, and lines to the features that the rule names.
void mark(const affordance::MatchedRule& match, Annotations& marks) {
  constexpr float kRadius = 2.5F;
  marks.points.push_back({.at = match.centre, .radius = kRadius, .tone = Tone::kTarget});
  for (const PixelPoint& point : match.points) {
    marks.lines.push_back({.from = match.centre, .to = point, .tone = Tone::kMatched});
    marks.points.push_back({.at = point, .radius = kRadius, .tone = Tone::kMatched});
  }
}

}  // namespace

MatchGallery::MatchGallery(std::shared_ptr<const affordance::Model> model)
    : model_(std::move(model)),
      perception_(*model_),
      best_(static_cast<std::size_t>(model_->actions.count())) {}

void MatchGallery::look(const Frame& frame) {
  perception_.look(frame);
  const std::vector<affordance::MatchedRule> matches =
      affordance::matched_rules(*model_, perception_);
  std::vector<int> counts(best_.size());
  for (const affordance::MatchedRule& match : matches) ++counts[match.type];
  for (std::size_t type = 0; type < best_.size(); ++type) {
    if (counts[type] <= best_[type].rules) continue;
    best_[type] = {.rules = counts[type], .frame = frame, .marks = {}};
    for (const affordance::MatchedRule& match : matches) {
      if (match.type == type) mark(match, best_[type].marks);
    }
  }
}

std::vector<MatchGallery::Picture> MatchGallery::pictures() const {
  std::vector<Picture> pictures;
  for (std::size_t type = 0; type < best_.size(); ++type) {
    if (best_[type].rules == 0) continue;
    Frame drawn;
    report::draw(best_[type].frame, best_[type].marks, drawn);
    const std::vector<std::uint8_t> jpg = report::encode_jpeg(drawn);
    pictures.push_back({.action_type = model_->actions.names[type],
                        .rules = best_[type].rules,
                        .jpg = std::string(jpg.begin(), jpg.end())});
  }
  return pictures;
}

}  // namespace pacer
