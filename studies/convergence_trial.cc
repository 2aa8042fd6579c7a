// SPDX-License-Identifier: Apache-2.0
#include "studies/convergence_trial.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "runs/worker_pool.h"
#include "studies/materials.h"

namespace pacer {
namespace {

/// `index`-th of `count` places, evenly from `low` to `high`, both included; one: in the middle.
int spread(int low, int high, int index, int count) {
  if (count == 1) return (low + high) / 2;
  return static_cast<int>(std::lround(low + static_cast<double>(high - low) * index / (count - 1)));
}

/// Where the `index`-th of `total` points lies: `of` pictures get their share in turn.
struct Place {
  std::size_t picture = 0;
  int point = 0;        ///< of the picture's
  int picture_has = 0;  ///< points
};

Place place_of(int index, int total, std::size_t of) {
  const auto pictures = static_cast<int>(of);
  // Picture p has the points from total p / pictures on.
  const int picture =
      static_cast<int>((static_cast<std::int64_t>(index + 1) * pictures - 1) / total);
  const auto first = [&](int p) {
    return static_cast<int>(static_cast<std::int64_t>(total) * p / pictures);
  };
  return {.picture = static_cast<std::size_t>(picture),
          .point = index - first(picture),
          .picture_has = first(picture + 1) - first(picture)};
}

}  // namespace

std::vector<double> ConvergenceTest::distances() const {
  std::vector<double> all;
  for (int i = 1; i <= ranges; ++i) all.push_back(longest * i / ranges);
  return all;
}

void ErrorTally::add(double error) {
  ++count_;
  if (error <= ConvergenceTest::kSuccess) ++successes_;
  sum_ += error;
  sum_of_squares_ += error * error;
}

void ErrorTally::add(const ErrorTally& other) {
  count_ += other.count_;
  successes_ += other.successes_;
  sum_ += other.sum_;
  sum_of_squares_ += other.sum_of_squares_;
}

double ErrorTally::mean() const { return sum_ / static_cast<double>(count_); }

double ErrorTally::variance() const {
  const double m = mean();
  return std::max(0.0, sum_of_squares_ / static_cast<double>(count_) - m * m);
}

double ErrorTally::success() const {
  return static_cast<double>(successes_) / static_cast<double>(count_);
}

nlohmann::json ErrorTally::to_json() const { return {count_, successes_, sum_, sum_of_squares_}; }

ErrorTally ErrorTally::from_json(const nlohmann::json& value) {
  ErrorTally tally;
  tally.count_ = value.at(0);
  tally.successes_ = value.at(1);
  tally.sum_ = value.at(2);
  tally.sum_of_squares_ = value.at(3);
  return tally;
}

std::vector<cv::Point> grid_points(cv::Size size, int count, int margin) {
  const int left = std::min(margin, size.width * 3 / 8);
  const int top = std::min(margin, size.height * 3 / 8);
  const double shape = static_cast<double>(size.height) / size.width;
  const int rows = std::clamp(static_cast<int>(std::lround(std::sqrt(count * shape))), 1, count);
  std::vector<cv::Point> points;
  for (int row = 0; row < rows; ++row) {
    const int columns = count * (row + 1) / rows - count * row / rows;
    for (int column = 0; column < columns; ++column) {
      points.emplace_back(spread(left, size.width - 1 - left, column, columns),
                          spread(top, size.height - 1 - top, row, rows));
    }
  }
  return points;
}

Eigen::Vector2d displacement(double length, Random& random) {
  const double direction = random.uniform(0.0, 2.0 * std::numbers::pi);
  return {length * std::cos(direction), length * std::sin(direction)};
}

void put_patch(cv::Mat1b& picture, cv::Point at, int side, double within, Random& random) {
  const auto drawn = [&](int centre) {
    return static_cast<int>(std::lround(centre + random.uniform(-within, within))) - side / 2;
  };
  const int left = drawn(at.x);
  const int top = drawn(at.y);
  picture(cv::Rect(left, top, side, side) & cv::Rect({}, picture.size())).setTo(255);
}

std::vector<ErrorCurve> converge(const ConvergenceTest& test, std::span<const cv::Mat1b> pictures,
                                 std::size_t estimators,
                                 const std::function<std::unique_ptr<Estimators>(Random)>& make,
                                 const Random& random, const RunControl& control) {
  const std::vector<double> distances = test.distances();
  const auto at_point = [&](std::uint32_t index) {
    const Place place = place_of(static_cast<int>(index), test.points, pictures.size());
    const cv::Mat1b& picture = pictures[place.picture];
    const cv::Point point = grid_points(picture.size(), place.picture_has,
                                        test.margin)[static_cast<std::size_t>(place.point)];
    const Eigen::Vector2d truth(point.x, point.y);

    const std::unique_ptr<Estimators> tested = make(random.fork("learning", index));
    tested->learn(picture, point);
    Random moves = random.fork("displacements", index);
    Random patches = random.fork("patches", index);
    cv::Mat1b seen = picture;
    std::vector<Eigen::Vector2d> found(estimators);
    std::vector<ErrorCurve> curves(estimators, ErrorCurve(distances.size()));
    for (std::size_t range = 0; range < distances.size(); ++range) {
      if (test.patch > 0) {
        seen = picture.clone();
        put_patch(seen, point, test.patch, test.patch_within, patches);
      }
      for (int i = 0; i < test.tests; ++i) {
        tested->estimate(seen, truth + displacement(distances[range], moves), found);
        for (std::size_t e = 0; e < estimators; ++e) {
          curves[e][range].add((found[e] - truth).norm());
        }
      }
    }
    nlohmann::json json = nlohmann::json::array();
    for (const ErrorCurve& curve : curves) {
      for (const ErrorTally& tally : curve) json.push_back(tally.to_json());
    }
    return json.dump();
  };

  std::vector<ErrorCurve> total(estimators, ErrorCurve(distances.size()));
  std::vector<std::uint32_t> indices(static_cast<std::size_t>(test.points));
  std::iota(indices.begin(), indices.end(), 0U);
  std::uint64_t done = 0;
  const bool whole = run_in_workers(
      control.jobs, indices, at_point,
      [&](std::uint32_t, const std::string& text) {  // in order: the same sums for any jobs
        const nlohmann::json json = nlohmann::json::parse(text);
        std::size_t next = 0;
        for (ErrorCurve& curve : total) {
          for (ErrorTally& tally : curve) tally.add(ErrorTally::from_json(json.at(next++)));
        }
        ++done;
      },
      control.stop, [&] { control.progress(done, indices.size(), "points"); });
  if (!whole) throw StudyStopped();
  return total;
}

}  // namespace pacer
