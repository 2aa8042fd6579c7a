// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <utility>
#include <vector>

#include "sim/room.h"
#include "sim/sequences/scenes.h"
#include "sim/sequences/simulated_sequence.h"

// What is claimed of the simulated sequences, measured on what is rendered.
namespace pacer::sim {
namespace {

using SceneMaker = Scene (*)(const Random&);

const std::map<std::string, SceneMaker> kScenes = {{"car-surveillance", car_surveillance},
                                                   {"face-hand", face_hand},
                                                   {"runner", runner},
                                                   {"head-motion", head_motion},
                                                   {"camera-shake", camera_shake}};

const SimulatedSequence& sequence(const std::string& name) {
  return *std::ranges::find(simulated_sequences(), name, &SimulatedSequence::name);
}

/// The stage of a sequence, without the bodies (and all that hangs on them) of these names.
Stage stage_without(const std::string& name, const std::vector<std::string>& bodies) {
  const Random random = Random(1).fork(name);
  Scene scene = kScenes.at(name)(random);
  const auto hide = [bodies](Stage& stage) {
    const mjModel& model = stage.model();
    for (int geom = 0; geom < model.ngeom; ++geom) {
      const int root = model.body_rootid[model.geom_bodyid[geom]];
      const char* const body = mj_id2name(&model, mjOBJ_BODY, root);
      const char* const called = mj_id2name(&model, mjOBJ_GEOM, geom);
      if (body == nullptr || called == nullptr) continue;
      const bool dark = std::string(called).ends_with("_shadow");  // is not the target's
      if (dark || std::ranges::find(bodies, body) != bodies.end()) stage.show(called, false);
    }
  };
  scene.act = [act = std::move(scene.act), hide](Stage& stage, double frame) {
    act(stage, frame);
    hide(stage);
  };
  return {std::move(scene), sequence(name).size, random};
}

cv::Mat picture(Stage& stage, double frame) {
  Frame taken;
  stage.expose(frame, taken);
  return cv::Mat(taken.size.height, taken.size.width, CV_8UC3, taken.rgb.data()).clone();
}

/// Where two pictures differ by more than what averaging and rounding make.
cv::Mat changed(const cv::Mat& one, const cv::Mat& other) {
  cv::Mat difference;
  cv::absdiff(one, other, difference);
  std::vector<cv::Mat> channels;
  cv::split(difference, channels);
  return cv::max(cv::max(channels[0], channels[1]), channels[2]) > 24;
}

Box box_about(const cv::Mat& mask) {
  const cv::Rect box = cv::boundingRect(mask);
  return Box::of_pixels(box.x, box.y, box.width, box.height);
}

class Sequences : public testing::TestWithParam<std::string> {};

TEST_P(Sequences, KeepTheTargetInThePicture) {
  const SimulatedSequence& one = sequence(GetParam());
  Stage stage = stage_without(one.name, {});
  for (int i = 0; i < one.frames; ++i) {
    stage.go_to(i);
    const Box truth = stage.truth();
    ASSERT_GE(truth.left(), 0.0) << i;
    ASSERT_GE(truth.top(), 0.0) << i;
    ASSERT_LE(truth.left() + truth.width, one.size.width) << i;
    ASSERT_LE(truth.top() + truth.height, one.size.height) << i;
  }
}

TEST_P(Sequences, RepeatByteForByteAndLookOtherwiseForAnotherSeed) {
  const auto first_two = [&](std::uint64_t seed) {
    std::vector<std::pair<std::vector<std::uint8_t>, Box>> frames;
    EXPECT_FALSE(render_sequence(sequence(GetParam()), seed,
                                 [&frames](const Frame& frame, const Box& truth) {
                                   EXPECT_EQ(frame.index, frames.size());
                                   frames.emplace_back(frame.rgb, truth);
                                   return frames.size() < 2;
                                 }));
    return frames;
  };
  const auto once = first_two(1);
  ASSERT_EQ(once.size(), 2U) << "the sink ends it";
  EXPECT_EQ(first_two(1), once);
  const auto other = first_two(2);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NE(other[i].first, once[i].first);
    EXPECT_LT(centre_distance(other[i].second, once[i].second), 1e-6) << "the same happens";
  }
}

INSTANTIATE_TEST_SUITE_P(All, Sequences,
                         testing::Values("car-surveillance", "face-hand", "runner", "head-motion",
                                         "camera-shake"),
                         [](const auto& one) {
                           std::string name = one.param;
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

TEST(SimulatedSequences, AreAfterTheThesiss) {
  std::vector<std::pair<std::string, int>> all;
  for (const SimulatedSequence& one : simulated_sequences()) all.emplace_back(one.name, one.frames);
  EXPECT_EQ(all, (std::vector<std::pair<std::string, int>>{{"car-surveillance", 282},
                                                           {"face-hand", 1000},
                                                           {"runner", 420},
                                                           {"head-motion", 600},
                                                           {"camera-shake", 500}}));
}

TEST(SimulatedSequences, BeginWithBoxesOfTheThesissSizes) {
  const std::map<std::string, std::pair<double, double>> sizes = {
      {"car-surveillance", {40.0, 20.0}},
      {"face-hand", {130.0, 130.0}},
      {"runner", {38.0, 126.0}},
      {"head-motion", {90.0, 100.0}},
      {"camera-shake", {25.0, 25.0}}};
  for (const auto& [name, size] : sizes) {
    Stage stage = stage_without(name, {});
    stage.go_to(0.0);
    EXPECT_NEAR(stage.truth().width / size.first, 1.0, 0.1) << name;
    EXPECT_NEAR(stage.truth().height / size.second, 1.0, 0.1) << name;
  }
}

/// The truth against the box about the pixels that change when the target is taken away.
struct Held {
  Box truth;
  Box seen;
};
std::vector<Held> compare(const std::string& name, const std::vector<double>& frames,
                          std::vector<std::string> also = {}) {
  Stage with = stage_without(name, also);
  also.emplace_back(Scene::kTarget);
  Stage without = stage_without(name, also);
  std::vector<Held> all;
  for (const double frame : frames) {
    const cv::Mat there = picture(with, frame);
    all.push_back({with.truth(), box_about(changed(there, picture(without, frame)))});
  }
  return all;
}
void expect_same(const Held& held, double pixels) {
  EXPECT_NEAR(held.seen.left(), held.truth.left(), pixels);
  EXPECT_NEAR(held.seen.top(), held.truth.top(), pixels);
  EXPECT_NEAR(held.seen.width, held.truth.width, 2.0 * pixels);
  EXPECT_NEAR(held.seen.height, held.truth.height, 2.0 * pixels);
}

TEST(SimulatedTruth, IsTheBoxAboutTheCar) {
  for (const Held& held : compare("car-surveillance", {0, 45, 100, 160, 230, 281})) {
    expect_same(held, 1.5);
  }
}

TEST(SimulatedTruth, IsTheBoxAboutTheHead) {
  for (const Held& held : compare("head-motion", {0, 76, 150, 228, 440, 520}, {"torso"})) {
    expect_same(held, 2.5);
  }
}

TEST(SimulatedTruth, IsTheBoxAboutTheKeys) {
  for (const Held& held : compare("camera-shake", {0, 66, 133, 230})) expect_same(held, 1.5);
}

TEST(SimulatedTruth, IsTheFaceInTheMiddleOfTheHead) {
  for (const Held& held : compare("face-hand", {0, 240, 402}, {"torso", "glasses"})) {
    EXPECT_LT(std::abs(held.truth.x - held.seen.x), 0.1 * held.seen.width);
    EXPECT_GT(held.truth.width, 0.75 * held.seen.width);
    EXPECT_LT(held.truth.width, held.seen.width);
    EXPECT_NEAR(held.truth.top() + held.truth.height, held.seen.top() + held.seen.height, 6.0)
        << "both end at the chin";
    EXPECT_GT(held.truth.top(), held.seen.top() + 15.0) << "below the hair";
  }
}

TEST(SimulatedTruth, IsAboutTheAthleteFromHeadToFoot) {
  for (const Held& held : compare("runner", {0, 55, 140, 260, 350, 419})) {
    const double tall = held.truth.height;
    EXPECT_NEAR(held.seen.top(), held.truth.top(), 0.08 * tall);
    EXPECT_NEAR(held.seen.top() + held.seen.height, held.truth.top() + tall, 0.08 * tall);
    EXPECT_LT(std::abs(held.seen.x - held.truth.x), 0.25 * held.truth.width);
  }
}

TEST(CameraShake, JumpsThirtySevenPixelsWhereTheThesissDoes) {
  Stage stage = stage_without("camera-shake", {});
  std::vector<Box> truth;
  for (int i = 0; i < sequence("camera-shake").frames; ++i) {
    stage.go_to(i);
    truth.push_back(stage.truth());
  }
  std::vector<double> steps;
  for (std::size_t i = 0; i + 1 < truth.size(); ++i) {
    steps.push_back(centre_distance(truth[i], truth[i + 1]));
  }
  const auto largest = std::ranges::max_element(steps);
  EXPECT_EQ(largest - steps.begin(), 374);
  EXPECT_NEAR(*largest, 37.0, 1.0);
  EXPECT_NEAR(truth[375].x - truth[374].x, 33.0, 0.5);
  EXPECT_NEAR(truth[375].y - truth[374].y, 16.0, 0.5);
  EXPECT_LT(*std::max_element(steps.begin(), steps.begin() + 279), 4.0) << "calm before 280";
  EXPECT_GT(*std::max_element(steps.begin() + 280, steps.begin() + 300), 15.0);
}

TEST(CameraShake, HasTheTruthOfTheMiddleOfTheExposure) {
  Stage stage = stage_without("camera-shake", {});
  (void)picture(stage, 375.0);
  const Box exposed = stage.truth();
  stage.go_to(375.0);
  EXPECT_EQ(exposed, stage.truth());
}

TEST(CameraShake, BlursThePictureWhileItIsShaken) {
  Stage stage = stage_without("camera-shake", {});
  const auto sharpness = [&stage](double frame) {
    const cv::Mat taken = picture(stage, frame);
    const Box keys = stage.truth();
    cv::Mat grey;
    cv::cvtColor(taken, grey, cv::COLOR_RGB2GRAY);
    cv::Mat edges;
    cv::Laplacian(grey, edges, CV_32F);
    cv::Scalar mean;
    cv::Scalar deviation;
    cv::meanStdDev(edges(cv::Rect(static_cast<int>(keys.left()), static_cast<int>(keys.top()),
                                  static_cast<int>(keys.width), static_cast<int>(keys.height))),
                   mean, deviation);
    return deviation[0];
  };
  EXPECT_LT(sharpness(375.0), 0.5 * sharpness(270.0));
}

/// What bodies hide of the target.
class Cover {
 public:
  Cover(const std::string& name, const std::vector<std::string>& covers)
      : whole_(stage_without(name, {})), bare_(stage_without(name, covers)), neither_([&] {
          std::vector<std::string> all = covers;
          all.emplace_back(Scene::kTarget);
          return stage_without(name, all);
        }()) {}

  /// Their share of what would be seen in the box of the truth.
  double share(double frame) {
    const cv::Mat bare = picture(bare_, frame);
    const Box truth = bare_.truth();
    cv::Mat target = cv::Mat::zeros(bare.size(), CV_8U);
    target(cv::Rect(static_cast<int>(truth.left()), static_cast<int>(truth.top()),
                    static_cast<int>(truth.width), static_cast<int>(truth.height))) = 255;
    target &= changed(bare, picture(neither_, frame));
    const cv::Mat covered = changed(picture(whole_, frame), bare) & target;
    return static_cast<double>(cv::countNonZero(covered)) / cv::countNonZero(target);
  }

 private:
  Stage whole_;
  Stage bare_;
  Stage neither_;
};

TEST(HeadMotion, IsBehindTheMugForAHundredFrames) {
  Cover mug("head-motion", {"mug", "hand"});
  for (const double frame : {300.0, 350.0, 399.0}) EXPECT_GT(mug.share(frame), 0.15) << frame;
  for (const double frame : {290.0, 410.0}) EXPECT_LT(mug.share(frame), 0.002) << frame;
}

TEST(FaceHand, IsPassedOverFrom203To223) {
  Cover hand("face-hand", {"passing"});
  EXPECT_GT(hand.share(213.0), 0.5);
  for (const double frame : {203.0, 223.0}) EXPECT_GT(hand.share(frame), 0.02) << frame;
  for (const double frame : {201.0, 226.0}) EXPECT_LT(hand.share(frame), 0.002) << frame;
}

TEST(FaceHand, LosesItsGlassesAt364) {
  Cover glasses("face-hand", {"glasses"});
  for (const double frame : {340.0, 364.0}) EXPECT_GT(glasses.share(frame), 0.02) << frame;
  EXPECT_LT(glasses.share(385.0), 0.002);
}

}  // namespace
}  // namespace pacer::sim
