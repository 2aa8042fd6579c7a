// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "sim/livery.h"
#include "sim/renderer.h"
#include "sim/room.h"

// What a camera at a car's height finds to look at.
namespace pacer::sim {
namespace {

constexpr ImageSize kSize{320, 240};

class Scenery : public testing::TestWithParam<std::string> {
 protected:
  /// A room with the lead in its middle and a camera that can be put anywhere.
  void SetUp() override {
    spec_ = mj_makeSpec();
    RoomConfig config;
    config.kinds = {GetParam()};
    plan_ = build_room(*spec_, config, Random(5));
    mjsBody* const world = mjs_findBody(spec_, "world");
    mjsBody* const lead = mjs_addBody(world, nullptr);
    lead->mocap = 1;
    dress_lead(*spec_, *lead, Random(5));
    mjsBody* const rig = mjs_addBody(world, nullptr);
    rig->mocap = 1;
    mjsCamera* const camera = mjs_addCamera(rig, nullptr);
    mjs_setName(camera->element, "eye");
    camera->fovy = 59.8;
    camera->alt.type = mjORIENTATION_XYAXES;
    constexpr std::array<double, 6> kAlongX = {0.0, -1.0, 0.0, 0.0, 0.0, 1.0};
    std::ranges::copy(kAlongX, camera->alt.xyaxes);
    model_ = mj_compile(spec_, nullptr);
    ASSERT_NE(model_, nullptr) << mjs_getError(spec_);
    data_ = mj_makeData(model_);
    mj_forward(model_, data_);
    renderer_ = std::make_unique<Renderer>(*model_, "eye", kSize);
  }
  void TearDown() override {
    renderer_.reset();
    mj_deleteData(data_);
    mj_deleteModel(model_);
    mj_deleteSpec(spec_);
  }

  void place(int mocap, double x, double y, double z, double yaw) {
    mju_copy3(data_->mocap_pos + 3 * mocap, std::array<mjtNum, 3>{x, y, z}.data());
    mju_copy4(data_->mocap_quat + 4 * mocap,
              std::array<mjtNum, 4>{std::cos(0.5 * yaw), 0.0, 0.0, std::sin(0.5 * yaw)}.data());
  }

  cv::Mat grey() {
    mj_kinematics(model_, data_);
    mj_camlight(model_, data_);
    renderer_->render(*model_, *data_, frame_);
    cv::Mat picture;
    cv::cvtColor(cv::Mat(kSize.height, kSize.width, CV_8UC3, frame_.rgb.data()), picture,
                 cv::COLOR_RGB2GRAY);
    return picture;
  }

  std::vector<cv::KeyPoint> features(const cv::Mat& picture) {
    std::vector<cv::KeyPoint> found;
    cv::SIFT::create()->detect(picture, found);
    return found;
  }

  mjSpec* spec_ = nullptr;
  mjModel* model_ = nullptr;
  mjData* data_ = nullptr;
  std::unique_ptr<Renderer> renderer_;
  RoomPlan plan_;
  Frame frame_;
};

TEST_P(Scenery, IsAsRichAsAPhotograph) {
  place(0, 50.0, 0.0, 0.0, 0.0);  // the lead is elsewhere
  Random random(8);
  std::vector<std::size_t> counts;
  for (int i = 0; i < 25; ++i) {
    place(1, random.uniform(-1.8, 1.8), random.uniform(-1.4, 1.4), 0.16, random.uniform(-3.1, 3.1));
    counts.push_back(features(grey()).size());
  }
  std::ranges::sort(counts);
  EXPECT_GE(counts[12], 250U);
  EXPECT_LE(counts[12], 800U);
}

TEST_P(Scenery, ShowsALeadWithFeaturesOnEverySide) {
  place(1, -0.205 - 1.0, 0.0, 0.16, 0.0);
  for (const double yaw : {0.0, 1.5708, 3.1416, -1.5708}) {
    place(0, 0.0, 0.0, 0.0, yaw);
    const cv::Mat with = grey();
    place(0, 50.0, 0.0, 0.0, 0.0);
    cv::Mat body;
    cv::absdiff(with, grey(), body);
    const cv::Rect box = cv::boundingRect(body > 6);
    const auto all = features(with);
    const auto on_body = std::ranges::count_if(
        all, [&box](const cv::KeyPoint& one) { return box.contains(cv::Point(one.pt)); });
    EXPECT_GE(on_body, 25) << "turned by " << yaw;
  }
}

INSTANTIATE_TEST_SUITE_P(All, Scenery, testing::ValuesIn(room_kinds()),
                         [](const auto& kind) { return kind.param; });

}  // namespace
}  // namespace pacer::sim
