// SPDX-License-Identifier: Apache-2.0
#include "apps/progress.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace pacer {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;

/// A stream into memory, and a clock that tests set.
class ProgressTest : public ::testing::Test {
 protected:
  ProgressTest() : out_(open_memstream(&text_, &size_)) {}
  ~ProgressTest() override {
    std::fclose(out_);
    std::free(text_);  // NOLINT(cppcoreguidelines-no-malloc): open_memstream allocates with malloc
  }
  [[nodiscard]] std::string written() const {
    std::fflush(out_);
    return {text_, size_};
  }
  [[nodiscard]] Progress::Clock clock() {
    return [this] { return now_; };
  }

  char* text_ = nullptr;
  std::size_t size_ = 0;
  std::FILE* out_;
  Seconds now_{100.0};
};

TEST_F(ProgressTest, ALogGetsALineForEachTenth) {
  Progress progress(out_, "episodes", 100, ProgressStyle::kLines, clock());
  for (int i = 0; i < 100; ++i) progress.advance();
  progress.finish();
  const std::string text = written();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 10);
  EXPECT_THAT(text, Not(HasSubstr("\r")));
  EXPECT_THAT(text, EndsWith("episodes: 100 in 0 s\n"));
}

TEST_F(ProgressTest, WhatIsExpectedMayChange) {
  Progress progress(out_, "frames", 1000, ProgressStyle::kLines, clock());
  progress.expect(40);
  now_ += Seconds{10.0};
  progress.advance(20);
  EXPECT_EQ(written(), "frames: 20/40  2.0/s  10 s left\n");
}

TEST_F(ProgressTest, ASlowJobTellsALogThatItLives) {
  Progress progress(out_, "frames", 1000, ProgressStyle::kLines, clock());
  progress.advance();
  EXPECT_EQ(written(), "");
  now_ += Seconds{40.0};
  progress.advance();
  EXPECT_EQ(written(), "frames: 2/1000  20 s each  5:32:40 left\n");
}

TEST_F(ProgressTest, AStreamThatIsNoTerminalGetsLines) {
  Progress progress(out_, "frames", 2, ProgressStyle::kAuto, clock());
  progress.advance();
  EXPECT_EQ(written(), "frames: 1/2\n");
}

TEST_F(ProgressTest, ABarShowsShareRateAndTimeLeft) {
  Progress progress(out_, "frames", 200, ProgressStyle::kBar, clock());
  now_ += Seconds{2.0};
  progress.advance(50);
  EXPECT_EQ(written(),
            "\rframes  25 % [#######-----------------------]  50/200  25.0/s  6 s left\x1b[K");
}

TEST_F(ProgressTest, ABarIsDrawnAtMostTenTimesASecond) {
  Progress progress(out_, "frames", 1000, ProgressStyle::kBar, clock());
  for (int i = 0; i < 1000; ++i) {
    now_ += Seconds{0.001};
    progress.advance();
  }
  const std::string text = written();
  EXPECT_LE(std::count(text.begin(), text.end(), '\r'), 11);
}

TEST_F(ProgressTest, ResumedWorkCountsButNotForTheRate) {
  Progress progress(out_, "episodes", 100, ProgressStyle::kBar, clock());
  progress.resume_from(50);
  now_ += Seconds{10.0};
  progress.advance(10);
  EXPECT_THAT(written(), HasSubstr("60/100  1.0/s  40 s left"));
}

TEST_F(ProgressTest, ANoteStandsAboveTheBar) {
  Progress progress(out_, "episodes", 4, ProgressStyle::kBar, clock());
  progress.advance();
  progress.note("episode 1: lead lost");
  EXPECT_THAT(written(), HasSubstr("\r\x1b[Kepisode 1: lead lost\n\repisodes"));
}

TEST_F(ProgressTest, AnUnknownTotalIsOnlyCounted) {
  Progress progress(out_, "frames", 0, ProgressStyle::kBar, clock());
  now_ += Seconds{1.0};
  progress.advance(30);
  EXPECT_EQ(written(), "\rframes  30  30.0/s\x1b[K");
}

TEST_F(ProgressTest, MoreThanTheTotalStaysAFullBar) {
  Progress progress(out_, "frames", 10, ProgressStyle::kBar, clock());
  progress.advance(25);
  EXPECT_THAT(written(), HasSubstr("100 % [##############################]  25/10"));
}

TEST_F(ProgressTest, AJobCutShortEndsItsLine) {
  {
    Progress progress(out_, "frames", 10, ProgressStyle::kBar, clock());
    progress.advance();
  }
  EXPECT_THAT(written(), EndsWith("\n"));
}

TEST_F(ProgressTest, NothingIsShownAfterTheEnd) {
  Progress progress(out_, "frames", 10, ProgressStyle::kBar, clock());
  progress.finish();
  const std::string text = written();
  progress.advance();
  progress.finish();
  EXPECT_EQ(written(), text);
}

TEST_F(ProgressTest, ThreadsLoseNoCount) {
  Progress progress(out_, "frames", 4000, ProgressStyle::kLines, clock());
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&progress] {
      for (int i = 0; i < 1000; ++i) progress.advance();
    });
  }
  for (std::thread& thread : threads) thread.join();
  progress.finish();
  EXPECT_THAT(written(), EndsWith("frames: 4000 in 0 s\n"));
}

}  // namespace
}  // namespace pacer
