// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/peers/peer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <opencv2/core.hpp>
#include <stdexcept>

#include "learning/tracking/peers/peers.h"

namespace pacer::tracking {
namespace {

/// A library that does what it is told.
class FakePeer : public Peer {
 public:
  enum class Does { kFind, kMiss, kThrow, kNonsense };
  Does does = Does::kFind;
  bool takes = true;
  int starts = 0;
  cv::Rect started_on;

 private:
  bool start_library(const Picture& /*picture*/, const cv::Rect& target) override {
    if (does == Does::kThrow) throw std::runtime_error("no texture");
    ++starts;
    started_on = target;
    return takes;
  }
  bool update_library(const Picture& /*picture*/, Box& target) override {
    if (does == Does::kThrow) throw std::runtime_error("an assertion");
    if (does == Does::kNonsense) target.width = std::numeric_limits<double>::quiet_NaN();
    if (does == Does::kFind) target.x += 1.0;
    return does != Does::kMiss;
  }
};

Picture plain() {
  Picture picture;
  to_picture(cv::Mat1b(60, 80, std::uint8_t{0}), picture);
  return picture;
}
const Box kTarget{20.0, 20.0, 9.0, 9.0};

TEST(Peer, IsHandedTheWholePixelsInThePicture) {
  FakePeer peer;
  peer.start(plain(), Box::of_pixels(-5.4, 50.6, 20.0, 40.0));
  EXPECT_EQ(peer.started_on, cv::Rect(0, 51, 15, 9));
}

TEST(Peer, FindsAgainWhatItsLibraryMissed) {
  FakePeer peer;
  peer.start(plain(), kTarget);
  EXPECT_EQ(peer.update(plain()).box.x, 21.0);
  peer.does = FakePeer::Does::kMiss;
  const Track missed = peer.update(plain());
  EXPECT_EQ(missed.confidence, 0.0);
  EXPECT_EQ(missed.box.x, 21.0);
  peer.does = FakePeer::Does::kFind;
  const Track found = peer.update(plain());
  EXPECT_EQ(found.confidence, 1.0);
  EXPECT_EQ(found.box.x, 22.0);
}

TEST(Peer, IsLostUntilStartedAgainOnceItsLibraryHasFailed) {
  for (const auto failure : {FakePeer::Does::kThrow, FakePeer::Does::kNonsense}) {
    FakePeer peer;
    peer.start(plain(), kTarget);
    peer.does = failure;
    EXPECT_EQ(peer.update(plain()).confidence, 0.0);
    peer.does = FakePeer::Does::kFind;
    const Track lost = peer.update(plain());
    EXPECT_EQ(lost.confidence, 0.0);
    EXPECT_EQ(lost.box, kTarget);
    peer.start(plain(), kTarget);
    EXPECT_EQ(peer.update(plain()).confidence, 1.0);
  }
}

TEST(Peer, RefusesToStartOnWhatItsLibraryDoesNotTake) {
  const auto refusal = [](FakePeer& peer, const Box& target) -> std::string {
    try {
      peer.start(plain(), target);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return {};
  };
  FakePeer peer;
  peer.takes = false;
  EXPECT_EQ(refusal(peer, kTarget),
            "its library cannot start on the 9 x 9 pixels of the box in the picture");
  peer.does = FakePeer::Does::kThrow;
  EXPECT_THAT(refusal(peer, kTarget), ::testing::HasSubstr("cannot start (no texture) on"));
  peer = {};
  EXPECT_THAT(refusal(peer, Box::of_pixels(79.6, 20.0, 9.0, 9.0)),  // rounds out of the picture
              ::testing::HasSubstr("the 0 x 9 pixels"));
  EXPECT_EQ(peer.starts, 0) << "a library gets no empty target";
}

TEST(Peers, AreNamedAsInTheTables) {
  std::vector<std::string> names;
  for (const TrackerKind& kind : peers()) {
    names.push_back(kind.name);
    EXPECT_FALSE(kind.about.empty());
  }
  std::vector<std::string> expected{"Boosting", "MIL", "KCF", "CSRT", "MOSSE", "MedianFlow", "TLD"};
#ifdef PACER_DLIB
  expected.emplace_back("dlib");
#endif
#ifdef PACER_VISP
  expected.emplace_back("ViSP SSD-IC");
#endif
  EXPECT_EQ(names, expected);
}

}  // namespace
}  // namespace pacer::tracking
