// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/peers/visp_library.h"

#include <visp3/tt/vpTemplateTrackerSSDInverseCompositional.h>
#include <visp3/tt/vpTemplateTrackerWarpTranslation.h>

#include <opencv2/core.hpp>

namespace pacer::tracking {

struct VispLibrary::Impl {
  vpTemplateTrackerWarpTranslation warp;
  vpTemplateTrackerSSDInverseCompositional tracker{&warp};
  vpImage<unsigned char> image;

  void copy(const cv::Mat1b& grey) {
    image.resize(static_cast<unsigned>(grey.rows), static_cast<unsigned>(grey.cols));
    grey.copyTo(cv::Mat1b(grey.rows, grey.cols, image.bitmap));
  }
};

VispLibrary::VispLibrary() = default;
VispLibrary::~VispLibrary() = default;

void VispLibrary::start(const cv::Mat1b& grey, const cv::Rect& target) {
  impl_ = std::make_unique<Impl>();
  impl_->copy(grey);
  // Two triangles, of points by row and column.
  const vpImagePoint top_left(target.y, target.x);
  const vpImagePoint top_right(target.y, target.br().x - 1);
  const vpImagePoint low_left(target.br().y - 1, target.x);
  const vpImagePoint low_right(target.br().y - 1, target.br().x - 1);
  impl_->tracker.initFromPoints(impl_->image,
                                {top_left, top_right, low_right, top_left, low_right, low_left});
}

cv::Point2d VispLibrary::update(const cv::Mat1b& grey) {
  impl_->copy(grey);
  impl_->tracker.track(impl_->image);
  const vpColVector moved = impl_->tracker.getp();
  return {moved[0], moved[1]};
}

}  // namespace pacer::tracking
