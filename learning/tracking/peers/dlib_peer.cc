// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/peers/dlib_peer.h"

#include <dlib/image_processing/correlation_tracker.h>
#include <dlib/image_transforms/fhog.h>
#include <dlib/opencv/cv_image.h>

#include "learning/tracking/peers/peer.h"

namespace pacer::tracking {
namespace {

class DlibPeer final : public Peer {
 private:
  bool start_library(const Picture& picture, const cv::Rect& target) override {
    library_ = dlib::correlation_tracker();
    // Both corners belong to the rectangle.
    library_.start_track(view(picture), dlib::drectangle(target.x, target.y, target.br().x - 1.0,
                                                         target.br().y - 1.0));
    return true;
  }

  bool update_library(const Picture& picture, Box& target) override {
    library_.update(view(picture));
    const dlib::drectangle found = library_.get_position();
    target = Box::of_pixels(found.left(), found.top(), found.width(), found.height());
    return true;
  }

  static dlib::cv_image<dlib::bgr_pixel> view(const Picture& picture) {
    return dlib::cv_image<dlib::bgr_pixel>(picture.bgr);
  }

  dlib::correlation_tracker library_;
};

}  // namespace

std::unique_ptr<Tracker> make_dlib(std::uint64_t /*seed*/) { return std::make_unique<DlibPeer>(); }

}  // namespace pacer::tracking
