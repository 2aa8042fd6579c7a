// SPDX-License-Identifier: Apache-2.0
#include "runs/tracking/results_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <stdexcept>

#include "core/random.h"
#include "tests/support/scratch.h"

namespace pacer {
namespace {

using tracking::Track;

std::filesystem::path written(const testing::Scratch& scratch, const std::string& text) {
  std::ofstream(scratch / "results.txt", std::ios::binary) << text;
  return scratch / "results.txt";
}

TEST(ResultsFile, CountsPixelsFromOne) {
  const std::vector<Track> tracks = {{.box = Box::of_pixels(0.0, 4.0, 10.0, 20.0)},
                                     {.box = Box::of_pixels(-2.5, 0.25, 10.5, 1.0)}};
  EXPECT_EQ(results_text(0, tracks), "1,5,10,20\n-1.5,1.25,10.5,1\n");
}

TEST(ResultsFile, HasALineForEachPictureBeforeTheStart) {
  const std::vector<Track> tracks = {{.box = Box::of_pixels(0, 0, 2, 2)}};
  EXPECT_EQ(results_text(2, tracks), "NaN,NaN,NaN,NaN\nNaN,NaN,NaN,NaN\n1,1,2,2\n");
}

TEST(ResultsFile, ReadsBackWhatWasWritten) {
  const testing::Scratch scratch;
  Random random(1);
  std::vector<Track> tracks;
  for (int i = 0; i < 200; ++i) {
    tracks.push_back({.box = {random.uniform(-500, 2000), random.uniform(-500, 2000),
                              random.uniform(0.01, 900), random.uniform(0.01, 900)}});
  }
  tracks.push_back({.box = {NAN, 1, 2, 3}});
  const auto boxes = read_results(written(scratch, results_text(3, tracks)));
  ASSERT_EQ(boxes.size(), 204U);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_FALSE(boxes[i]);
  EXPECT_FALSE(boxes.back());
  for (std::size_t i = 0; i < 200; ++i) {
    ASSERT_TRUE(boxes[i + 3]);
    EXPECT_NEAR(boxes[i + 3]->x, tracks[i].box.x, 1e-4);
    EXPECT_NEAR(boxes[i + 3]->height, tracks[i].box.height, 1e-4);
  }
}

TEST(ResultsFile, ReadsWhatOtherProgramsWrite) {
  const testing::Scratch scratch;
  const auto boxes =
      read_results(written(scratch, "1,2,3,4\r\n1\t2\t3\t4\n 1 2  3 4 \n1, 2, 3, 4"));
  ASSERT_EQ(boxes.size(), 4U);
  for (const auto& box : boxes) EXPECT_EQ(box, Box::of_pixels(0, 1, 3, 4));
}

TEST(ResultsFile, NamesTheLineThatIsNone) {
  const testing::Scratch scratch;
  for (const char* text :
       {"1,2,3,4\n1,2,3\n", "1,2,3,4\n1,2,3,4,5\n", "1,2,3,4\n1,2,x,4\n", "1,2,3,4\n1,2,3,4z\n"}) {
    try {
      (void)read_results(written(scratch, text));
      FAIL() << text;
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find("results.txt:2: "), std::string::npos)
          << error.what();
    }
  }
  EXPECT_THROW((void)read_results(scratch / "missing"), std::runtime_error);
}

}  // namespace
}  // namespace pacer
