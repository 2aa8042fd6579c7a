// SPDX-License-Identifier: Apache-2.0
#include "studies/tracking_claims.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <string>
#include <vector>

namespace pacer {
namespace {

using ::testing::Contains;
using ::testing::IsEmpty;
using ::testing::Key;
using ::testing::Not;
using ::testing::SizeIs;

/// What a made-up run on a sequence of 1000 pictures came to.
struct Made {
  double fps = 100.0;
  std::size_t held = 1000;
  double success = 0.5;
  double precision = 0.5;
};

ScoredRun run_of(const std::string& tracker, const std::string& target, const Made& made) {
  constexpr std::size_t kPictures = 1000;
  ScoredRun run;
  run.run.tracker = tracker;
  run.run.target = target;
  run.run.pictures = kPictures;
  run.run.tracks.assign(kPictures, {.box = {50.0, 50.0, 10.0, 20.0}, .confidence = 1.0});
  run.run.update_s = static_cast<double>(kPictures - 1) / made.fps;
  run.score.scored = kPictures;
  run.score.frames_held = made.held;
  run.score.success = made.success;
  run.score.precision = made.precision;
  run.score.centre_error.assign(kPictures, 0.0);
  return run;
}

class TrackingClaims : public ::testing::Test {
 protected:
  /// Every one of trackers_ on a further sequence.
  void run_on(const std::string& sequence, const std::map<std::string, Made>& made) {
    TrackingTarget target{.name = sequence, .sequence = {}, .truth = {}, .box = {}};
    target.truth.assign(1000, Box{50.0, 50.0, 10.0, 20.0});
    comparison_.targets.push_back(target);
    for (const std::string& tracker : comparison_.trackers) {
      const auto found = made.find(tracker);
      comparison_.runs.push_back(
          run_of(tracker, sequence, found == made.end() ? Made{} : found->second));
    }
  }
  std::map<std::string, Claim> claims(std::size_t given, double cost_exponent = 0.5) {
    std::map<std::string, Claim> by_name;
    for (const Claim& claim : tracking_claims(comparison_, given, cost_exponent)) {
      EXPECT_TRUE(by_name.emplace(claim.name, claim).second) << claim.name << " twice";
    }
    return by_name;
  }

  TrackingComparison comparison_ = {.trackers = {"LP-NEW", "LP-MED", "LP-SMAT", "LP-FLOCK",
                                                 "LK-SMAT", "LK", "Boosting", "MOSSE", "CSRT"},
                                    .peers = {"Boosting", "MOSSE", "CSRT"},
                                    .targets = {},
                                    .runs = {}};
};

TEST_F(TrackingClaims, AreOnlyOfCostWhereNoSequenceIsKnown) {
  run_on("mine", {});
  EXPECT_THAT(claims(0), SizeIs(1));
  EXPECT_TRUE(claims(0).at("cost_exponent").holds);
  EXPECT_FALSE(claims(0, 1.2).at("cost_exponent").holds);
}

TEST_F(TrackingClaims, OfSpeedAreRatiosOfTheSameRun) {
  run_on("Dudek", {{"LP-FLOCK", {.fps = 30000.0}},
                   {"LP-SMAT", {.fps = 2000.0}},
                   {"LP-NEW", {.fps = 2500.0}},
                   {"Boosting", {.fps = 45.0}},
                   {"MOSSE", {.fps = 2100.0}}});
  const auto found = claims(1);
  EXPECT_TRUE(found.at("dudek_lp_flock_fps").holds);
  EXPECT_FALSE(found.at("dudek_lp_smat_fps").holds);
  EXPECT_TRUE(found.at("dudek_lp_new_fps").holds);
  EXPECT_NEAR(found.at("dudek_lp_new_over_boosting").measured, 2500.0 / 45.0, 1e-9);
  EXPECT_TRUE(found.at("dudek_lp_new_over_boosting").holds);
  EXPECT_FALSE(found.at("dudek_lp_smat_over_boosting").holds);
  EXPECT_FALSE(found.at("dudek_lp_smat_over_mosse").holds);
}

TEST_F(TrackingClaims, OfAccuracyCompareMeansOverTheGivenSequencesOnly) {
  run_on("a", {{"LP-NEW", {.success = 0.7}}, {"CSRT", {.success = 0.9}}});
  run_on("b", {{"LP-NEW", {.success = 0.8}}, {"CSRT", {.success = 0.5}}});
  run_on("runner", {{"LP-NEW", {.success = 0.1}}, {"CSRT", {.success = 0.9}}});
  EXPECT_NEAR(claims(2).at("success_over_csrt").measured, 0.05, 1e-12);
  EXPECT_FALSE(claims(1).at("success_over_csrt").holds);
  EXPECT_THAT(claims(0), Not(Contains(Key("success_over_csrt"))));
}

TEST_F(TrackingClaims, LeaveOutTrackersThatWereNotRun) {
  comparison_.trackers = {"LP-NEW", "LP-MED"};
  run_on("camera-shake", {});
  const auto found = claims(0);
  EXPECT_THAT(found, SizeIs(2)) << "of cost, and of LP-MED";
  EXPECT_TRUE(found.at("camera_shake_lp_med_held").holds);
}

TEST_F(TrackingClaims, ThatATargetIsLostHoldOnlyWhenItIs) {
  run_on("camera-shake", {{"Boosting", {.held = 280}}, {"LK", {.held = 700}}});
  run_on("head-motion", {{"LK", {.held = 1000}}, {"LP-FLOCK", {.held = 999}}});
  const auto found = claims(0);
  EXPECT_TRUE(found.at("camera_shake_boosting_held").holds);
  EXPECT_FALSE(found.at("camera_shake_lk_held").holds);
  EXPECT_FALSE(found.at("head_motion_lk_held").holds);
  EXPECT_TRUE(found.at("head_motion_lp_flock_held").holds);
}

TEST_F(TrackingClaims, OfTheFaceAreTheSameFilmedAndSimulated) {
  for (const char* sequence : {"Dudek", "face-hand"}) {
    run_on(sequence,
           {{"LP-FLOCK", {.held = 213}}, {"LP-SMAT", {.held = 640}}, {"LP-MED", {.held = 760}}});
  }
  const auto found = claims(1);
  for (const char* sequence : {"dudek_", "face_hand_"}) {
    EXPECT_TRUE(found.at(std::string(sequence) + "lp_flock_held").holds);
    EXPECT_FALSE(found.at(std::string(sequence) + "lp_smat_held").holds);
    EXPECT_TRUE(found.at(std::string(sequence) + "lp_med_held").holds);
  }
}

TEST_F(TrackingClaims, OfTheRunnerCompareLpMedWithTheThesissOthers) {
  run_on("runner", {{"LP-MED", {.held = 300}},
                    {"LP-SMAT", {.held = 290}},
                    {"LP-FLOCK", {.held = 100}},
                    {"LK-SMAT", {.held = 310}},
                    {"LK", {.held = 140}},
                    {"Boosting", {.held = 200}}});
  const auto found = claims(0);
  EXPECT_DOUBLE_EQ(found.at("runner_lp_med_lead").measured, -10.0);
  EXPECT_DOUBLE_EQ(found.at("runner_longest_held").measured, 310.0)
      << "the trackers of today do not count";
  EXPECT_TRUE(found.at("runner_longest_held").holds);
}

TEST_F(TrackingClaims, OfATrackerThatDidNothingAreNumbers) {
  run_on("Dudek", {});
  for (ScoredRun& run : comparison_.runs) run.run.tracks.clear();
  const auto found = claims(1);
  EXPECT_DOUBLE_EQ(found.at("dudek_lp_flock_fps").measured, 0.0);
  EXPECT_FALSE(found.at("dudek_lp_flock_fps").holds);
}

TEST(DriftsAt, IsWhereTheErrorStaysLarge) {
  TrackingScore score;
  score.centre_error.assign(300, 5.0);
  EXPECT_EQ(drifts_at(score), 300U);
  for (std::size_t i = 50; i < 60; ++i) score.centre_error[i] = 30.0;  // for a moment
  for (std::size_t i = 155; i < 300; ++i) score.centre_error[i] = 21.0;
  EXPECT_EQ(drifts_at(score), 155U);
}

TEST(DriftsAt, CountsPicturesWithTruth) {
  TrackingScore score;
  score.centre_error.assign(100, 5.0);
  score.centre_error.insert(score.centre_error.begin() + 10, 40,
                            std::numeric_limits<double>::quiet_NaN());
  score.centre_error.insert(score.centre_error.end(), 100, 30.0);
  EXPECT_EQ(drifts_at(score), 100U);
}

TEST(JumpsAt, IsWhereTheBoxIsAQuarterOfTheTargetTooHigh) {
  TrackingTarget target{.name = "runner", .sequence = {}, .truth = {}, .box = {}};
  target.truth.assign(1000, Box{50.0, 50.0, 10.0, 20.0});
  ScoredRun run = run_of("Boosting", "runner", {});
  EXPECT_EQ(jumps_at(target, run), 1000U);
  run.run.tracks[3].box.y = 58.0;  // down does not count
  run.run.tracks[5].box.y = 45.5;
  run.run.tracks[8].box.y = 44.0;
  EXPECT_EQ(jumps_at(target, run), 8U);
}

TEST(Between, HoldsWithinItsBounds) {
  EXPECT_TRUE(between("a", "", 203.0, 203.0, 223.0).holds);
  EXPECT_TRUE(between("a", "", 223.0, 203.0, 223.0).holds);
  EXPECT_FALSE(between("a", "", 202.0, 203.0, 223.0).holds);
  EXPECT_FALSE(between("a", "", 224.0, 203.0, 223.0).holds);
  EXPECT_EQ(between("a", "", 1.0, 203.0, 223.5).bound, "203 to 223.5");
}

}  // namespace
}  // namespace pacer
