// SPDX-License-Identifier: Apache-2.0
#include "studies/tracking_pass.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/check.h"
#include "studies/materials.h"
#include "tests/runs/tracking/fake_tracker.h"
#include "tests/runs/tracking/moving_target.h"
#include "tests/support/scratch.h"

namespace pacer {
namespace {

using ::testing::HasSubstr;

class TrackingPass : public ::testing::Test {
 protected:
  TrackingPass() {
    (void)testing::write_moving(scratch_ / "given/long", 40);
    (void)testing::write_moving(scratch_ / "simulated/short", 10, 3);
  }
  std::string error_of(const std::filesystem::path& folder) const {
    try {
      (void)given_targets(folder);
    } catch (const UsageError& error) {
      return error.what();
    }
    return "none";
  }

  testing::Scratch scratch_;
};

TEST_F(TrackingPass, RunsEveryTrackerOnTheGivenSequencesAndThenOnTheSimulated) {
  TrackingTargets targets = given_targets(scratch_ / "given");
  EXPECT_EQ(targets.given, 1U);
  add_simulated(scratch_ / "simulated", targets);
  RunControl control;
  control.jobs = 2;
  const TrackingComparison found =
      track_all({testing::kind<testing::Still>("Boosting"), testing::kind<testing::Bright>("TLD")},
                targets.all, 1, control);
  ASSERT_EQ(found.runs.size(), 4U);
  for (std::size_t target = 0; target < 2; ++target) {
    for (std::size_t tracker = 0; tracker < 2; ++tracker) {
      const ScoredRun* const run = found.find(target, tracker);
      EXPECT_EQ(run->run.target, target == 0 ? "long" : "short");
      EXPECT_EQ(run->run.tracker, tracker == 0 ? "Boosting" : "TLD");
      EXPECT_EQ(run->score.scored, target == 0 ? 40U : 7U);
    }
  }

  const TrackingComparison simulated = part(found, 1, 2);
  ASSERT_EQ(simulated.targets.size(), 1U);
  EXPECT_EQ(simulated.find(0, 1)->run.target, "short");
  EXPECT_EQ(simulated.find(0, 1)->run.tracker, "TLD");
  EXPECT_TRUE(part(found, 0, 0).runs.empty());
}

TEST_F(TrackingPass, NeedsNoGivenSequences) {
  TrackingTargets targets = given_targets({});
  add_simulated(scratch_ / "simulated", targets);
  EXPECT_EQ(targets.given, 0U);
  EXPECT_EQ(targets.all.size(), 1U);
}

TEST_F(TrackingPass, EndsWhenToldTo) {
  std::stop_source stop;
  stop.request_stop();
  RunControl control;
  control.stop = stop.get_token();
  EXPECT_THROW((void)track_all({testing::kind<testing::Still>("still")},
                               given_targets(scratch_ / "given").all, 1, control),
               StudyStopped);
}

TEST_F(TrackingPass, SaysWhatIsWrongWithTheFolder) {
  EXPECT_THAT(error_of(scratch_ / "nowhere"), HasSubstr("nowhere: there is no such folder"));
  std::filesystem::create_directories(scratch_ / "empty");
  EXPECT_THAT(error_of(scratch_ / "empty"), HasSubstr("empty: no sequences"));
  std::ofstream(scratch_ / "given/long/groundtruth_rect.txt") << "NaN,NaN,NaN,NaN\n";
  EXPECT_THAT(error_of(scratch_ / "given"), HasSubstr("long has no truth"));
}

TEST_F(TrackingPass, RefusesTwoSequencesOfOneName) {
  TrackingTargets targets = given_targets(scratch_ / "given");
  EXPECT_THROW(add_simulated(scratch_ / "given", targets), UsageError);
}

}  // namespace
}  // namespace pacer
