// SPDX-License-Identifier: Apache-2.0
#include "core/output_file.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/support/scratch.h"

namespace pacer {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using testing::Scratch;

std::string text_of(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void put(const fs::path& file, const std::string& text) { std::ofstream(file) << text; }

TEST(OutputFile, LeavesNoFolderBehindWhenItIsNotKept) {
  const Scratch scratch;
  { const OutputFile file(scratch / "a" / "b" / "result"); }
  EXPECT_FALSE(fs::exists(scratch / "a"));
  fs::create_directory(scratch / "a");
  { const OutputFile file(scratch / "a" / "b" / "result"); }
  EXPECT_TRUE(fs::is_empty(scratch / "a")) << "it was there before";
  {
    const OutputFile file(scratch / "a" / "b" / "result");
    put(scratch / "a" / "b" / "another", "of somebody else");
  }
  EXPECT_EQ(text_of(scratch / "a" / "b" / "another"), "of somebody else");
}

TEST(OutputFile, TakesThePlaceOfTheOldOneOnlyWhenItIsKept) {
  const Scratch scratch;
  const fs::path place = scratch / "result";
  put(place, "old");
  {
    OutputFile file(place);
    file.write("new");
    EXPECT_EQ(text_of(place), "old");
  }
  EXPECT_EQ(text_of(place), "old");
  {
    OutputFile file(place);
    file.write("new");
    file.keep();
  }
  EXPECT_EQ(text_of(place), "new");
  EXPECT_EQ(std::distance(fs::directory_iterator(scratch.path()), {}), 1) << "nothing is left";
}

TEST(OutputFile, TakesABareName) {
  const Scratch scratch;
  const fs::path before = fs::current_path();
  fs::current_path(scratch.path());
  OutputFile file("bare");
  file.write("x");
  file.keep();
  fs::current_path(before);
  EXPECT_EQ(text_of(scratch / "bare"), "x");
}

TEST(OutputFile, MakesTheFoldersAboveIt) {
  const Scratch scratch;
  OutputFile file(scratch / "a/b/result");
  file.write("x");
  file.keep();
  EXPECT_EQ(text_of(scratch / "a/b/result"), "x");
}

TEST(OutputFile, RefusesAPlaceThatCannotBeWrittenBeforeTheWork) {
  const Scratch scratch;
  put(scratch / "file", "not a folder");
  for (const fs::path& place : {scratch.path(), scratch / "file/result", fs::path()}) {
    EXPECT_THAT([&] { const OutputFile file(place); },
                ::testing::ThrowsMessage<std::runtime_error>(
                    HasSubstr(place.string() + ": cannot be written: ")));
  }
}

TEST(OutputFile, LeavesADeviceWhatItIs) {
  OutputFile file("/dev/full");
  EXPECT_THAT([&] { file.write("x"); },
              ::testing::ThrowsMessage<std::runtime_error>(HasSubstr("No space left")));
  file.keep();
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST(OutputFile, AddsToWhatSomebodyElseHasOpen) {
  const Scratch scratch;
  put(scratch / "log", "before ");
  const int descriptor = ::open((scratch / "log").c_str(), O_WRONLY | O_CLOEXEC);
  {
    OutputFile file("/proc/self/fd/" + std::to_string(descriptor));  // as /dev/stdout may be
    file.write("after");
    file.keep();
  }
  ::close(descriptor);
  EXPECT_EQ(text_of(scratch / "log"), "before after");
}

TEST(OutputFile, ALinkStaysALink) {
  const Scratch scratch;
  put(scratch / "real", "old");
  fs::create_symlink("real", scratch / "link");
  OutputFile file(scratch / "link");
  file.write("new");
  file.keep();
  EXPECT_TRUE(fs::is_symlink(scratch / "link"));
  EXPECT_EQ(text_of(scratch / "real"), "new");
}

}  // namespace
}  // namespace pacer
