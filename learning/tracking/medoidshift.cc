// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/medoidshift.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/check.h"
#include "learning/tracking/template_loops.h"

namespace pacer::tracking {
namespace {

// Distances are below 2^24 steps and weights at most 2^20 of theirs: sums of 256 products are below
// 2^53, and so are exact.
constexpr double kMostSteps = 0x1.0p24;
constexpr double kOne = 0x1.0p20;

constexpr std::size_t kUnseen = std::numeric_limits<std::size_t>::max();
constexpr std::size_t kOnPath = kUnseen - 1;

}  // namespace

Medoidshift::Medoidshift(const MedoidshiftConfig& config) : config_(config) {
  config.validate();
  most_ = static_cast<std::size_t>(config.templates);
  stride_ = padded(most_);
  distances_.resize(most_ * stride_);
  weights_.resize(most_ * stride_);
  product_.resize(most_ * stride_);
  old_distances_.resize(stride_);
  old_weights_.resize(stride_);
  column_.resize(stride_);
  least_.resize(stride_);
  shifts_.resize(stride_);
  sorted_.resize(most_ * (most_ - 1) / 2);
  modes_.resize(most_);
  path_.reserve(most_);
}

void Medoidshift::start() noexcept {
  size_ = next_ = since_ = 0;
  bandwidth_ = 0.0;
  std::ranges::fill(distances_, 0.0F);
  std::ranges::fill(weights_, 0.0F);
  std::ranges::fill(product_, 0.0);
}

void Medoidshift::add(std::span<const double> distances) {
  const std::size_t point = next_;
  next_ = (next_ + 1) % most_;
  size_ = std::min(size_ + 1, most_);
  place(point, distances);
  if (size_ < static_cast<std::size_t>(config_.fewest)) {
    std::fill_n(modes_.begin(), size_, point);
    return;
  }
  if (bandwidth_ <= 0.0 || since_ == most_) {
    set_bandwidth();
    compute_product();
    since_ = 0;
  } else {
    exchange(point);
  }
  ++since_;
  shift();
  follow_shifts();
}

// Keeps what was there until the product has been told.
void Medoidshift::place(std::size_t point, std::span<const double> distances) {
  const auto begin = static_cast<std::ptrdiff_t>(point * stride_);
  std::copy_n(distances_.begin() + begin, stride_, old_distances_.begin());
  std::copy_n(weights_.begin() + begin, stride_, old_weights_.begin());
  for (std::size_t i = 0; i < size_; ++i) {
    const double steps = i == point ? 0.0 : std::round(distances[i] / kStep);
    check(steps >= 0.0 && steps < kMostSteps, "distances are from 0 to a million");
    distances_[point * stride_ + i] = distances_[i * stride_ + point] = static_cast<float>(steps);
  }
  if (bandwidth_ <= 0.0) return;
  for (std::size_t i = 0; i < size_; ++i) {
    weights_[point * stride_ + i] = weights_[i * stride_ + point] =
        weigh(distances_[point * stride_ + i]);
  }
}

float Medoidshift::weigh(float distance) const {
  return static_cast<float>(
      std::round(kOne * std::exp(-static_cast<double>(distance) / bandwidth_)));
}

void Medoidshift::set_bandwidth() {
  std::size_t count = 0;
  for (std::size_t i = 0; i < size_; ++i) {
    for (std::size_t j = 0; j < i; ++j) sorted_[count++] = distances_[i * stride_ + j];
  }
  const auto rank = static_cast<std::ptrdiff_t>(config_.quantile * static_cast<double>(count));
  const auto end = sorted_.begin() + static_cast<std::ptrdiff_t>(count);
  std::nth_element(sorted_.begin(), sorted_.begin() + rank, end);
  // A picture that stands still has distances of 0 only.
  bandwidth_ = std::max(1.0, static_cast<double>(sorted_[static_cast<std::size_t>(rank)]));
}

void Medoidshift::compute_product() {
  for (std::size_t i = 0; i < size_; ++i) {
    for (std::size_t j = 0; j < size_; ++j) {
      weights_[i * stride_ + j] = weigh(distances_[i * stride_ + j]);
    }
  }
  for (std::size_t j = 0; j < size_; ++j) {
    double* const row = &product_[j * stride_];
    std::fill_n(row, stride_, 0.0);
    for (std::size_t k = 0; k < size_; ++k) {
      template_loops().add_scaled(static_cast<double>(distances_[j * stride_ + k]),
                                  &weights_[k * stride_], stride_, row);
    }
  }
}

void Medoidshift::exchange(std::size_t point) {
  const TemplateLoops& loops = template_loops();
  const float* const new_distances = &distances_[point * stride_];
  const float* const new_weights = &weights_[point * stride_];
  double* const own = &product_[point * stride_];
  std::fill_n(own, stride_, 0.0);
  std::ranges::fill(column_, 0.0);
  for (std::size_t k = 0; k < size_; ++k) {  // the point's own row and column; D and Phi: symmetric
    loops.add_scaled(static_cast<double>(new_distances[k]), &weights_[k * stride_], stride_, own);
    loops.add_scaled(static_cast<double>(new_weights[k]), &distances_[k * stride_], stride_,
                     column_.data());
  }
  for (std::size_t j = 0; j < size_; ++j) {
    if (j == point) continue;
    double* const row = &product_[j * stride_];
    loops.exchange(new_distances[j], new_weights, old_distances_[j], old_weights_.data(), stride_,
                   row);
    row[point] = column_[j];
  }
}

// The first of several that are as good, so that points that are the same share their shift.
void Medoidshift::shift() {
  std::ranges::fill(least_, std::numeric_limits<double>::infinity());
  for (std::size_t j = 0; j < size_; ++j) {
    template_loops().lower(&product_[j * stride_], static_cast<double>(j), stride_, least_.data(),
                           shifts_.data());
  }
}

void Medoidshift::follow_shifts() {
  std::fill_n(modes_.begin(), size_, kUnseen);
  for (std::size_t start = 0; start < size_; ++start) {
    std::size_t i = start;
    path_.clear();
    for (; modes_[i] == kUnseen; i = static_cast<std::size_t>(shifts_[i])) {
      modes_[i] = kOnPath;
      path_.push_back(i);
    }
    // A mode shifts to itself. Rounding could make a ring of points: they are one mode.
    const std::size_t mode = modes_[i] == kOnPath ? i : modes_[i];
    for (const std::size_t passed : path_) modes_[passed] = mode;
  }
}

}  // namespace pacer::tracking
