// SPDX-License-Identifier: Apache-2.0
#include "sim/renderer.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "core/check.h"

namespace pacer::sim {
namespace {

struct Delete {
  void operator()(mjSpec* spec) const { mj_deleteSpec(spec); }
  void operator()(mjModel* model) const { mj_deleteModel(model); }
  void operator()(mjData* data) const { mj_deleteData(data); }
};

constexpr ImageSize kSize{160, 120};
constexpr double kFovy = 50.0;  // degrees

/// A camera at (0, 0, 0.5) that looks along +x; self-lit red balls at `points`; a wall at x = 4,
/// blue above the camera's height and green below.
class RendererTest : public testing::Test {
 protected:
  void build(const std::vector<Eigen::Vector3d>& points) {
    std::unique_ptr<mjSpec, Delete> spec(mj_makeSpec());
    spec->stat.extent = 1.0;
    spec->visual.map.znear = 0.02F;
    spec->visual.map.zfar = 20.0F;
    mjsBody* const world = mjs_findBody(spec.get(), "world");
    mjsMaterial* const lit = mjs_addMaterial(spec.get(), nullptr);
    mjs_setName(lit->element, "lit");
    lit->emission = 1.0F;
    const auto add = [&](mjtGeom type, const Eigen::Vector3d& at, const Eigen::Vector3d& size,
                         const std::array<float, 3>& colour, int group) {
      mjsGeom* const geom = mjs_addGeom(world, nullptr);
      geom->type = type;
      geom->group = group;
      mjs_setString(geom->material, "lit");
      for (int i = 0; i < 3; ++i) {
        geom->pos[i] = at[i];
        geom->size[i] = size[i];
        geom->rgba[i] = colour.at(static_cast<std::size_t>(i));
      }
    };
    for (const auto& point : points) {
      add(mjGEOM_SPHERE, point, {0.04, 0.04, 0.04}, {1.0F, 0.0F, 0.0F}, 1);
    }
    add(mjGEOM_BOX, {4.5, 0.0, 5.5}, {0.5, 9.0, 5.0}, {0.0F, 0.0F, 1.0F}, 0);
    add(mjGEOM_BOX, {4.5, 0.0, -4.5}, {0.5, 9.0, 5.0}, {0.0F, 1.0F, 0.0F}, 0);
    add(mjGEOM_BOX, {1.0, 0.0, 0.5}, {0.1, 9.0, 9.0}, {1.0F, 1.0F, 1.0F}, 3);  // a proxy
    mjsCamera* const camera = mjs_addCamera(world, nullptr);
    mjs_setName(camera->element, "eye");
    camera->pos[2] = 0.5;
    camera->fovy = kFovy;
    camera->alt.type = mjORIENTATION_XYAXES;
    constexpr std::array<double, 6> kAlongX = {0.0, -1.0, 0.0, 0.0, 0.0, 1.0};
    std::ranges::copy(kAlongX, camera->alt.xyaxes);
    model.reset(mj_compile(spec.get(), nullptr));
    ASSERT_TRUE(model) << mjs_getError(spec.get());
    data.reset(mj_makeData(model.get()));
    mj_forward(model.get(), data.get());
  }

  /// The mean position (pixels, centres at .5) of what is red, and how many pixels are.
  static Eigen::Vector3d red(const Frame& frame) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int y = 0; y < frame.size.height; ++y) {
      for (int x = 0; x < frame.size.width; ++x) {
        const auto* const rgb = &frame.rgb[static_cast<std::size_t>(3 * (y * kSize.width + x))];
        if (rgb[0] > 150 && rgb[1] < 80 && rgb[2] < 80) sum += Eigen::Vector3d(x + 0.5, y + 0.5, 1);
      }
    }
    return {sum.x() / sum.z(), sum.y() / sum.z(), sum.z()};
  }

  std::unique_ptr<mjModel, Delete> model;
  std::unique_ptr<mjData, Delete> data;
  Frame frame;
};

TEST_F(RendererTest, PutsTheTopRowFirst) {
  build({});
  Renderer renderer(*model, "eye", kSize);
  renderer.render(*model, *data, frame);
  ASSERT_EQ(frame.size, kSize);
  ASSERT_EQ(frame.rgb.size(), 160U * 120U * 3U);
  EXPECT_GT(frame.rgb[2], 150);                     // blue above
  EXPECT_GT(frame.rgb[frame.rgb.size() - 2], 150);  // green below
}

TEST_F(RendererTest, DrawsAPointWhereThePinholeSaysItIs) {
  const double focal = 0.5 * kSize.height / std::tan(0.5 * kFovy * std::numbers::pi / 180.0);
  for (const Eigen::Vector3d& point :
       {Eigen::Vector3d(2.0, 0.0, 0.5), {1.5, 0.5, 0.7}, {2.5, -0.8, 0.1}, {1.2, 0.3, 0.3}}) {
    build({point});
    Renderer renderer(*model, "eye", kSize);
    renderer.render(*model, *data, frame);
    const Eigen::Vector3d seen = red(frame);
    ASSERT_GT(seen.z(), 3.0);
    EXPECT_NEAR(seen.x(), 80.0 - focal * point.y() / point.x(), 0.6);
    EXPECT_NEAR(seen.y(), 60.0 - focal * (point.z() - 0.5) / point.x(), 0.6);
  }
}

TEST_F(RendererTest, MeasuresDepthInMetresAlongTheAxis) {
  build({{2.0, 0.0, 0.5}});
  Renderer renderer(*model, "eye", kSize);
  std::vector<float> depth;
  renderer.render(*model, *data, frame, depth);
  ASSERT_EQ(depth.size(), 160U * 120U);
  EXPECT_NEAR(depth[60 * 160 + 80], 1.96, 0.01);
  for (const std::size_t corner : {0U, 159U, 119U * 160U, 119U * 160U + 159U}) {
    EXPECT_NEAR(depth[corner], 4.0, 0.01);  // not 4 over the cosine
  }
}

TEST_F(RendererTest, RepeatsByteForByte) {
  build({{1.5, 0.2, 0.6}});
  Renderer first(*model, "eye", kSize);
  first.render(*model, *data, frame);
  const std::vector<std::uint8_t> once = frame.rgb;
  Renderer second(*model, "eye", kSize);
  second.render(*model, *data, frame);
  EXPECT_EQ(frame.rgb, once);
  first.render(*model, *data, frame);
  EXPECT_EQ(frame.rgb, once);
}

TEST_F(RendererTest, ReusesTheFramesBuffer) {
  build({});
  Renderer renderer(*model, "eye", kSize);
  renderer.render(*model, *data, frame);
  const std::uint8_t* const buffer = frame.rgb.data();
  renderer.render(*model, *data, frame);
  EXPECT_EQ(frame.rgb.data(), buffer);
}

TEST_F(RendererTest, EveryQualityDraws) {
  build({{2.0, 0.0, 0.5}});
  for (const char* quality : {"fast", "fine", "best"}) {
    Renderer renderer(*model, "eye", kSize, {quality});
    renderer.render(*model, *data, frame);
    EXPECT_GT(red(frame).z(), 3.0) << quality;
  }
}

TEST_F(RendererTest, SaysWhatItDrawsWith) {
  build({});
  Renderer renderer(*model, "eye", kSize);
  EXPECT_FALSE(renderer.gl().path.empty());
  EXPECT_NE(renderer.gl().renderer, "unknown");
  EXPECT_NE(renderer.gl().version, "unknown");
}

TEST_F(RendererTest, RefusesACameraThatIsNotThere) {
  build({});
  EXPECT_THROW(Renderer(*model, "no such", kSize), UsageError);
}

TEST(RenderConfig, RefusesAnUnknownQuality) {
  EXPECT_THROW(RenderConfig{"pretty"}.validate(), std::invalid_argument);
  EXPECT_NO_THROW(RenderConfig{"best"}.validate());
}

}  // namespace
}  // namespace pacer::sim
