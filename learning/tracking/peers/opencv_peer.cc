// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/peers/opencv_peer.h"

#include <algorithm>
#include <cstdlib>
#include <opencv2/core.hpp>
#include <opencv2/tracking.hpp>
#include <opencv2/tracking/tracking_legacy.hpp>

#include "core/random.h"
#include "learning/tracking/peers/peer.h"

namespace pacer::tracking {
namespace {

using Library = cv::Ptr<cv::legacy::Tracker>;
enum class Input { kGrey, kColour };

class OpencvPeer final : public Peer {
 public:
  OpencvPeer(Library (*make)(), Input input, std::uint64_t seed)
      : make_(make), input_(input), seed_(seed), chance_(seed) {}

 private:
  bool start_library(const Picture& picture, const cv::Rect& target) override {
    library_ = make_();
    chance_ = Random(seed_).fork("peer");
    set_generators();
    return library_->init(input(picture), target);
  }

  bool update_library(const Picture& picture, Box& target) override {
    cv::Rect2d found;
    set_generators();
    if (!library_->update(input(picture), found)) return false;
    target = Box::of_pixels(found.x, found.y, found.width, found.height);
    return true;
  }

  [[nodiscard]] const cv::Mat& input(const Picture& picture) const {
    return input_ == Input::kGrey ? static_cast<const cv::Mat&>(picture.grey) : picture.bgr;
  }

  /// OpenCV's trackers draw from rand() and cv::theRNG(), which the whole process shares and from
  /// which nothing of ours draws. Set anew for each call, they give every tracker its own stream,
  /// whatever ran in between.
  void set_generators() {
    std::srand(static_cast<unsigned>(chance_.next()));
    cv::theRNG().state = chance_.next();
  }

  Library (*make_)();
  Input input_;
  std::uint64_t seed_;
  Random chance_;
  Library library_;
};

template <class Kind>
Library make_library() {
  return Kind::create();
}

}  // namespace

namespace legacy = cv::legacy;

std::unique_ptr<Tracker> make_boosting(std::uint64_t seed) {
  return std::make_unique<OpencvPeer>(make_library<legacy::TrackerBoosting>, Input::kColour, seed);
}
std::unique_ptr<Tracker> make_mil(std::uint64_t seed) {
  return std::make_unique<OpencvPeer>(make_library<legacy::TrackerMIL>, Input::kGrey, seed);
}
std::unique_ptr<Tracker> make_kcf(std::uint64_t seed) {
  return std::make_unique<OpencvPeer>(make_library<legacy::TrackerKCF>, Input::kColour, seed);
}
std::unique_ptr<Tracker> make_csrt(std::uint64_t seed) {
  return std::make_unique<OpencvPeer>(make_library<legacy::TrackerCSRT>, Input::kColour, seed);
}
std::unique_ptr<Tracker> make_mosse(std::uint64_t seed) {
  return std::make_unique<OpencvPeer>(make_library<legacy::TrackerMOSSE>, Input::kGrey, seed);
}
std::unique_ptr<Tracker> make_median_flow(std::uint64_t seed) {
  return std::make_unique<OpencvPeer>(make_library<legacy::TrackerMedianFlow>, Input::kGrey, seed);
}
std::unique_ptr<Tracker> make_tld(std::uint64_t seed) {
  return std::make_unique<OpencvPeer>(make_library<legacy::TrackerTLD>, Input::kColour, seed);
}

}  // namespace pacer::tracking
