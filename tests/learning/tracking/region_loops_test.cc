// SPDX-License-Identifier: Apache-2.0
// Patches, features and transforms, with each kind of loops that this processor can run: the
// numbers are those of plain loops, to the bit.
#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "core/random.h"
#include "learning/tracking/gradient_features.h"
#include "learning/tracking/patch_loops.h"
#include "learning/tracking/spectrum_loops.h"
#include "tests/learning/tracking/texture.h"

namespace pacer::tracking {
namespace {

class RegionLoops : public ::testing::TestWithParam<std::size_t> {};
INSTANTIATE_TEST_SUITE_P(OfEachKind, RegionLoops,
                         ::testing::Range<std::size_t>(0, processor_kinds()));

template <class T>
void expect_same(const std::vector<T>& a, const std::vector<T>& b) {
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(T)), 0);
}

/// Values in every cell, also in those between rows.
FeatureMap any_map(std::uint64_t seed) {
  Random random(seed);
  FeatureMap map;
  for (ComplexLanes& cell : map.cells) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      cell.re[lane] = static_cast<float>(random.uniform(-1.0, 1.0));
      cell.im[lane] = static_cast<float>(random.uniform(-1.0, 1.0));
    }
  }
  return map;
}

std::vector<float> numbers_of(const FeatureMap& map) {
  std::vector<float> numbers;
  for (std::size_t i = 0; i < kGrid * kGrid; ++i) {
    const ComplexLanes& cell = map.cells[i / kGrid * FeatureMap::kStride + i % kGrid];
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      numbers.push_back(cell.re[lane]);
      numbers.push_back(cell.im[lane]);
    }
  }
  return numbers;
}

TEST_P(RegionLoops, HalvePicturesOfAnySizeAlike) {
  Random random(1);
  for (int i = 0; i < 60; ++i) {
    const auto width = static_cast<int>(random.uniform(1, 90));
    const auto height = static_cast<int>(random.uniform(1, 20));
    const cv::Mat1b image = texture({width + 3, height}, static_cast<std::uint64_t>(i), 1.0);
    const auto size = static_cast<std::size_t>((width + 1) / 2 * ((height + 1) / 2));
    std::vector<std::uint8_t> halved(size),
        paired(2 * static_cast<std::size_t>(width + 1) * static_cast<std::size_t>(height));
    std::vector<std::uint8_t> plain_halved = halved;
    std::vector<std::uint8_t> plain_paired = paired;
    const auto stride = static_cast<std::ptrdiff_t>(image.step);
    patch_loops(GetParam()).halve(image.data, stride, width, height, halved.data());
    patch_loops(0).halve(image.data, stride, width, height, plain_halved.data());
    expect_same(halved, plain_halved);
    patch_loops(GetParam()).pair(image.data, stride, width, height, paired.data());
    patch_loops(0).pair(image.data, stride, width, height, plain_paired.data());
    expect_same(paired, plain_paired);
  }
}

TEST_P(RegionLoops, AverageFourPixelsAndRepeatTheBorder) {
  const std::vector<std::uint8_t> picture = {10, 20,  30,  // three wide
                                             50, 60,  70,  //
                                             90, 100, 200};
  std::vector<std::uint8_t> half(4);
  patch_loops(GetParam()).halve(picture.data(), 3, 3, 3, half.data());
  EXPECT_EQ(half, (std::vector<std::uint8_t>{35, 50, 95, 200}));
}

TEST_P(RegionLoops, SampleAlikeAndNeverBeyondThePicture) {
  Random random(2);
  const cv::Mat1b image = texture({53, 37}, 3, 2.0);
  std::vector<std::uint8_t> pairs(2 * 54 * 37);
  patch_loops(0).pair(image.data, static_cast<std::ptrdiff_t>(image.step), 53, 37, pairs.data());
  const float no_number = std::numeric_limits<float>::quiet_NaN();
  for (int i = 0; i < 100; ++i) {
    Walk walk{.x = static_cast<float>(random.uniform(-60.0, 100.0)),
              .y = static_cast<float>(random.uniform(-60.0, 100.0)),
              .du = static_cast<float>(random.uniform(-3.0, 3.0)),
              .dv = i % 10 == 0 ? no_number : static_cast<float>(random.uniform(-3.0, 3.0)),
              .last_x = 52.0F,
              .last_y = 36.0F,
              .pairs = pairs.data(),
              .stride = 54};
    std::vector<float> samples(20 * 2 * kLanes);
    std::vector<float> plain = samples;
    patch_loops(GetParam()).sample(walk, 20, 2, samples.data());
    patch_loops(0).sample(walk, 20, 2, plain.data());
    if (walk.dv == walk.dv) expect_same(samples, plain);
  }
}

TEST_P(RegionLoops, DescribeAlike) {
  const cv::Mat1b image = texture({300, 260}, 4, 3.0);
  const Similarity pose{.x = 150.0, .y = 130.0, .scale = 1.3, .angle = 0.2};
  RegionPyramid pyramid;
  Patch patch(GradientFeatures::kSide);
  pyramid.take(image, pose, patch.side, 1.0);
  pyramid.sample(pose, patch);
  FeatureMap map, plain;
  GradientFeatures(GetParam()).describe(patch, map);
  GradientFeatures(0).describe(patch, plain);
  expect_same(numbers_of(map), numbers_of(plain));
}

TEST_P(RegionLoops, TransformAlike) {
  const SpectrumLoops& loops = spectrum_loops(GetParam());
  const CellRange range{.first_row = 5, .last_row = 19, .first_column = 3, .last_column = 30};
  const FeatureMap other = any_map(2);
  FeatureMap map = any_map(1);
  FeatureMap plain = map;
  loops.forward(map.cells.data(), range);
  spectrum_loops(0).forward(plain.cells.data(), range);
  expect_same(numbers_of(map), numbers_of(plain));

  std::vector<std::complex<float>> sums(kGrid * kGrid);
  std::vector<std::complex<float>> plain_sums = sums;
  loops.products(map.cells.data(), other.cells.data(), sums.data());
  spectrum_loops(0).products(plain.cells.data(), other.cells.data(), plain_sums.data());
  expect_same(sums, plain_sums);

  loops.multiply(sums.data(), other.cells.data(), map.cells.data());
  spectrum_loops(0).multiply(sums.data(), other.cells.data(), plain.cells.data());
  loops.blend(map.cells.data(), other.cells.data(), 0.3F);
  spectrum_loops(0).blend(plain.cells.data(), other.cells.data(), 0.3F);
  loops.back(map.cells.data(), range);
  spectrum_loops(0).back(plain.cells.data(), range);
  expect_same(numbers_of(map), numbers_of(plain));

  std::vector<float> response(kGrid * kGrid);
  std::vector<float> plain_response = response;
  loops.plane_back(sums.data(), response.data());
  spectrum_loops(0).plane_back(plain_sums.data(), plain_response.data());
  expect_same(response, plain_response);
}

}  // namespace
}  // namespace pacer::tracking
