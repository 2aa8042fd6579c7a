// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/gradient_features.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/learning/tracking/texture.h"

namespace pacer::tracking {
namespace {

constexpr int kCells = static_cast<int>(kGrid);
constexpr int kHalves = 2 * kCells;
constexpr std::size_t kDirections = 16;
constexpr std::size_t kOrientations = 8;

Patch patch_of(const cv::Mat1b& image) {
  const Similarity pose{.x = 0.5 * image.cols, .y = 0.5 * image.rows, .scale = 1.2, .angle = 0.1};
  RegionPyramid pyramid;
  Patch patch(GradientFeatures::kSide);
  pyramid.take(image, pose, patch.side, 1.0);
  pyramid.sample(pose, patch);
  return patch;
}

/// The same features by their definition, sample by sample, in double precision.
class Reference {
 public:
  explicit Reference(const Patch& patch) : patch_(patch) {
    for (int y = 0; y < patch.side; ++y) {
      for (int x = 0; x < patch.side; ++x) count(x, y);
    }
  }

  /// Channels of a cell: 16 directions, 8 orientations, 4 energies, the intensity.
  [[nodiscard]] std::array<double, 29> channels(int row, int column) const {
    std::array<double, 29> all{};
    const Histogram directions = cell(row, column);
    for (int n = 0; n < 4; ++n) {
      const double norm = corner_norm(row + n / 2, column + n % 2);
      for (std::size_t i = 0; i < kDirections; ++i) {
        const double part = std::min(0.2, directions[i] / norm);
        all[i] += 0.5 * part;
        all[24 + static_cast<std::size_t>(n)] += 0.25 * part;
      }
      for (std::size_t i = 0; i < kOrientations; ++i) {
        const double both = directions[i] + directions[i + kOrientations];
        all[16 + i] += 0.5 * std::min(0.2, both / norm);
      }
    }
    double sum = 0.0;
    for (int y = 4 * row; y < 4 * row + 4; ++y) {
      for (int x = 4 * column; x < 4 * column + 4; ++x) sum += sample(x, y);
    }
    all[28] = sum / 16.0 / 255.0 - 0.5;
    for (double& value : all) value *= hann(row) * hann(column);
    return all;
  }

 private:
  using Histogram = std::array<double, kDirections>;

  [[nodiscard]] double sample(int x, int y) const {
    return static_cast<double>(patch_.data()[y * static_cast<std::ptrdiff_t>(patch_.stride) + x]);
  }
  static double hann(int cell) {
    return 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * (cell + 0.5) / kCells);
  }
  void count(int x, int y) {
    const double across = sample(x + 1, y) - sample(x - 1, y);
    const double down = sample(x, y + 1) - sample(x, y - 1);
    const double turn = std::atan2(down, across) / (std::numbers::pi / 8.0);
    const auto direction = static_cast<std::size_t>((std::lround(turn) + 16) % 16);
    halves_[static_cast<std::size_t>(y / 2 * kHalves + x / 2)][direction] +=
        std::hypot(across, down);
  }
  /// Pooled from the half cells around, bilinearly; zero outside.
  [[nodiscard]] Histogram cell(int row, int column) const {
    Histogram sums{};
    if (row < 0 || column < 0 || row >= kCells || column >= kCells) return sums;
    for (int y = 2 * row - 1; y <= 2 * row + 2; ++y) {
      for (int x = 2 * column - 1; x <= 2 * column + 2; ++x) {
        if (x < 0 || y < 0 || x >= kHalves || y >= kHalves) continue;
        const double near_y = y / 2 == row && y >= 0 ? 0.75 : 0.25;
        const double near_x = x / 2 == column && x >= 0 ? 0.75 : 0.25;
        for (std::size_t i = 0; i < kDirections; ++i) {
          sums[i] += near_x * near_y * halves_[static_cast<std::size_t>(y * kHalves + x)][i];
        }
      }
    }
    return sums;
  }
  /// Of the four cells whose corner it is that of cell (row, column) at the top left.
  [[nodiscard]] double corner_norm(int row, int column) const {
    double energy = 2.5;
    for (const int r : {row - 1, row}) {
      for (const int c : {column - 1, column}) {
        const Histogram directions = cell(r, c);
        for (std::size_t i = 0; i < kOrientations; ++i) {
          energy += std::pow(directions[i] + directions[i + kOrientations], 2);
        }
      }
    }
    return std::sqrt(energy);
  }

  const Patch& patch_;
  std::vector<Histogram> halves_ = std::vector<Histogram>(kHalves * kHalves);
};

TEST(GradientFeatures, AreThoseOfTheirDefinition) {
  const Patch patch = patch_of(texture({300, 260}, 4, 3.0));
  const Reference reference(patch);
  GradientFeatures features;
  FeatureMap map;
  features.describe(patch, map);
  for (int row = 0; row < kCells; ++row) {
    for (int column = 0; column < kCells; ++column) {
      const std::array<double, 29> wanted = reference.channels(row, column);
      const ComplexLanes& cell =
          map.at(static_cast<std::size_t>(row), static_cast<std::size_t>(column));
      for (std::size_t i = 0; i < kChannels; ++i) {
        const float value = i < kLanes ? cell.re[i] : cell.im[i - kLanes];
        ASSERT_NEAR(static_cast<double>(value), i < wanted.size() ? wanted[i] : 0.0, 2e-3)
            << "channel " << i << " of " << row << ", " << column;
      }
    }
  }
}

TEST(GradientFeatures, DoNotDependOnContrast) {
  cv::Mat1b faint, image;
  texture({300, 260}, 4, 3.0).convertTo(faint, CV_8U, 0.45);
  faint.convertTo(image, CV_8U, 2.0, 20.0);
  GradientFeatures features;
  FeatureMap strong, weak;
  features.describe(patch_of(image), strong);
  features.describe(patch_of(faint), weak);
  for (std::size_t c = 4; c < kGrid - 4; ++c) {
    for (std::size_t i = 0; i < kLanes; ++i) {
      EXPECT_NEAR(strong.at(16, c).re[i], weak.at(16, c).re[i], 0.05F) << c << ", " << i;
    }
  }
}

TEST(GradientFeatures, OfAFlatPatchAreItsIntensityOnly) {
  GradientFeatures features;
  FeatureMap map;
  features.describe(patch_of(cv::Mat1b(200, 200, std::uint8_t{255})), map);
  const ComplexLanes& cell = map.at(16, 16);
  for (std::size_t i = 0; i < kChannels; ++i) {
    const float value = i < kLanes ? cell.re[i] : cell.im[i - kLanes];
    EXPECT_NEAR(value, i == 28 ? 0.5F : 0.0F, 0.01F) << i;
  }
}

}  // namespace
}  // namespace pacer::tracking
