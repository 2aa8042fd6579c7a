// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/gaussian.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/check.h"
#include "learning/exemplar/lanes.h"

namespace pacer::exemplar {
namespace {

constexpr std::size_t kRows = kLanes;

}  // namespace

double Gaussian::distance(const Eigen::VectorXd& point) const {
  const Eigen::LLT<Eigen::MatrixXd> factor(covariance);
  check(factor.info() == Eigen::Success, "the covariance is positive definite");
  return factor.matrixL().solve(point - mean).norm();
}

Gaussian fit_gaussian(std::span<const double> points, std::size_t d) {
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const auto n = static_cast<Eigen::Index>(points.size() / d);
  const Eigen::Map<const Rows> rows(points.data(), n, static_cast<Eigen::Index>(d));
  Gaussian gaussian;
  gaussian.mean = rows.colwise().mean();  // (5.3)
  const Eigen::MatrixXd centred = rows.rowwise() - gaussian.mean.transpose();
  gaussian.covariance = centred.transpose() * centred / static_cast<double>(n);  // (5.4)
  return gaussian;
}

void factorise(const Eigen::MatrixXd& covariance, Eigen::MatrixXd& factor) {
  constexpr int kAttempts = 12;  // the last raises by a tenth of the greatest variance,
                                 // those before by a tenth of the next
  const double greatest = covariance.diagonal().maxCoeff();
  for (int attempt = 0; attempt <= kAttempts; ++attempt) {
    factor = covariance;
    if (attempt > 0)
      factor.diagonal().array() += greatest * std::pow(10.0, attempt - kAttempts - 1);
    const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> llt(factor);
    if (llt.info() == Eigen::Success) return;
  }
  check(false, "a regularised covariance is positive definite, but for rounding");
}

DistanceLayout::DistanceLayout(std::size_t d)
    : d_(d), padded_((d + kRows - 1) / kRows * kRows), size_(padded_) {
  for (std::size_t row = 0; row < d; row += kRows) size_ += kRows * std::min(row + kRows, d);
}

void DistanceLayout::write(std::span<const double> mean, const Eigen::MatrixXd& covariance,
                           Eigen::MatrixXd& factor, std::span<float> place) const {
  const auto d = static_cast<Eigen::Index>(d_);
  factorise(covariance, factor);
  // The inverse in place, column by column from the last.
  for (Eigen::Index c = d - 1; c >= 0; --c) {
    const double inverse = 1.0 / factor(c, c);
    for (Eigen::Index r = d - 1; r > c; --r) {
      double sum = 0.0;
      for (Eigen::Index k = c + 1; k <= r; ++k) sum += factor(r, k) * factor(k, c);
      factor(r, c) = -sum * inverse;
    }
    factor(c, c) = inverse;
  }
  std::ranges::fill(place, 0.0F);
  for (std::size_t i = 0; i < d_; ++i) place[i] = static_cast<float>(mean[i]);
  float* out = place.data() + padded_;
  for (std::size_t first = 0; first < d_; first += kRows) {
    for (std::size_t c = 0; c < std::min(first + kRows, d_); ++c) {
      for (std::size_t r = first; r < first + kRows; ++r, ++out) {
        if (r < d_ && c <= r) {
          *out = static_cast<float>(
              factor(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c)));
        }
      }
    }
  }
}

float DistanceLayout::squared_distance(const float* gaussian, const float* point, float bound,
                                       float* scratch) const noexcept {
  for (std::size_t i = 0; i < padded_; i += kRows) {
    const Lanes difference = loaded(point + i) - loaded(gaussian + i);
    std::memcpy(scratch + i, &difference, sizeof difference);
  }
  const float* column = gaussian + padded_;
  float sum = 0.0F;
  for (std::size_t first = 0; first < d_; first += kRows) {
    Lanes even{};
    Lanes odd{};
    const std::size_t columns = std::min(first + kRows, d_);
    std::size_t c = 0;
    for (; c + 1 < columns; c += 2, column += 2 * kRows) {
      even += loaded(column) * scratch[c];
      odd += loaded(column + kRows) * scratch[c + 1];
    }
    if (c < columns) {
      even += loaded(column) * scratch[c];
      column += kRows;
    }
    even += odd;
    even *= even;
    sum += sum_of(even);
    if (sum >= bound) return sum;
  }
  return sum;
}

void write_sampling_factor(double n, std::span<const double> moments, std::size_t d,
                           std::span<double> factor) noexcept {
  constexpr double kSingular = 1e-12;  // of the variance; less than this is rounding
  const auto row_of = [](std::size_t r) { return r * (r + 1) / 2; };
  for (std::size_t r = 0; r < d; ++r) {
    for (std::size_t c = 0; c <= r; ++c) {
      const double covariance = moments[d + row_of(r) + c] / n;
      double rest = covariance;
      for (std::size_t k = 0; k < c; ++k) rest -= factor[row_of(r) + k] * factor[row_of(c) + k];
      const double pivot = factor[row_of(c) + c];
      if (r == c) {
        factor[row_of(r) + c] = rest > kSingular * covariance ? std::sqrt(rest) : 0.0;
      } else {
        factor[row_of(r) + c] = pivot > 0.0 ? rest / pivot : 0.0;
      }
    }
  }
}

void draw_sample(std::span<const double> mean, std::span<const double> factor, Random& random,
                 std::span<double> sample) noexcept {
  std::ranges::copy(mean, sample.begin());
  for (std::size_t c = 0; c < mean.size(); ++c) {
    const double normal = random.normal(0.0, 1.0);
    for (std::size_t r = c; r < mean.size(); ++r) {
      sample[r] += factor[r * (r + 1) / 2 + c] * normal;
    }
  }
}

}  // namespace pacer::exemplar
