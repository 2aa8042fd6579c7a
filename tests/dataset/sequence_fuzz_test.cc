// SPDX-License-Identifier: Apache-2.0
// Files that are damaged at random, seeded: each is read, or refused with one clear line.
#include <gmock/gmock.h>

#include "core/random.h"
#include "dataset/sequence.h"
#include "dataset/sequence_annotation.h"
#include "tests/dataset/made_up_sequence.h"

namespace pacer::dataset {
namespace {

using testing::encoded_picture;
using ::testing::HasSubstr;
using testing::lines_of_boxes;
using ::testing::Not;
using testing::Scratch;
using ::testing::StartsWith;
using testing::write_file;
using testing::write_pictures;
using enum SequenceLayout;

constexpr const char* kPieces[] = {"NaN",
                                   "inf",
                                   "-inf",
                                   "1e999",
                                   "-",
                                   "m",
                                   "m0,0,9,9,0,81",
                                   ",",
                                   ",,",
                                   "\t",
                                   "\r\n",
                                   "\n\n",
                                   "99999999999999999999",
                                   "0x10",
                                   "1e-400",
                                   "-0",
                                   ".",
                                   "=",
                                   "%08d",
                                   "../",
                                   "\xEF\xBB\xBF"};

std::string damaged(std::string bytes, Random& random) {
  const std::uint64_t wounds = 1 + random.below(4);
  for (std::uint64_t i = 0; i < wounds && !bytes.empty(); ++i) {
    const std::size_t at = random.below(bytes.size());
    const std::size_t length = 1 + random.below(8);
    switch (random.below(6)) {
      case 0:
        bytes[at] = static_cast<char>(random.below(256));
        break;
      case 1:
        bytes.erase(at, length);
        break;
      case 2:
        bytes.insert(at, kPieces[random.below(std::size(kPieces))]);
        break;
      case 3:
        bytes.insert(at, bytes.substr(random.below(bytes.size()), 4 * length));
        break;
      case 4:
        bytes.resize(at);
        break;
      default:
        bytes.insert(at, length, '\0');
    }
  }
  return bytes;
}

void expect_sound(const std::vector<std::optional<Box>>& boxes, const std::string& from) {
  for (const auto& box : boxes) {
    if (!box) continue;
    EXPECT_TRUE(is_proper(*box)) << from;
    EXPECT_LT(std::abs(box->x) + std::abs(box->y) + box->width + box->height, 1e7) << from;
  }
}

TEST(SequenceFuzz, DamagedAnnotationsAreReadOrRefused) {
  const std::pair<SequenceLayout, const char*> whole[] = {
      {kOtb,
       "70\t51\t107\t87\r\n70 51 107 87\r\n71,52,108,88\r\nNaN,NaN,NaN,NaN\r\n-3,4,10,11\r\n"},
      {kVot, "1.5,2,30,40\n5,1,9,4,6,8,2,5\nm10,20,4,3,2,1,4,2\nnan,nan,nan,nan\n0\n"},
      {kGot10k, "347.0000,443.0000,429.0000,272.0000\n-1,-1,-1,-1\n1,2,3,4\n"},
      {kTld, "165,83,225,136\nNaN,NaN,NaN,NaN\n166,84,226,137\n"}};
  int read = 0, refused = 0;
  for (const auto& [layout, text] : whole) {
    const Random stream = Random(17).fork(text);
    for (std::uint64_t i = 0; i < 20'000; ++i) {
      Random random = stream.fork("damage", i);
      const std::string bytes = damaged(text, random);
      try {
        expect_sound(parse_boxes(bytes, layout, "truth.txt"), bytes);
        ++read;
      } catch (const std::runtime_error& error) {
        ASSERT_THAT(error.what(), StartsWith("truth.txt:"));
        ASSERT_THAT(error.what(), Not(HasSubstr("\n")));
        ++refused;
      }
    }
  }
  EXPECT_GT(read, 2'000);
  EXPECT_GT(refused, 20'000);
}

TEST(SequenceFuzz, DamagedFoldersAreReadOrRefused) {
  const Scratch scratch;
  write_pictures(scratch / "vot", "color/{:08d}.jpg", 3);
  write_pictures(scratch / "got", "{:08d}.jpg", 3);
  const std::tuple<const char*, const char*, std::string> files[] = {
      {"vot", "groundtruth.txt", lines_of_boxes(3)},
      {"vot", "sequence", "name=S\nfps=30\nchannels.color=color/%08d.jpg\nlength=3\n"},
      {"got", "groundtruth.txt", lines_of_boxes(3)},
      {"got", "absence.label", "0\n1\n0\n"},
      {"got", "cover.label", "8\n0\n8\n"}};
  for (const auto& [folder, name, text] : files) write_file(scratch / folder / name, text);
  for (const auto& [folder, name, text] : files) {
    const Random stream = Random(18).fork(text);
    for (std::uint64_t i = 0; i < 100; ++i) {
      Random random = stream.fork("damage", i);
      write_file(scratch / folder / name, damaged(text, random));
      try {
        const Sequence sequence = Sequence::open(scratch / folder);
        ASSERT_EQ(sequence.targets.at(0).boxes.size(), sequence.pictures.size());
        expect_sound(sequence.targets[0].boxes, folder);
      } catch (const std::runtime_error& error) {
        ASSERT_THAT(error.what(), StartsWith(scratch.path().string()));
        ASSERT_THAT(error.what(), Not(HasSubstr("\n")));
      }
    }
    write_file(scratch / folder / name, text);
  }
}

TEST(SequenceFuzz, DamagedPicturesAreReadOrRefused) {
  const Scratch scratch;
  for (const char* extension : {".jpg", ".png", ".bmp", ".ppm"}) {
    const std::string whole = encoded_picture(extension);
    Sequence sequence;
    sequence.pictures = {scratch / "1"};
    cv::Mat picture;
    const Random stream = Random(19).fork(extension);
    for (std::uint64_t i = 0; i < 200; ++i) {
      Random random = stream.fork("damage", i);
      write_file(scratch / "1", damaged(whole, random));
      try {
        ASSERT_TRUE(read_pictures(sequence)->next(picture));
        ASSERT_FALSE(picture.empty());
        ASSERT_LE(picture.total(), 8192U * 8192U);
      } catch (const std::runtime_error& error) {
        ASSERT_THAT(error.what(), StartsWith((scratch / "1").string()));
        ASSERT_THAT(error.what(), Not(HasSubstr("\n")));
      }
    }
  }
}

}  // namespace
}  // namespace pacer::dataset
