// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/peers/peers.h"

#include "learning/tracking/peers/opencv_peer.h"
#ifdef PACER_DLIB
#include "learning/tracking/peers/dlib_peer.h"
#endif
#ifdef PACER_VISP
#include "learning/tracking/peers/visp_peer.h"
#endif

namespace pacer::tracking {

const std::vector<TrackerKind>& peers() {
  static const std::vector<TrackerKind> kinds{
      {"Boosting", "OpenCV's Online-Boost (Grabner et al. 2006): features boosted on line",
       make_boosting},
      {"MIL", "OpenCV's multiple-instance learning (Babenko et al. 2009)", make_mil},
      {"KCF", "OpenCV's kernelised correlation filter (Henriques et al. 2015)", make_kcf},
      {"CSRT",
       "OpenCV's discriminative correlation filter with channel and spatial reliability "
       "(Lukezic et al. 2017)",
       make_csrt},
      {"MOSSE", "OpenCV's minimum output sum of squared error filter (Bolme et al. 2010)",
       make_mosse},
      {"MedianFlow", "OpenCV's median of optical flow, forward and backward (Kalal et al. 2010)",
       make_median_flow},
      {"TLD", "OpenCV's tracking, learning and detection (Kalal et al. 2012)", make_tld},
#ifdef PACER_DLIB
      {"dlib", "dlib's correlation filter with scale (Danelljan et al. 2014)", make_dlib},
#endif
#ifdef PACER_VISP
      {"ViSP SSD-IC", "ViSP's Lucas-Kanade, inverse compositional", make_visp},
#endif
  };
  return kinds;
}

}  // namespace pacer::tracking
