// SPDX-License-Identifier: Apache-2.0
// The trackers against their algorithms as the thesis lists them, step by step, of the same parts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "learning/tracking/flock.h"
#include "learning/tracking/lk_smat_tracker.h"
#include "learning/tracking/lp_flock_tracker.h"
#include "learning/tracking/lp_med_tracker.h"
#include "learning/tracking/lp_smat_tracker.h"
#include "learning/tracking/lucas_kanade.h"
#include "learning/tracking/medoidshift.h"
#include "learning/tracking/smat.h"
#include "tests/learning/tracking/texture.h"

namespace pacer::tracking {
namespace {

using Points = std::vector<Eigen::Vector2d>;
using Numbers = std::vector<double>;

const Box kTarget{.x = 99.3, .y = 79.9, .width = 46.0, .height = 40.0};
constexpr int kFrames = 120;
constexpr std::uint64_t kSeed = 5;

/// A target that moves before a background that stands, and changes its looks at times.
cv::Mat1b frame(int t) {
  static const cv::Mat1b background = texture({200, 160}, 31, 8.0);
  static const std::vector<cv::Mat1b> looks = {
      texture({80, 80}, 32, 8.0), texture({80, 80}, 33, 8.0), texture({80, 80}, 34, 8.0)};
  const int look = t % 30 == 29 ? 1 : (t > 70 && t < 95 ? 2 : 0);
  const cv::Point at(60 + static_cast<int>(std::lround(20.0 * std::sin(0.15 * t))),
                     40 + static_cast<int>(std::lround(15.0 * std::sin(0.11 * t))));
  cv::Mat1b image = background.clone();
  looks[static_cast<std::size_t>(look)].copyTo(image(cv::Rect(at, cv::Size(80, 80))));
  return image;
}

std::vector<Track> tracks_of(Tracker& tracker) {
  std::vector<Track> tracks;
  tracker.start(picture_of(frame(0)), kTarget);
  for (int t = 1; t < kFrames; ++t) tracks.push_back(tracker.update(picture_of(frame(t))));
  return tracks;
}

Eigen::Vector2d centre_of(const Box& box) { return {box.x, box.y}; }
cv::Point pixel_of(const Eigen::Vector2d& at) {
  return {static_cast<int>(std::lround(at.x())), static_cast<int>(std::lround(at.y()))};
}
void move(Box& box, const Eigen::Vector2d& by) {
  box.x += by.x();
  box.y += by.y();
}

void expect_same(const Track& track, const Box& box, int t) {
  ASSERT_NEAR(track.box.x, box.x, 1e-5) << "at " << t;
  ASSERT_NEAR(track.box.y, box.y, 1e-5) << "at " << t;
}

TEST(Algorithm1, IsWhatLkSmatDoes) {
  LkSmatTracker tracker;
  const std::vector<Track> tracks = tracks_of(tracker);
  const TrackingConfig config;
  const TemplateGrid grid(kTarget.width, kTarget.height, config.registered_pixels);
  LucasKanade registration(config.registration, grid);
  Smat aspects(config.smat, grid.length());
  std::vector<std::uint8_t> sample(grid.length());
  const cv::Point first = pixel_of(centre_of(kTarget));
  grid.extract(frame(0), first, sample.data());
  aspects.start(sample);
  std::vector<std::uint8_t> chosen = sample;  // G*
  Eigen::Vector2d at(first.x, first.y);
  int most = 0;
  for (int t = 1; t < kFrames; ++t) {
    registration.set_template(chosen);
    at = registration.align(frame(t), at).at;
    grid.extract(frame(t), pixel_of(at), sample.data());
    const int matched = aspects.add(sample).component;
    chosen.assign(aspects.median(matched).begin(), aspects.median(matched).end());
    Box box = kTarget;
    move(box, at - Eigen::Vector2d(first.x, first.y));
    expect_same(tracks[static_cast<std::size_t>(t - 1)], box, t);
    most = std::max(most, aspects.size());
  }
  EXPECT_GT(most, 1);
}

TEST(Equation38, IsWhatLpFlockDoes) {
  LpFlockTracker tracker(kSeed);
  const std::vector<Track> tracks = tracks_of(tracker);
  const TrackingConfig config;
  MemberTrainer trainer(config.predictor, Random(kSeed).fork("LP-FLOCK"));
  std::vector<FlockMember> members(60, trainer.make());
  for (FlockMember& member : members) trainer.learn(frame(0), kTarget, member);
  Box box = kTarget;
  for (int t = 1; t < 40; ++t) {
    Eigen::Vector2d sum(0, 0);
    for (const FlockMember& member : members) sum += member.predict(frame(t), centre_of(box));
    move(box, sum / 60.0);
    expect_same(tracks[static_cast<std::size_t>(t - 1)], box, t);
  }
}

TEST(Algorithm2, IsWhatLpSmatDoes) {
  LpSmatTracker tracker(kSeed);
  const std::vector<Track> tracks = tracks_of(tracker);

  const TrackingConfig config;
  const TemplateGrid grid(kTarget.width, kTarget.height, config.template_pixels);
  MemberTrainer trainer(config.predictor, Random(kSeed).fork("LP-SMAT"));
  // A grows by a predictor for every one learnt; members of a component apart from their errors.
  std::vector<FlockMember> predictors(40, trainer.make());
  for (FlockMember& predictor : predictors) trainer.learn(frame(0), kTarget, predictor);
  std::vector<Numbers> a(4, Numbers(40 + kFrames, 0.0));
  std::vector<std::vector<bool>> belongs(4, std::vector<bool>(40 + kFrames, false));
  for (std::size_t l = 0; l < 40; ++l) {
    a[0][l] = 1.0;
    belongs[0][l] = true;
  }
  Smat aspects(config.smat, grid.length());
  std::vector<std::uint8_t> sample(grid.length());
  grid.extract(frame(0), pixel_of(centre_of(kTarget)), sample.data());
  aspects.start(sample);
  std::size_t active = 0;
  Box box = kTarget;
  int created = 0, kept = 0, switched = 0;
  for (int t = 1; t < kFrames; ++t) {
    FlockMember newest = trainer.make();  // learnt on the previous frame
    trainer.learn(frame(t - 1), box, newest);
    const cv::Mat1b image = frame(t);
    Points moved(predictors.size());
    double greatest = 0.0, least = std::numeric_limits<double>::infinity();
    for (std::size_t l = 0; l < predictors.size(); ++l) {
      if (!belongs[active][l]) continue;
      moved[l] = predictors[l].predict(image, centre_of(box));
      greatest = std::max(greatest, a[active][l]);
      least = std::min(least, a[active][l]);
    }
    Eigen::Vector2d sum(0, 0);
    double weights = 0.0;
    for (std::size_t l = 0; l < predictors.size(); ++l) {
      if (!belongs[active][l]) continue;
      const double weight = least == greatest ? 1.0 : 1.0 - a[active][l] / greatest;  // (4.5)
      sum += weight * moved[l];
      weights += weight;
    }
    const Eigen::Vector2d output = sum / weights;  // (4.6)
    std::size_t worst = 0;
    double worst_error = -1.0, mean = 0.0;
    for (std::size_t l = 0; l < predictors.size(); ++l) {
      if (!belongs[active][l]) continue;
      a[active][l] = 0.9 * a[active][l] + 0.1 * (moved[l] - output).norm();  // (4.4)
      mean += a[active][l] / 40.0;
      if (a[active][l] > worst_error) worst = l;  // (4.7)
      worst_error = std::max(worst_error, a[active][l]);
    }
    const double newest_error = (newest.predict(image, centre_of(box)) - output).norm();
    if (newest_error < (moved[worst] - output).norm()) {
      belongs[active][worst] = false;
      belongs[active][predictors.size()] = true;
      a[active][predictors.size()] = mean;
      predictors.push_back(newest);
    } else {
      ++kept;
    }
    move(box, output);
    expect_same(tracks[static_cast<std::size_t>(t - 1)], box, t);
    grid.extract(image, pixel_of(centre_of(box)), sample.data());
    const Smat::Match match = aspects.add(sample);
    const auto matched = static_cast<std::size_t>(match.component);
    if (match.created && matched != active) {
      a[matched] = a[active];
      belongs[matched] = belongs[active];
      ++created;
    }
    if (matched != active) ++switched;
    active = matched;
  }
  EXPECT_GE(created, 1);
  EXPECT_GE(switched, 3);
  EXPECT_GT(kept, 5);
  EXPECT_GT(predictors.size(), 60U);
}

TEST(Algorithm3, IsWhatLpMedDoes) {
  TrackingConfig config;
  config.medoidshift.templates = 50;  // so that templates leave
  LpMedTracker tracker(kSeed, config);
  const std::vector<Track> tracks = tracks_of(tracker);

  const TemplateGrid grid(kTarget.width, kTarget.height, config.template_pixels);
  MemberTrainer trainer(config.predictor, Random(kSeed).fork("LP-MED"));
  std::vector<FlockMember> predictors(80, trainer.make());
  for (FlockMember& predictor : predictors) trainer.learn(frame(0), kTarget, predictor);
  Medoidshift clusters(config.medoidshift);
  std::vector<std::vector<std::uint8_t>> samples;
  std::vector<Numbers> a;  // by template
  std::size_t newest_at = 0;
  const auto add = [&](const cv::Mat1b& image, const Box& box) {
    newest_at = clusters.next();
    if (newest_at == samples.size()) {
      samples.emplace_back(grid.length());
      a.emplace_back(80);
    }
    grid.extract(image, pixel_of(centre_of(box)), samples[newest_at].data());
    Numbers distances;
    for (const auto& sample : samples) distances.push_back(distance(sample, samples[newest_at]));
    clusters.add(distances);
  };
  add(frame(0), kTarget);
  Numbers weights(80, 1.0);
  Box box = kTarget;
  std::size_t most = 0, kept = 0;
  for (int t = 1; t < kFrames; ++t) {
    FlockMember newest = trainer.make();
    trainer.learn(frame(t - 1), box, newest);
    const cv::Mat1b image = frame(t);
    Points moved;
    for (const FlockMember& predictor : predictors) {
      moved.push_back(predictor.predict(image, centre_of(box)));
    }
    const Eigen::Vector2d output = weighted_mean(moved, weights);  // (4.11)
    const double newest_error = (newest.predict(image, centre_of(box)) - output).norm();
    move(box, output);
    expect_same(tracks[static_cast<std::size_t>(t - 1)], box, t);
    Numbers errors;
    for (const Eigen::Vector2d& one : moved) errors.push_back((one - output).norm());
    if (t == 1) a[0] = errors;
    add(image, box);
    a[newest_at] = errors;  // (4.8)
    const auto modes = clusters.modes();
    for (std::size_t m = 0; m < samples.size(); ++m) {
      if (m == newest_at || modes[m] != modes[newest_at]) continue;
      for (std::size_t l = 0; l < 80; ++l) a[m][l] = 0.9 * a[m][l] + 0.1 * errors[l];  // (4.9)
    }
    std::size_t worst = 0;
    double greatest_least = -1.0;
    for (std::size_t l = 0; l < 80; ++l) {
      double least = std::numeric_limits<double>::infinity();
      for (const Numbers& one : a) least = std::min(least, one[l]);
      if (least > greatest_least) worst = l;  // (4.12)
      greatest_least = std::max(greatest_least, least);
    }
    if (newest_error < errors[worst]) {
      predictors[worst] = newest;
      for (Numbers& one : a) {
        double mean = 0.0;
        for (const double error : one) mean += error / 80.0;
        one[worst] = mean;  // (4.13)
      }
    } else {
      ++kept;
    }
    Numbers sums(80, 0.0);
    for (std::size_t m = 0; m < samples.size(); ++m) {
      if (modes[m] != modes[newest_at]) continue;
      for (std::size_t l = 0; l < 80; ++l) sums[l] += a[m][l];
    }
    const double greatest = *std::ranges::max_element(sums);
    for (std::size_t l = 0; l < 80; ++l) weights[l] = 1.0 - sums[l] / greatest;  // (4.10)
    std::vector<std::size_t> distinct(modes.begin(), modes.end());
    std::ranges::sort(distinct);
    most = std::max(
        most, static_cast<std::size_t>(std::ranges::unique(distinct).begin() - distinct.begin()));
  }
  EXPECT_GT(most, 2U);
  EXPECT_GT(kept, 5U);
}

}  // namespace
}  // namespace pacer::tracking
