// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/peers/visp_library.h"

#include <visp3/tt/vpTemplateTrackerSSDInverseCompositional.h>
#include <visp3/tt/vpTemplateTrackerWarpSRT.h>
#include <visp3/tt/vpTemplateTrackerWarpTranslation.h>

#include <opencv2/core.hpp>
#include <vector>
#include <cstdlib>

namespace pacer::tracking {

struct VispLibrary::Impl {
  vpTemplateTrackerWarpSRT s;
  vpTemplateTrackerWarpTranslation t;
  vpTemplateTrackerWarp& warp = *( getenv("V_TR") ? static_cast<vpTemplateTrackerWarp*>(&t) : &s);
  vpTemplateTrackerSSDInverseCompositional tracker{&warp};
  vpImage<unsigned char> image;
  cv::Point2d centre;

  void copy(const cv::Mat& grey) {
    image.resize(static_cast<unsigned>(grey.rows), static_cast<unsigned>(grey.cols));
    grey.copyTo(cv::Mat(grey.size(), CV_8UC1, image.bitmap));
  }
};

VispLibrary::VispLibrary() = default;
VispLibrary::~VispLibrary() = default;

void VispLibrary::start(const cv::Mat& grey, const cv::Rect& target) {
  impl_ = std::make_unique<Impl>();
  const double left = target.x;
  const double top = target.y;
  const double right = target.br().x - 1.0;
  const double bottom = target.br().y - 1.0;
  impl_->centre = {0.5 * (left + right), 0.5 * (top + bottom)};
  impl_->copy(grey);
  // Two triangles; ViSP's points are rows and columns.
  impl_->tracker.initFromPoints(impl_->image, {{top, left}, {top, right}, {bottom, right}, {top, left}, {bottom, right}, {bottom, left}});
}

void VispLibrary::update(const cv::Mat& grey, cv::Point2d& centre, double& scale) {
  impl_->copy(grey);
  impl_->tracker.track(impl_->image);
  const vpColVector p = impl_->tracker.getp();
  vpColVector before(2);
  before[0] = impl_->centre.x;
  before[1] = impl_->centre.y;
  vpColVector after(2);
  impl_->warp.computeDenom(before, p);
  impl_->warp.warpX(before, after, p);
  centre = {after[0], after[1]};
  scale = p.size()>2?1.0 + p[0]:1;
}

}  // namespace pacer::tracking
