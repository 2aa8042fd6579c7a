// SPDX-License-Identifier: Apache-2.0
#include "dataset/statistics.h"

#include <gmock/gmock.h>

#include <limits>

#include "dataset/reader.h"
#include "dataset/recorder.h"
#include "tests/dataset/recording.h"

namespace pacer::dataset {
namespace {

/// lerobot's own dataset; empty where it is not.
std::filesystem::path reference() {
  const char* data = std::getenv("PACER_DATA");
  const std::filesystem::path root =
      data != nullptr ? std::filesystem::path(data)
                      : std::filesystem::path(PACER_SOURCE_DIR) / "../shared/data";
  const auto set = root / "lerobot-0.4.4";
  return std::filesystem::exists(set / "meta/info.json") ? set : std::filesystem::path();
}

std::vector<ValueStatistics> measure(const std::vector<double>& values) {
  StatisticsBuilder builder(1);
  for (const double value : values) builder.see(std::span(&value, 1));
  for (const double value : values) builder.see_again(std::span(&value, 1));
  return builder.finish();
}

TEST(Statistics, AreThoseOfTheReferencesWriter) {
  if (reference().empty()) GTEST_SKIP() << "no reference dataset: set PACER_DATA";
  const Dataset dataset(reference());
  ASSERT_EQ(dataset.episodes().size(), 2U);
  const auto entries = read_episode_file(reference() / "meta/episodes/chunk-000/file-000.parquet",
                                         dataset.info(), true);
  for (std::size_t episode = 0; episode < 2; ++episode) {
    for (const std::string name : {"frame_index", "episode_index", "index", "timestamp"}) {
      StatisticsBuilder builder(1);
      for (int pass = 0; pass < 2; ++pass) {
        EpisodeReader reader(dataset, episode, {name}, EpisodeReader::Frames::kLeave);
        while (const RecordedStep* step = reader.next()) {
          pass == 0 ? builder.see(step->values) : builder.see_again(step->values);
        }
      }
      const ValueStatistics mine = builder.finish().front();
      const auto& all = entries[episode].statistics;
      const auto found = std::ranges::find(all, name, [](const auto& each) { return each.first; });
      ASSERT_NE(found, all.end());
      const ValueStatistics theirs = found->second.components.front();
      EXPECT_NEAR(mine.min, theirs.min, 1e-7) << name;
      EXPECT_NEAR(mine.max, theirs.max, 1e-7) << name;
      EXPECT_NEAR(mine.mean, theirs.mean, 1e-7) << name;
      EXPECT_NEAR(mine.deviation, theirs.deviation, 1e-7) << name;
      for (std::size_t q = 0; q < kQuantiles.size(); ++q) {
        EXPECT_NEAR(mine.quantiles[q], theirs.quantiles[q], 1e-7) << name << " " << q;
      }
    }
  }
}

TEST(Statistics, OfPicturesAreThoseOfTheReferencesWriter) {
  if (reference().empty()) GTEST_SKIP() << "no reference dataset: set PACER_DATA";
  const Dataset dataset(reference());
  const auto entries = read_episode_file(reference() / "meta/episodes/chunk-000/file-000.parquet",
                                         dataset.info(), true);
  for (std::size_t episode = 0; episode < 2; ++episode) {
    ImageStatistics statistics;
    EpisodeReader reader(dataset, episode, {});
    while (const RecordedStep* step = reader.next()) statistics.see(*step->frame);
    const FeatureStatistics mine = statistics.finish();
    const FeatureStatistics& theirs = entries[episode].statistics.front().second;
    EXPECT_EQ(mine.count, theirs.count);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      // Theirs are of the pictures before they were encoded.
      EXPECT_NEAR(mine.components[channel].mean, theirs.components[channel].mean, 0.01);
      EXPECT_NEAR(mine.components[channel].quantiles[2], theirs.components[channel].quantiles[2],
                  0.02);
    }
  }
}

TEST(Statistics, OfOneValueAreThatValue) {
  const ValueStatistics value = measure({5.0, 5.0, 5.0}).front();
  EXPECT_EQ(value.min, 5.0);
  EXPECT_EQ(value.max, 5.0);
  EXPECT_EQ(value.deviation, 0.0);
  for (const double quantile : value.quantiles) EXPECT_NEAR(quantile, 5.0, 1e-9);
}

TEST(Statistics, SurviveValuesTooLargeForTheHistogramsMargin) {
  const ValueStatistics value = measure({1e18, 1e18, 1e18}).front();
  for (const double quantile : value.quantiles) EXPECT_EQ(quantile, 1e18);
}

TEST(Statistics, LeaveOutWhatIsNotFinite) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const ValueStatistics value = measure({1.0, none, 3.0}).front();
  EXPECT_EQ(value.mean, 2.0);
  EXPECT_EQ(value.max, 3.0);
}

TEST(Statistics, OfSeveralEpisodesAreThoseOfAllTheirFrames) {
  const std::vector<double> one{1.0, 2.0, 6.0};
  const std::vector<double> other{-3.0, 10.0};
  const std::vector<FeatureStatistics> parts{{.components = measure(one), .count = 3},
                                             {.components = measure(other), .count = 2}};
  const FeatureStatistics whole = aggregate(parts);
  const ValueStatistics expected = measure({1.0, 2.0, 6.0, -3.0, 10.0}).front();
  EXPECT_EQ(whole.count, 5);
  EXPECT_EQ(whole.components[0].min, -3.0);
  EXPECT_EQ(whole.components[0].max, 10.0);
  EXPECT_NEAR(whole.components[0].mean, expected.mean, 1e-12);
  EXPECT_NEAR(whole.components[0].deviation, expected.deviation, 1e-12);
}

TEST(ImageStatistics, SampleEvenlyInBoundedMemory) {
  ImageStatistics statistics;
  Frame frame{.index = 0, .time = {}, .size = {.width = 16, .height = 16}, .rgb = {}};
  for (int i = 0; i < 2000; ++i) {
    frame.rgb.assign(16 * 16 * 3, static_cast<std::uint8_t>(i * 255 / 1999));
    statistics.see(frame);
  }
  const FeatureStatistics found = statistics.finish();
  EXPECT_LE(found.count, 256);
  EXPECT_GE(found.count, 128);
  for (const ValueStatistics& value : found.components) {
    EXPECT_NEAR(value.mean, 0.5, 0.01);
    EXPECT_NEAR(value.quantiles[1], 0.1, 0.02);
    EXPECT_NEAR(value.quantiles[3], 0.9, 0.02);
  }
}

}  // namespace
}  // namespace pacer::dataset
