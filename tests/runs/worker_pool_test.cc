// SPDX-License-Identifier: Apache-2.0
#include "runs/worker_pool.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <numeric>
#include <thread>
#include <vector>

namespace pacer {
namespace {

std::vector<std::uint32_t> first(std::uint32_t count) {
  std::vector<std::uint32_t> indices(count);
  std::iota(indices.begin(), indices.end(), 0U);
  return indices;
}

std::vector<std::string> squares(int jobs) {
  std::vector<std::string> results;
  const bool whole = run_in_workers(
      jobs, first(50), [](std::uint32_t i) { return std::to_string(i * i); },
      [&](std::uint32_t i, std::string text) {
        EXPECT_EQ(i, results.size()) << "in order";
        results.push_back(std::move(text));
      },
      {});
  EXPECT_TRUE(whole);
  return results;
}

TEST(WorkerPool, ResultsDoNotDependOnTheNumberOfWorkers) {
  const std::vector<std::string> alone = squares(1);
  ASSERT_EQ(alone.size(), 50U);
  EXPECT_EQ(alone[7], "49");
  EXPECT_EQ(squares(2), alone);
  EXPECT_EQ(squares(5), alone);
}

TEST(WorkerPool, CarriesResultsLargerThanAPipe) {
  std::size_t size = 0;
  run_in_workers(
      2, first(1), [](std::uint32_t) { return std::string(3'000'000, 'x'); },
      [&](std::uint32_t, const std::string& text) { size = text.size(); }, {});
  EXPECT_EQ(size, 3'000'000U);
}

TEST(WorkerPool, ATaskThatThrowsIsReportedInItsOwnWords) {
  const auto fail = [](std::uint32_t i) -> std::string {
    if (i == 3) throw std::runtime_error("no camera at 3");
    return "";
  };
  try {
    run_in_workers(2, first(10), fail, [](std::uint32_t, const std::string&) {}, {});
    FAIL() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "no camera at 3");
  }
}

TEST(WorkerPool, AWorkerThatDiesIsReportedWithItsIndex) {
  const auto die = [](std::uint32_t i) -> std::string {
    if (i == 2) ::raise(SIGKILL);
    return "";
  };
  try {
    run_in_workers(1, first(10), die, [](std::uint32_t, const std::string&) {}, {});
    FAIL() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("signal 9 at number 2"));
  }
}

TEST(WorkerPool, AStopEndsItAndKeepsWhatWasDone) {
  std::stop_source stop;
  std::uint32_t done = 0;
  const auto slow = [](std::uint32_t i) -> std::string {
    if (i >= 2) std::this_thread::sleep_for(std::chrono::seconds{30});
    return "";
  };
  const bool whole = run_in_workers(
      2, first(10), slow,
      [&](std::uint32_t, const std::string&) {
        if (++done == 2) stop.request_stop();
      },
      stop.get_token());
  EXPECT_FALSE(whole);
  EXPECT_EQ(done, 2U);
}

}  // namespace
}  // namespace pacer
