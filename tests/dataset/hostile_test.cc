// SPDX-License-Identifier: Apache-2.0
// Files that were cut short, overwritten or made to harm: each is a clear line, never a crash.
#include <gmock/gmock.h>
#include <sys/resource.h>

#include <fstream>

#include "core/check.h"
#include "dataset/demonstration.h"
#include "dataset/inspect.h"
#include "dataset/table.h"
#include "dataset/video.h"
#include "tests/dataset/recording.h"

namespace pacer::dataset {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using testing::record_dataset;
using testing::Scratch;
using testing::small_spec;

constexpr const char* kFiles[] = {"meta/info.json",
                                  "meta/stats.json",
                                  "meta/hashes.json",
                                  "meta/tasks.parquet",
                                  "meta/episodes/chunk-000/file-000.parquet",
                                  "data/chunk-000/file-000.parquet",
                                  "videos/observation.images.front/chunk-000/file-000.mp4"};

void overwrite(const fs::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
}

/// Reads everything there is to read; a clear exception is fine, anything else is not.
void read_everything(const fs::path& root) {
  try {
    const RecordedDemonstration demonstration(root);
    for (std::size_t i = 0; i < demonstration.episode_count(); ++i) {
      const auto stream = demonstration.open(i);
      while (stream->next() != nullptr) {
      }
    }
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr(root.string())) << "the line names the file";
    EXPECT_THAT(error.what(), Not(HasSubstr("\n")));
  }
  static_cast<void>(inspect(root));
}

class Hostile : public ::testing::Test {
 protected:
  Hostile() { record_dataset(scratch_ / "set", small_spec(), 1, 8); }

  Scratch scratch_;
  fs::path root_ = scratch_ / "set";
};

TEST_F(Hostile, EveryFileCutShortIsFound) {
  for (const char* file : kFiles) {
    const std::string whole = read_text(root_ / file);
    for (const double part : {0.0, 0.3, 0.9}) {
      overwrite(
          root_ / file,
          whole.substr(0, static_cast<std::size_t>(part * static_cast<double>(whole.size()))));
      read_everything(root_);
      EXPECT_FALSE(inspect(root_).whole()) << file << " cut to " << part;
    }
    overwrite(root_ / file, whole);
  }
  EXPECT_TRUE(inspect(root_).whole());
}

TEST_F(Hostile, FlippedBytesAreAnExceptionOrAnotherValueButNoCrash) {
  Random random(5);
  for (const char* file : kFiles) {
    const std::string whole = read_text(root_ / file);
    for (int i = 0; i < 12; ++i) {
      std::string bytes = whole;
      for (int flip = 0; flip < 4; ++flip) {
        bytes[random.below(bytes.size())] = static_cast<char>(random.below(256));
      }
      overwrite(root_ / file, bytes);
      read_everything(root_);
    }
    overwrite(root_ / file, whole);
  }
}

TEST_F(Hostile, FalseSizesInTheInfoAreRefused) {
  const std::string whole = read_text(root_ / "meta/info.json");
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = whole;
    text.replace(text.find(from), from.size(), to);
    overwrite(root_ / "meta/info.json", text);
    read_everything(root_);
    return inspect(root_).whole();
  };
  EXPECT_FALSE(with("\"total_frames\": 8", "\"total_frames\": 9223372036854775807"));
  EXPECT_FALSE(with("\"total_episodes\": 1", "\"total_episodes\": -1"));
  EXPECT_FALSE(with("\"fps\": 25", "\"fps\": 0"));
  EXPECT_FALSE(with("\"fps\": 25", "\"fps\": \"fast\""));
  EXPECT_FALSE(with("v3.0", "v2.1"));
  EXPECT_FALSE(with("observation.images.front", "../../../../etc"));
}

TEST_F(Hostile, NamesTheColumnThatIsMissing) {
  const fs::path path = scratch_ / "other.parquet";
  const Feature column{.name = "one", .type = ValueType::kFloat32, .width = 2, .components = {}};
  {
    TableWriter table(path, {column});
    table.append(std::vector<double>{1.0, 2.0});
    table.close();
  }
  EXPECT_THROW((TableReader(path, {{.name = "two", .components = {}}})), std::runtime_error);
  TableReader narrow(path, {{.name = "one", .components = {}}});
  EXPECT_THROW(static_cast<void>(narrow.next()), std::runtime_error) << "one value, not two";
  TableReader good(path, {column});
  EXPECT_THAT(good.next(), ::testing::ElementsAre(1.0, 2.0));
  EXPECT_THAT(good.next(), IsEmpty());
}

TEST_F(Hostile, AVideoOfAnotherSizeIsRefused) {
  const fs::path video = root_ / "videos/observation.images.front/chunk-000/file-000.mp4";
  VideoEncoder encoder(video, {.width = 32, .height = 32}, 25);
  Frame frame{.index = 0, .time = {}, .size = {.width = 32, .height = 32}, .rgb = {}};
  frame.rgb.assign(32 * 32 * 3, 100);
  for (int i = 0; i < 8; ++i) encoder.write(frame);
  encoder.close();
  EXPECT_THROW(static_cast<void>(RecordedDemonstration(root_).open(0)), std::runtime_error);
  EXPECT_FALSE(inspect(root_).whole());
}

}  // namespace
}  // namespace pacer::dataset
