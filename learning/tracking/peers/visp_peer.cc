// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/peers/visp_peer.h"

#include "learning/tracking/peers/peer.h"
#include "learning/tracking/peers/visp_library.h"

namespace pacer::tracking {
namespace {

class VispPeer final : public Peer {
 private:
  bool start_library(const Picture& picture, const cv::Rect& target) override {
    size_ = target.size();
    library_.start(picture.grey, target);
    return true;
  }

  bool update_library(const Picture& picture, Box& target) override {
    cv::Point2d centre;
    double scale = 1.0;
    library_.update(picture.grey, centre, scale);
    target = {centre.x, centre.y, scale * size_.width, scale * size_.height};
    return true;
  }

  VispLibrary library_;
  cv::Size2d size_;
};

}  // namespace

std::unique_ptr<Tracker> make_visp(std::uint64_t /*seed*/) { return std::make_unique<VispPeer>(); }

}  // namespace pacer::tracking
