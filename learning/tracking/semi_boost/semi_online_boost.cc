// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/semi_boost/semi_online_boost.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "core/random.h"
#include "learning/tracking/semi_boost/first_picture.h"
#include "learning/tracking/semi_boost/offline_boosting.h"
#include "learning/tracking/semi_boost/online_boosting.h"
#include "learning/tracking/semi_boost/search.h"
#include "learning/tracking/whole_pixels.h"

namespace pacer::tracking {
namespace {

constexpr int kPriorPool = 500;
constexpr int kPriorRounds = 50;
constexpr int kLabelledPasses = 5;  // over the first picture's samples

class SemiOnlineBoost final : public Tracker {
 public:
  explicit SemiOnlineBoost(std::uint64_t seed) : seed_(seed) {}

 private:
  void begin(const Picture& picture, const Box& target) override {
    const Random random(seed_);
    online_.reset();
    patch_ = whole_pixels(target, picture.grey.size());
    box_ = target;
    from_patch_ = cv::Point2d(target.x - patch_.x, target.y - patch_.y);
    found_ = true;
    if (patch_.area() < 2) return;

    const FirstPicture samples(picture.grey, patch_, random.fork("samples"));
    if (samples.background().empty()) return;
    const ImageSize size{patch_.width, patch_.height};
    Random features = random.fork("prior");
    prior_ =
        boost(samples.targets(), samples.background(), size, kPriorPool, kPriorRounds, features);
    online_.emplace(size, random.fork("online"));
    image_.set(picture.grey);
    search_.reserve(picture.grey.size(), patch_.size());
    for (int pass = 0; pass < kLabelledPasses; ++pass) {
      const std::size_t pairs = std::max(samples.targets().size(), samples.background().size());
      for (std::size_t i = 0; i < pairs; ++i) {
        online_->learn_labelled(samples.targets()[i % samples.targets().size()], true);
        online_->learn_labelled(samples.background()[i % samples.background().size()], false);
      }
    }
  }

  Track follow(const Picture& picture) override {
    if (!online_) return {.box = box_, .confidence = 0.0};
    image_.set(picture.grey);
    const cv::Rect whole({}, picture.grey.size());
    const cv::Rect region = found_ ? twice(patch_) & whole : whole;
    const Found best = search_.best(online_->classifier(), image_, region, patch_.size());
    found_ = best.margin > 0.0F;
    if (!found_) return {.box = box_, .confidence = 0.0};

    patch_ = cv::Rect(best.at, patch_.size());
    box_.x = patch_.x + from_patch_.x;
    box_.y = patch_.y + from_patch_.y;
    const cv::Rect around = twice(patch_) & whole;
    for (const cv::Point& corner : corners(around, patch_.size())) {
      learn({.image = &image_, .left = corner.x, .top = corner.y});
      learn({.image = &image_, .left = patch_.x, .top = patch_.y});
    }
    return {.box = box_, .confidence = static_cast<double>(std::min(1.0F, best.margin))};
  }

  /// Nobody says whether a patch is the target: the prior and what has been learnt decide.
  void learn(const PatchAt& patch) {
    online_->learn_unlabelled(patch, static_cast<double>(prior_.margin(patch)));
  }

  std::uint64_t seed_;
  StrongClassifier prior_;
  std::optional<OnlineBooster> online_;  // none: nothing to follow
  PatchSearch search_;
  IntegralImage image_;
  cv::Rect patch_;          // where the target is, or was last seen
  cv::Point2d from_patch_;  // to the box's centre
  Box box_;
  bool found_ = false;
};

}  // namespace

std::unique_ptr<Tracker> make_semi_online_boost(std::uint64_t seed) {
  return std::make_unique<SemiOnlineBoost>(seed);
}

}  // namespace pacer::tracking
