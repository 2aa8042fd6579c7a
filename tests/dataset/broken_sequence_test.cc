// SPDX-License-Identifier: Apache-2.0
// Sequences with something wrong: each is refused with one line that names the file.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include "dataset/sequence.h"
#include "tests/dataset/made_up_sequence.h"

namespace pacer::dataset {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using testing::complaint;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::lines_of_boxes;
using ::testing::Not;
using testing::Scratch;
using ::testing::SizeIs;
using ::testing::StartsWith;
using testing::write_file;
using testing::write_pictures;

class BrokenSequences : public ::testing::Test {
 protected:
  [[nodiscard]] std::string complaint_about(const std::string& name) const {
    std::string line = complaint([&] { static_cast<void>(Sequence::open(scratch_ / name)); });
    EXPECT_THAT(line, StartsWith((scratch_ / name).string()));
    EXPECT_THAT(line, Not(HasSubstr("\n")));
    return line;
  }

  Scratch scratch_;
};

TEST_F(BrokenSequences, PropertiesDoNotLeadOutOfTheFolder) {
  write_pictures(scratch_ / "outside", "{:08d}.jpg", 2);
  write_file(scratch_ / "S/groundtruth.txt", lines_of_boxes(2));
  const std::string outside = (scratch_ / "outside").string();
  for (const std::string place :
       {"../outside", "a/../../outside", "..\\outside", outside.c_str()}) {
    for (const char* name : {"", "/", "/%08d.jpg"}) {
      write_file(scratch_ / "S/sequence", "channels.color=" + place + name);
      EXPECT_THAT(complaint_about("S"), HasSubstr("leads out")) << place << name;
    }
  }
}

TEST_F(BrokenSequences, DamagedPropertiesAreNamedByTheirLine) {
  write_pictures(scratch_ / "S", "color/{:08d}.jpg", 2);
  write_file(scratch_ / "S/groundtruth.txt", lines_of_boxes(2));
  write_file(scratch_ / "S/sequence", "name=S\ngarbage\n");
  EXPECT_THAT(complaint_about("S"), HasSubstr("sequence:2: no key=value"));
  write_file(scratch_ / "S/sequence", std::string("name=\0\n", 7));
  EXPECT_THAT(complaint_about("S"), HasSubstr("sequence:1: no key=value"));
  write_file(scratch_ / "S/sequence", "channels.color=color/%s%n.jpg\n");
  EXPECT_THAT(complaint_about("S"), HasSubstr("is no pattern"));
  write_file(scratch_ / "S/sequence", "channels.color=colour/\n");
  EXPECT_THAT(complaint_about("S"), HasSubstr("is no folder"));
  write_file(scratch_ / "S/sequence", std::string(100'000, 'x'));
  EXPECT_THAT(complaint_about("S"), HasSubstr("larger than"));
}

TEST_F(BrokenSequences, WhatIsWrongWithAFolderIsSaidInOneLine) {
  fs::create_directories(scratch_ / "empty");
  EXPECT_THAT(complaint_about("empty"), HasSubstr("neither pictures nor annotations"));
  EXPECT_THAT(complaint_about("empty"), HasSubstr("groundtruth_rect.txt"));
  EXPECT_THAT(complaint_about("nowhere"), HasSubstr("there is no such folder or file"));

  for (const char* truth : {"groundtruth_rect.txt", "groundtruth.txt", "gt.txt"}) {
    const fs::path folder = scratch_ / truth;
    write_file(folder / truth, lines_of_boxes(2));
    EXPECT_THAT(complaint_about(truth), HasSubstr("no pictures"));
    write_pictures(folder, "{:08d}.jpg", 2);
    EXPECT_EQ(complaint([&] { static_cast<void>(Sequence::open(folder)); }), "");
    write_file(folder / truth, "");
    EXPECT_THAT(complaint_about(truth), HasSubstr("is empty"));
    write_file(folder / truth, "1,2,3\n");
    EXPECT_THAT(complaint_about(truth), HasSubstr(fmt::format("{}:1: 3 numbers", truth)));
    write_file(folder / truth, lines_of_boxes(3));
    EXPECT_THAT(complaint_about(truth), HasSubstr(fmt::format("{}:3: a line for", truth)));
    write_file(folder / truth, std::string(100, '\0'));
    EXPECT_THAT(complaint_about(truth), HasSubstr(fmt::format("{}:1: ", truth)));
  }
}

TEST_F(BrokenSequences, APictureThatIsMissingIsMissed) {
  write_pictures(scratch_ / "S", "img/{:04d}.jpg", 5);
  fs::remove(scratch_ / "S/img/0003.jpg");
  write_file(scratch_ / "S/groundtruth_rect.txt", lines_of_boxes(5));
  EXPECT_THAT(complaint_about("S"), AllOf(HasSubstr("missing after"), HasSubstr("0002.jpg")));
  write_file(scratch_ / "S/groundtruth_rect.txt", lines_of_boxes(3));
  EXPECT_THAT(complaint_about("S"), HasSubstr("missing after"));
  write_file(scratch_ / "S/groundtruth_rect.txt", lines_of_boxes(4));
  EXPECT_THAT(Sequence::open(scratch_ / "S").targets.at(0).boxes, SizeIs(4)) << "thinned out";
  write_file(scratch_ / "S/groundtruth_rect.txt", lines_of_boxes(2));
  EXPECT_THAT(Sequence::open(scratch_ / "S").targets.at(0).boxes, SizeIs(4)) << "not annotated";
}

TEST_F(BrokenSequences, PicturesOfTwoKindsAreNotMixed) {
  write_pictures(scratch_ / "S", "img/{:04d}.jpg", 3);
  write_pictures(scratch_ / "S", "img/{:04d}.png", 1, 2);
  write_file(scratch_ / "S/groundtruth_rect.txt", lines_of_boxes(3));
  EXPECT_THAT(complaint_about("S"), HasSubstr("0002.jpg and 0002.png have the same number"));
  write_pictures(scratch_ / "T", "img/left{:04d}.jpg", 3);
  write_pictures(scratch_ / "T", "img/right{:04d}.jpg", 3);
  write_file(scratch_ / "T/groundtruth_rect.txt", lines_of_boxes(3));
  EXPECT_THAT(complaint_about("T"), HasSubstr("two kinds"));
}

TEST_F(BrokenSequences, ALabelForMorePicturesThanThereAreIsRefused) {
  write_pictures(scratch_ / "S", "{:08d}.jpg", 2);
  write_file(scratch_ / "S/groundtruth.txt", lines_of_boxes(2));
  write_file(scratch_ / "S/absence.label", "0\n0\n1\n");
  EXPECT_THAT(complaint_about("S"), HasSubstr("absence.label:3: "));
}

TEST_F(BrokenSequences, AFileTooLargeIsNotRead) {
  write_pictures(scratch_ / "S", "img/{:04d}.jpg", 2);
  write_file(scratch_ / "S/groundtruth_rect.txt", lines_of_boxes(2));
  fs::resize_file(scratch_ / "S/groundtruth_rect.txt", 5ULL << 30U);  // takes no disk
  EXPECT_THAT(complaint_about("S"), HasSubstr("larger than"));
}

TEST_F(BrokenSequences, WhatIsNoPlainFileIsNotRead) {
  write_pictures(scratch_ / "S", "img/{:04d}.jpg", 2);
  ASSERT_EQ(::mkfifo((scratch_ / "S/img/0003.jpg").c_str(), 0600), 0);
  write_file(scratch_ / "S/groundtruth_rect.txt", lines_of_boxes(2));
  EXPECT_THAT(Sequence::open(scratch_ / "S").pictures, SizeIs(2));
  fs::remove(scratch_ / "S/groundtruth_rect.txt");
  ASSERT_EQ(::mkfifo((scratch_ / "S/groundtruth_rect.txt").c_str(), 0600), 0);
  EXPECT_THAT(Sequence::open(scratch_ / "S").targets, IsEmpty());
  EXPECT_THAT(complaint_about("S/groundtruth_rect.txt"), HasSubstr("neither a folder nor"));
}

TEST_F(BrokenSequences, WhatIsNoVideoIsNamed) {
  write_file(scratch_ / "notes.txt", lines_of_boxes(300));
  EXPECT_THAT(complaint_about("notes.txt"), HasSubstr("not a readable video: it is a text"));
  write_file(scratch_ / "cut.mp4", "");
  EXPECT_THAT(complaint_about("cut.mp4"), HasSubstr("not a readable video"));
  write_file(scratch_ / "S/gt.txt", lines_of_boxes(2));
  write_file(scratch_ / "S/a.avi", "garbage");
  EXPECT_THAT(complaint_about("S"), HasSubstr("a.avi: not a readable video"));
  write_file(scratch_ / "S/b.avi", "garbage");
  EXPECT_THAT(complaint_about("S"), HasSubstr("two videos, a.avi and b.avi"));
}

}  // namespace
}  // namespace pacer::dataset
