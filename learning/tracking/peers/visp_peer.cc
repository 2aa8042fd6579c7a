// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/peers/visp_peer.h"

#include <algorithm>

#include "learning/tracking/peers/peer.h"
#include "learning/tracking/peers/visp_library.h"

namespace pacer::tracking {
namespace {

class VispPeer final : public Peer {
 private:
  bool start_library(const Picture& picture, const cv::Rect& target) override {
    // ViSP blurs with a kernel of seven pixels, also where there are fewer.
    if (std::min(target.width, target.height) < 8) return false;
    start_ = Box::of_pixels(target.x, target.y, target.width, target.height);
    library_.start(picture.grey, target);
    return true;
  }

  bool update_library(const Picture& picture, Box& target) override {
    const cv::Point2d moved = library_.update(picture.grey);
    target = {start_.x + moved.x, start_.y + moved.y, start_.width, start_.height};
    return true;
  }

  VispLibrary library_;
  Box start_;
};

}  // namespace

std::unique_ptr<Tracker> make_visp(std::uint64_t /*seed*/) { return std::make_unique<VispPeer>(); }

}  // namespace pacer::tracking
