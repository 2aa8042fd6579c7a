// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/appearance.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"

namespace pacer::tracking {
namespace {

const PosePredictorConfig& validated(const PosePredictorConfig& config) {
  config.validate();
  return config;
}

/// Replaces `right` by the solution of gram x = right; of the symmetric `gram`, which is lost, the
/// lower half is read. False where it is not positive definite. By Cholesky's columns: Eigen's
/// blocks allocate.
bool solve(Eigen::MatrixXf& gram, Eigen::MatrixXf& right) {
  const Eigen::Index n = gram.rows();
  for (Eigen::Index j = 0; j < n; ++j) {
    auto column = gram.col(j).tail(n - j);
    for (Eigen::Index k = 0; k < j; ++k) column -= gram(j, k) * gram.col(k).tail(n - j);
    if (!(column[0] > 0.0F)) return false;
    column *= 1.0F / std::sqrt(column[0]);
  }
  for (Eigen::Index c = 0; c < right.cols(); ++c) {
    auto x = right.col(c);
    for (Eigen::Index j = 0; j < n; ++j) {
      x[j] /= gram(j, j);
      x.tail(n - j - 1) -= x[j] * gram.col(j).tail(n - j - 1);
    }
    for (Eigen::Index j = n - 1; j >= 0; --j) {
      x[j] = (x[j] - gram.col(j).tail(n - j - 1).dot(x.tail(n - j - 1))) / gram(j, j);
    }
  }
  return true;
}

}  // namespace

void PosePredictorConfig::validate() const {
  require(side >= 2 && side <= 64, "side: must be 2 to 64");
  require(cover > 0.0 && cover <= 2.0, "cover: must be above 0, and 2 at most");
  require(samples >= 4 && samples <= 4096, "samples: must be 4 to 4096");
  require(shift_range > 0.0 && shift_range <= 1.0, "shift_range: must be above 0, and 1 at most");
  require(scale_range > 0.0 && scale_range <= 1.0, "scale_range: must be above 0, and 1 at most");
  require(angle_range > 0.0 && angle_range <= 1.0, "angle_range: must be above 0, and 1 at most");
  require(ridge > 0.0 && ridge <= 1e3, "ridge: must be above 0, and 1000 at most");
}

AspectTrainer::AspectTrainer(const PosePredictorConfig& config, double width, double height,
                             Random random)
    : config_(validated(config)), random_(random) {
  const Eigen::Index side = config.side;
  const Eigen::Index count = side * side;
  across_.resize(count);
  down_.resize(count);
  const auto offset = [&](Eigen::Index i, double size) {
    const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(side) - 0.5;
    return static_cast<float>(share * size * config.cover);
  };
  for (Eigen::Index i = 0; i < count; ++i) {
    across_[i] = offset(i % side, width);
    down_[i] = offset(i / side, height);
  }
  const auto shift = static_cast<float>(config.shift_range * std::sqrt(width * height));
  range_ << shift, shift, static_cast<float>(config.scale_range),
      static_cast<float>(config.angle_range);
  differences_.resize(count, config.samples);
  targets_.resize(config.samples, 4);
  gram_.resize(config.samples, config.samples);
  seen_.resize(count);
}

void AspectTrainer::observe(const Patch& patch, const PoseChange& change,
                            Eigen::VectorXf& seen) const {
  const Eigen::Index count = across_.size();
  seen.resize(count);
  const float grown = std::exp(change[kLogScale]);
  const float cosine = grown * std::cos(change[kAngle]);
  const float sine = grown * std::sin(change[kAngle]);
  const float middle = 0.5F * static_cast<float>(patch.side - 1);
  const float last = static_cast<float>(patch.side - 1) - 1e-3F;
  const float* const samples = patch.data();
  const std::size_t stride = patch.stride;
  float sum = 0.0F;
  for (Eigen::Index i = 0; i < count; ++i) {
    const float x = middle + change[kAcross] + cosine * across_[i] - sine * down_[i];
    const float y = middle + change[kDown] + sine * across_[i] + cosine * down_[i];
    const float inside_x = std::clamp(x, 0.0F, last);
    const float inside_y = std::clamp(y, 0.0F, last);
    const int left = static_cast<int>(inside_x);
    const int top = static_cast<int>(inside_y);
    const float right = inside_x - static_cast<float>(left);
    const float low = inside_y - static_cast<float>(top);
    const float* const at = samples + static_cast<std::size_t>(top) * stride + left;
    const float above = at[0] + right * (at[1] - at[0]);
    const float below = at[stride] + right * (at[stride + 1] - at[stride]);
    seen[i] = above + low * (below - above);
    sum += seen[i];
  }
  constexpr float kDark = 1e-3F;  // squared: a flat patch stays zero
  seen.array() -= sum / static_cast<float>(count);
  seen *= 1.0F / std::sqrt(seen.squaredNorm() + kDark);
}

void AspectTrainer::learn(const Patch& patch, Aspect& aspect) {
  observe(patch, PoseChange::Zero(), aspect.reference);
  for (Eigen::Index n = 0; n < config_.samples; ++n) {
    PoseChange change;
    for (int axis = 0; axis < 4; ++axis) {
      const auto share = static_cast<float>(random_.uniform(-1.0, 1.0));
      change[axis] = share * range_[axis];
      targets_(n, axis) = -share;  // what was seen when off by so much has to go back by it
    }
    observe(patch, change, seen_);
    differences_.col(n) = aspect.reference - seen_;
  }
  // (3.7): P = X D+ = X (D'D + ridge)^-1 D'
  for (Eigen::Index j = 0; j < config_.samples; ++j) {
    for (Eigen::Index i = j; i < config_.samples; ++i) {
      gram_(i, j) = differences_.col(i).dot(differences_.col(j));
    }
  }
  const float mean = gram_.trace() / static_cast<float>(config_.samples);
  gram_.diagonal().array() += static_cast<float>(config_.ridge) * std::max(mean, 1e-6F);
  aspect.projection.resize(4, differences_.rows());
  if (!solve(gram_, targets_)) {  // with a ridge too small for floats: predicts nothing
    aspect.projection.setZero();
    return;
  }
  for (int axis = 0; axis < 4; ++axis) {
    for (Eigen::Index i = 0; i < differences_.rows(); ++i) {
      aspect.projection(axis, i) = range_[axis] * differences_.row(i).dot(targets_.col(axis));
    }
  }
}

PoseChange AspectTrainer::predict(const Aspect& aspect, const Eigen::VectorXf& seen) const {
  PoseChange change = PoseChange::Zero();  // (3.6): P (l0 - l)
  for (Eigen::Index i = 0; i < seen.size(); ++i) {
    change += aspect.projection.col(i) * (aspect.reference[i] - seen[i]);
  }
  return change.cwiseMax(-range_).cwiseMin(range_);
}

}  // namespace pacer::tracking
