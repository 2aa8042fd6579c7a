// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/peers/opencv_peer.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/tracking.hpp>
#include <opencv2/tracking/tracking_legacy.hpp>
#include <optional>

#include "learning/tracking/peers/fresh_generators.h"
#include "learning/tracking/peers/peer.h"

namespace pacer::tracking {
namespace {

// What OpenCV would hang or crash on is not handed to it.

bool fits_any(const cv::Rect& /*target*/, const cv::Size& /*picture*/) { return true; }

/// Boosting and MIL draw Haar-like features of nine pixels and more until one fits.
bool fits_haar(const cv::Rect& target, const cv::Size& /*picture*/) {
  return std::min(target.width, target.height) >= 8;
}

/// MIL counts the places around the target without a sign.
bool fits_mil(const cv::Rect& target, const cv::Size& picture) {
  return fits_haar(target, picture) && target.width + 2 <= picture.width &&
         target.height + 2 <= picture.height;
}

/// TLD enlarges the picture until the target's shorter side is 20 pixels, and then draws from a
/// grid of windows of the target's size (a tenth of it apart) until it has 300 that hardly overlap
/// the target. The grid's corners are farthest from the target.
bool fits_tld(const cv::Rect& target, const cv::Size& picture) {
  if (!fits_haar(target, picture)) return false;  // that is enlarged enough
  const double to_window = 20.0 / std::min(target.width, target.height);
  const double scale = std::max(1.0, to_window);
  const int columns = cvRound(picture.width * scale);
  const int rows = cvRound(picture.height * scale);
  const double width = std::floor(target.width * to_window);
  const double height = std::floor(target.height * to_window);
  // It compares width with rows.
  if (std::max(width, height) >= std::min(columns, rows) - 1) return false;
  const auto last = [](double room, double side) {
    return std::floor(room / (0.1 * side)) * 0.1 * side;
  };
  const Box scaled = Box::of_pixels(target.x * scale, target.y * scale, target.width * scale,
                                    target.height * scale);
  for (const double x : {0.0, last(columns - width - 1.0, width)}) {
    for (const double y : {0.0, last(rows - height - 1.0, height)}) {
      if (overlap(scaled, Box::of_pixels(x, y, width, height)) < 0.19) return true;
    }
  }
  return false;
}

enum class Input : std::uint8_t { kGrey, kColour };

/// One of OpenCV's trackers, with its default parameters.
struct Library {
  cv::Ptr<cv::legacy::Tracker> (*make)();
  Input input;
  bool (*fits)(const cv::Rect& target, const cv::Size& picture);
};

class OpencvPeer final : public Peer {
 public:
  OpencvPeer(const Library& library, std::uint64_t seed) : library_(library), seed_(seed) {}

 private:
  bool start_library(const Picture& picture, const cv::Rect& target) override {
    if (!library_.fits(target, picture.grey.size())) return false;
    generators_.emplace(seed_);
    const FreshGenerators::Loan loan(*generators_);
    tracker_ = library_.make();
    return tracker_->init(input(picture), target);
  }

  bool update_library(const Picture& picture, Box& target) override {
    const FreshGenerators::Loan loan(*generators_);
    cv::Rect2d found;
    if (!tracker_->update(input(picture), found)) return false;
    target = Box::of_pixels(found.x, found.y, found.width, found.height);
    return true;
  }

  [[nodiscard]] const cv::Mat& input(const Picture& picture) const {
    if (library_.input == Input::kGrey) return picture.grey;
    return picture.bgr;
  }

  Library library_;
  std::uint64_t seed_;
  std::optional<FreshGenerators> generators_;
  cv::Ptr<cv::legacy::Tracker> tracker_;
};

template <class Kind>
std::unique_ptr<Tracker> make_peer(std::uint64_t seed, Input input,
                                   bool (*fits)(const cv::Rect& target, const cv::Size& picture)) {
  const auto make = []() -> cv::Ptr<cv::legacy::Tracker> { return Kind::create(); };
  return std::make_unique<OpencvPeer>(Library{.make = make, .input = input, .fits = fits}, seed);
}

}  // namespace

namespace legacy = cv::legacy;

// Boosting and TLD make grey of what they are given, but take colour only. MIL reads the first
// channel, blue: people hand it colour. MOSSE and MedianFlow work on grey.
std::unique_ptr<Tracker> make_boosting(std::uint64_t seed) {
  return make_peer<legacy::TrackerBoosting>(seed, Input::kColour, fits_haar);
}
std::unique_ptr<Tracker> make_mil(std::uint64_t seed) {
  return make_peer<legacy::TrackerMIL>(seed, Input::kColour, fits_mil);
}
std::unique_ptr<Tracker> make_kcf(std::uint64_t seed) {
  return make_peer<legacy::TrackerKCF>(seed, Input::kColour, fits_any);
}
std::unique_ptr<Tracker> make_csrt(std::uint64_t seed) {
  return make_peer<legacy::TrackerCSRT>(seed, Input::kColour, fits_any);
}
std::unique_ptr<Tracker> make_mosse(std::uint64_t seed) {
  return make_peer<legacy::TrackerMOSSE>(seed, Input::kGrey, fits_any);
}
std::unique_ptr<Tracker> make_median_flow(std::uint64_t seed) {
  return make_peer<legacy::TrackerMedianFlow>(seed, Input::kGrey, fits_any);
}
std::unique_ptr<Tracker> make_tld(std::uint64_t seed) {
  return make_peer<legacy::TrackerTLD>(seed, Input::kColour, fits_tld);
}

}  // namespace pacer::tracking
