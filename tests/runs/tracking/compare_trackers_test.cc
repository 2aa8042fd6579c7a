// SPDX-License-Identifier: Apache-2.0
#include "runs/tracking/compare_trackers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stop_token>
#include <thread>

#include "runs/tracking/tracking_report.h"
#include "runs/tracking/tracking_story.h"
#include "tests/runs/tracking/fake_tracker.h"
#include "tests/runs/tracking/moving_target.h"
#include "tests/support/scratch.h"

namespace pacer {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::kind;

const std::vector<tracking::TrackerKind> kKinds = {kind<testing::Still>("still"),
                                                   kind<testing::Bright>("bright")};

/// Takes its time.
class Slow final : public testing::Still {
  [[nodiscard]] tracking::Track follow(const tracking::Picture&) override {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    return {.box = box_, .confidence = 1.0};
  }
};

bool holds(const report::Page& page, const std::string& text) {
  return page.html().find(text) != std::string::npos;
}

/// Two sequences, and both trackers on them.
class CompareTrackers : public ::testing::Test {
 protected:
  CompareTrackers()
      : targets_(targets_of({testing::write_moving(scratch_ / "long", 80),
                             testing::write_moving(scratch_ / "short", 30, 3)},
                            {})) {}

  TrackingComparison compare(int jobs) {
    RunControl control;
    control.jobs = jobs;
    TrackingComparison comparison =
        compare_trackers(kKinds, targets_, {}, control,
                         [this](const ScoredRun& one) { told_.push_back(one.run.tracker); });
    comparison.peers = {"still"};
    return comparison;
  }

  testing::Scratch scratch_;
  std::vector<TrackingTarget> targets_;
  std::vector<std::string> told_;
};

TEST_F(CompareTrackers, RunsEveryTrackerOnEveryTarget) {
  const TrackingComparison found = compare(2);
  EXPECT_TRUE(found.whole);
  ASSERT_EQ(found.runs.size(), 4U);
  EXPECT_THAT(told_, ElementsAre("still", "bright", "still", "bright"));
  ASSERT_NE(found.find(1, 0), nullptr);
  EXPECT_EQ(found.find(1, 0)->run.target, "short");
  EXPECT_EQ(found.find(1, 0)->run.tracker, "still");
  EXPECT_EQ(found.find(2, 0), nullptr);
  EXPECT_EQ(found.find(0, 2), nullptr);
}

TEST_F(CompareTrackers, WorkersChangeNothingButTimes) {
  const TrackingComparison one = compare(1);
  const TrackingComparison two = compare(2);
  for (std::size_t i = 0; i < 4; ++i) {
    TrackingRun a = one.runs[i].run;
    TrackingRun b = two.runs[i].run;
    for (TrackingRun* run : {&a, &b}) run->start_s = run->update_s = 0.0;
    EXPECT_EQ(to_bytes(a), to_bytes(b));
  }
}

TEST_F(CompareTrackers, SummariesAreMeansOverTargets) {
  const TrackingComparison found = compare(1);
  const std::vector<TrackerSummary> summaries = summarise(found);
  ASSERT_EQ(summaries.size(), 2U);
  const double success = 0.5 * (found.find(0, 1)->score.success + found.find(1, 1)->score.success);
  EXPECT_DOUBLE_EQ(summaries[1].success, success);
  double area = 0.0;
  for (const double share : summaries[1].success_plot) area += share / 21.0;
  EXPECT_NEAR(area, success, 1e-12);
  EXPECT_DOUBLE_EQ(summaries[1].held, 1.0);
  EXPECT_TRUE(std::isnan(summaries[0].temporal));
}

TEST_F(CompareTrackers, TheTableIsRankedBySuccess) {
  const report::Table table = summary_table(compare(1));
  EXPECT_THAT(report::markdown(table), HasSubstr("| bright |"));
  EXPECT_LT(report::markdown(table).find("| bright |"), report::markdown(table).find("| still |"));
}

TEST_F(CompareTrackers, WhatWasCutShortComesLastInTheRankingAndSaysSo) {
  TrackingComparison found = compare(1);
  EXPECT_EQ(report::markdown(summary_table(found)).find("pictures"), std::string::npos);
  ScoredRun& bright = found.runs[1];  // on the long one: all but its beginning
  bright.run.pictures = 5;
  bright.run.whole = found.whole = false;
  const std::string table = report::markdown(summary_table(found));
  EXPECT_LT(table.find("| still |"), table.find("| bright |")) << "though less successful";
  EXPECT_THAT(table, HasSubstr("32 of 107"));
  EXPECT_THAT(table, HasSubstr("107 of 107"));
  const nlohmann::ordered_json json = to_json(found);
  EXPECT_EQ(json["bright"]["long"]["frames"], 5);
  EXPECT_EQ(json["bright"]["long"]["pictures"], 80);
  report::Page page("Tracking");
  report_tracking(page, found);
  EXPECT_TRUE(holds(page, "Interrupted: "));
}

TEST_F(CompareTrackers, JsonHoldsWhatWasMeasured) {
  const nlohmann::ordered_json json = to_json(compare(1));
  const auto& one = json.at("still").at("short");
  EXPECT_EQ(one.at("frames"), 27);
  EXPECT_EQ(one.at("scored"), 27);
  EXPECT_EQ(one.at("frames_held"), 4) << "12 px wide, it is left after 6 px";
  EXPECT_EQ(one.at("lost_at"), 7) << "of the sequence";
  EXPECT_EQ(one.at("error"), nullptr);
  EXPECT_GT(one.at("fps").get<double>(), 0.0);
  EXPECT_GT(json.at("bright").at("long").at("success").get<double>(), 0.8);
}

TEST_F(CompareTrackers, WhatHasNoTruthIsNull) {
  targets_.resize(1);
  targets_[0].truth.clear();
  const TrackingComparison found = compare(1);
  EXPECT_EQ(to_json(found).at("still").at("long").at("success"), nullptr);
  EXPECT_EQ(to_json(found).at("still").at("long").at("failures"), nullptr);
  EXPECT_TRUE(std::isnan(summarise(found)[0].success));
}

TEST_F(CompareTrackers, KeyPicturesTellWhereATargetIsLost) {
  const TrackingComparison found = compare(1);
  const std::vector<KeyPicture> key = key_pictures(found, 1, 6);
  ASSERT_GE(key.size(), 4U);
  EXPECT_LE(key.size(), 6U);
  EXPECT_EQ(key.front().at, 3U);
  EXPECT_EQ(key.front().about, "start");
  EXPECT_EQ(key.back().at, 29U);
  EXPECT_TRUE(std::ranges::any_of(
      key, [](const KeyPicture& one) { return one.at == 7 && one.about == "lost by still"; }));
  EXPECT_TRUE(std::ranges::is_sorted(key, {}, &KeyPicture::at));
}

TEST_F(CompareTrackers, TheStoryHasAPictureForEachOfThemAndAFilm) {
  const TrackingComparison found = compare(1);
  const TrackingStory story = tell(found, 0);
  EXPECT_EQ(story.pictures.size(), key_pictures(found, 0).size());
  for (const KeyPicture& one : story.pictures) EXPECT_GT(one.jpg.size(), 1000U);
  EXPECT_THAT(story.mp4.substr(4, 4), "ftyp");
}

TEST_F(CompareTrackers, TheReportHasASectionForEachTarget) {
  report::Page page("Tracking");
  report_tracking(page, compare(1));
  for (const char* part :
       {"id=\"ranking\"", "id=\"success-and-precision\"", "id=\"long\"", "id=\"short\"",
        "bright [0.", "still [0.", "lost by still", "data:video/mp4"}) {
    EXPECT_TRUE(holds(page, part)) << part;
  }
}

TEST_F(CompareTrackers, AReportOnWhatIsGoneSaysSo) {
  const TrackingComparison found = compare(1);
  std::filesystem::remove_all(scratch_ / "short");
  report::Page page("Tracking");
  report_tracking(page, found);
  EXPECT_TRUE(holds(page, "The pictures end early: "));
}

TEST_F(CompareTrackers, KeepWhatEachHadWhenStopped) {
  std::stop_source stop;
  RunControl control;
  control.jobs = 2;
  control.stop = stop.get_token();
  control.progress = [&](std::uint64_t done, std::uint64_t, std::string_view) {
    if (done > 0) stop.request_stop();
  };
  const std::vector<tracking::TrackerKind> slow = {kind<Slow>("slow"), kind<Slow>("slower")};
  std::size_t told = 0;
  const TrackingComparison found =
      compare_trackers(slow, targets_, {}, control, [&](const ScoredRun&) { ++told; });
  EXPECT_FALSE(found.whole);
  ASSERT_EQ(found.runs.size(), 4U) << "one a tracker and target, in their order";
  EXPECT_EQ(told, 4U);
  // Which of the two had begun by then is chance.
  EXPECT_GT(found.runs[0].run.tracks.size() + found.runs[1].run.tracks.size(), 1U);
  for (std::size_t i : {0U, 1U}) {
    EXPECT_FALSE(found.runs[i].run.whole);
    EXPECT_LT(found.runs[i].run.tracks.size(), 80U) << i;
    EXPECT_EQ(found.runs[i].score.scored, found.runs[i].run.tracks.size()) << "no more is judged";
  }
  EXPECT_EQ(to_json(found)["slow"]["long"]["error"], "interrupted");
  EXPECT_EQ(found.runs[3].run.target, "short");
}

TEST_F(CompareTrackers, AStoppedComparisonCanBeReported) {
  TrackingComparison found = compare(1);
  found.runs.resize(1);
  found.whole = false;
  report::Page page("Tracking");
  report_tracking(page, found);
  EXPECT_TRUE(holds(page, "id=\"short\""));
  found.runs.clear();
  report::Page empty("Tracking");
  report_tracking(empty, found);
}

TEST(Styles, PeersAreDashedAndColoursDiffer) {
  TrackingComparison comparison;
  comparison.trackers = {"a", "b", "c"};
  comparison.peers = {"b"};
  const std::vector<BoxStyle> styles = styles_of(comparison);
  ASSERT_EQ(styles.size(), 4U);
  EXPECT_EQ(styles[0].name, "truth");
  EXPECT_FALSE(styles[1].dashed);
  EXPECT_TRUE(styles[2].dashed);
  EXPECT_NE(styles[1].colour, styles[3].colour);
}

}  // namespace
}  // namespace pacer
