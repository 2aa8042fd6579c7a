// SPDX-License-Identifier: Apache-2.0
#include "dataset/sequence.h"

#include <gmock/gmock.h>

#include <map>

#include "core/check.h"
#include "dataset/video.h"
#include "tests/dataset/made_up_sequence.h"

namespace pacer::dataset {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using testing::complaint;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::Eq;
using ::testing::IsEmpty;
using testing::lines_of_boxes;
using ::testing::Not;
using testing::Scratch;
using ::testing::SizeIs;
using ::testing::StartsWith;
using testing::write_file;
using testing::write_pictures;

/// The box of line `i` of lines_of_boxes(), where pixels count from `base`.
Box box_of_line(int i, int base) { return Box::of_pixels(i - base, i - base, 10, 20); }

class Sequences : public ::testing::Test {
 protected:
  Scratch scratch_;
};

TEST_F(Sequences, OtbIsRead) {
  write_pictures(scratch_ / "Boy", "img/{:04d}.jpg", 3);
  write_file(scratch_ / "Boy/groundtruth_rect.txt", lines_of_boxes(3));
  const Sequence sequence = Sequence::open(scratch_ / "Boy/");
  EXPECT_EQ(sequence.name, "Boy");
  EXPECT_EQ(sequence.layout, SequenceLayout::kOtb);
  EXPECT_THAT(sequence.pictures,
              ElementsAre(scratch_ / "Boy/img/0001.jpg", scratch_ / "Boy/img/0002.jpg",
                          scratch_ / "Boy/img/0003.jpg"));
  ASSERT_THAT(sequence.targets, SizeIs(1));
  EXPECT_EQ(sequence.targets[0].name, "");
  EXPECT_THAT(sequence.targets[0].boxes,
              ElementsAre(box_of_line(1, 1), box_of_line(2, 1), box_of_line(3, 1)));
}

TEST_F(Sequences, PicturesAreInTheOrderOfTheirNumbersWhateverTheirKind) {
  write_pictures(scratch_ / "S", "img/{}.PNG", 11, 5);  // 10.PNG sorts before 9.PNG as text
  write_file(scratch_ / "S/img/Thumbs.db", "no picture");
  write_file(scratch_ / "S/img/._5.PNG", "no picture");
  write_file(scratch_ / "S/groundtruth_rect.txt", lines_of_boxes(11));
  const Sequence sequence = Sequence::open(scratch_ / "S");
  ASSERT_THAT(sequence.pictures, SizeIs(11));
  EXPECT_EQ(sequence.pictures.front().filename(), "5.PNG");
  EXPECT_EQ(sequence.pictures.back().filename(), "15.PNG");
}

TEST_F(Sequences, PicturesMayHaveLettersBeforeTheirNumbers) {
  write_pictures(scratch_ / "S", "img/frame{}.png", 11);
  write_file(scratch_ / "S/img/._frame1.png", "what another system leaves behind");
  write_file(scratch_ / "S/groundtruth_rect.txt", lines_of_boxes(11));
  const Sequence sequence = Sequence::open(scratch_ / "S");
  ASSERT_THAT(sequence.pictures, SizeIs(11));
  EXPECT_EQ(sequence.pictures.back().filename(), "frame11.png");
}

TEST_F(Sequences, TwoTargetsHaveAFileEach) {
  write_pictures(scratch_ / "Jogging", "img/{:04d}.jpg", 2);
  write_file(scratch_ / "Jogging/groundtruth_rect.1.txt", lines_of_boxes(2));
  write_file(scratch_ / "Jogging/groundtruth_rect.2.txt", "7,7,10,20\nNaN,NaN,NaN,NaN\n");
  const Sequence sequence = Sequence::open(scratch_ / "Jogging");
  ASSERT_THAT(sequence.targets, SizeIs(2));
  EXPECT_EQ(sequence.targets[0].name, "1");
  EXPECT_EQ(sequence.targets[1].name, "2");
  EXPECT_THAT(sequence.targets[1].boxes, ElementsAre(box_of_line(7, 1), std::nullopt));
}

TEST_F(Sequences, AnEmptyAnnotationBesideAFullOneIsPassedOver) {
  write_pictures(scratch_ / "Human4", "img/{:04d}.jpg", 2);
  write_file(scratch_ / "Human4/groundtruth_rect.1.txt", "");
  write_file(scratch_ / "Human4/groundtruth_rect.2.txt", lines_of_boxes(2));
  const Sequence sequence = Sequence::open(scratch_ / "Human4");
  ASSERT_THAT(sequence.targets, SizeIs(1));
  EXPECT_EQ(sequence.targets[0].name, "");
}

TEST_F(Sequences, AShorterAnnotationIsOfTheFirstPictures) {
  write_pictures(scratch_ / "Freeman3", "img/{:04d}.jpg", 4);
  write_file(scratch_ / "Freeman3/groundtruth_rect.txt", lines_of_boxes(2));
  EXPECT_THAT(Sequence::open(scratch_ / "Freeman3").targets.at(0).boxes,
              ElementsAre(box_of_line(1, 1), box_of_line(2, 1), std::nullopt, std::nullopt));
}

TEST_F(Sequences, DavidsAnnotationBeginsAtItsPicture300) {
  for (const char* name : {"David", "Another"}) {
    write_pictures(scratch_ / name, "img/{:04d}.jpg", 770);
    write_file(scratch_ / name / "groundtruth_rect.txt", lines_of_boxes(471));
    const auto boxes = Sequence::open(scratch_ / name).targets.at(0).boxes;
    ASSERT_THAT(boxes, SizeIs(770));
    const std::size_t first = name == std::string("David") ? 299 : 0;
    EXPECT_EQ(boxes[first], box_of_line(1, 1));
    EXPECT_EQ(boxes[first + 470], box_of_line(471, 1));
    EXPECT_EQ(std::ranges::count(boxes, false, [](const auto& box) { return box.has_value(); }),
              299);
  }
}

TEST_F(Sequences, DavidWithoutHisLastPicturesIsLikeAnyOther) {
  write_pictures(scratch_ / "David", "img/{:04d}.jpg", 600);
  write_file(scratch_ / "David/groundtruth_rect.txt", lines_of_boxes(471));
  EXPECT_EQ(Sequence::open(scratch_ / "David").targets.at(0).boxes.at(0), box_of_line(1, 1));
}

TEST_F(Sequences, DavidCutToWhatIsAnnotatedBeginsAtItsFirstPicture) {
  write_pictures(scratch_ / "David", "img/{:04d}.jpg", 471, 300);
  write_file(scratch_ / "David/groundtruth_rect.txt", lines_of_boxes(471));
  EXPECT_EQ(Sequence::open(scratch_ / "David").targets.at(0).boxes.at(0), box_of_line(1, 1));
}

TEST_F(Sequences, VotIsReadBesideItsPicturesAndFromItsColourFolder) {
  write_pictures(scratch_ / "ball", "{:08d}.jpg", 2);
  write_file(scratch_ / "ball/groundtruth.txt", "1,1,10,20\n2,2,11,2,11,21,2,21\n");
  write_pictures(scratch_ / "bag", "color/{:08d}.jpg", 2);
  write_file(scratch_ / "bag/groundtruth.txt", "m1,1,10,20,0,200\n2,2,10,20\n");
  for (const char* name : {"ball", "bag"}) {
    const Sequence sequence = Sequence::open(scratch_ / name);
    EXPECT_EQ(sequence.layout, SequenceLayout::kVot);
    EXPECT_THAT(sequence.pictures, SizeIs(2));
    EXPECT_THAT(sequence.targets.at(0).boxes, ElementsAre(box_of_line(1, 0), box_of_line(2, 0)));
  }
}

TEST_F(Sequences, VotsPropertiesSayWhereThePicturesLie) {
  for (const char* line : {"channels.color=frames/f%06d.png", "channels.color=frames\\\\f%06d.png",
                           "channels.ir=frames/f%d.png", "channels.color=frames/"}) {
    write_pictures(scratch_ / "S", "frames/f{:06d}.png", 2);
    write_pictures(scratch_ / "S", "color/{:08d}.jpg", 5);
    write_file(scratch_ / "S/groundtruth.txt", lines_of_boxes(2));
    write_file(scratch_ / "S/sequence", fmt::format("name=S\r\nfps=30\n\n{}\n", line));
    EXPECT_THAT(Sequence::open(scratch_ / "S").pictures,
                ElementsAre(scratch_ / "S/frames/f000001.png", scratch_ / "S/frames/f000002.png"))
        << line;
  }
}

TEST_F(Sequences, VotsTargetsMayHaveAFileEach) {
  write_pictures(scratch_ / "S", "color/{:08d}.jpg", 3);
  write_file(scratch_ / "S/sequence", "channels.color=color/%08d.jpg\n");
  write_file(scratch_ / "S/groundtruth_10.txt", "m1,1,10,20,0,200\n");
  write_file(scratch_ / "S/groundtruth_2.txt", "m2,2,10,20,0,200\n");
  const Sequence sequence = Sequence::open(scratch_ / "S");
  ASSERT_THAT(sequence.targets, SizeIs(2));
  EXPECT_EQ(sequence.targets[0].name, "2");
  EXPECT_EQ(sequence.targets[1].name, "10");
  EXPECT_THAT(sequence.targets[0].boxes,
              ElementsAre(box_of_line(2, 0), std::nullopt, std::nullopt));
}

TEST_F(Sequences, Got10kIsToldFromVotByWhatLiesBesideIt) {
  for (const char* beside : {"absence.label", "cover.label", "meta_info.ini"}) {
    write_pictures(scratch_ / beside, "{:08d}.jpg", 3);
    write_file(scratch_ / beside / "groundtruth.txt", lines_of_boxes(3));
    write_file(scratch_ / beside / beside, "0\n1\n0\n");
    const Sequence sequence = Sequence::open(scratch_ / beside);
    EXPECT_EQ(sequence.layout, SequenceLayout::kGot10k);
    const bool labelled = beside == std::string("absence.label");
    EXPECT_EQ(sequence.targets.at(0).boxes[0], box_of_line(1, 1));
    EXPECT_EQ(sequence.targets.at(0).boxes[1].has_value(), !labelled);
    EXPECT_EQ(sequence.targets.at(0).boxes[2], box_of_line(3, 1));
  }
  write_file(scratch_ / "cover.label/sequence", "name=S\n");
  EXPECT_EQ(Sequence::open(scratch_ / "cover.label").layout, SequenceLayout::kVot);
}

TEST_F(Sequences, OfGot10ksTestSplitTheFirstBoxAloneIsKnown) {
  write_pictures(scratch_ / "GOT-10k_Test_000001", "{:08d}.jpg", 3);
  write_file(scratch_ / "GOT-10k_Test_000001/groundtruth.txt", lines_of_boxes(1));
  const Sequence sequence = Sequence::open(scratch_ / "GOT-10k_Test_000001/");
  EXPECT_EQ(sequence.layout, SequenceLayout::kGot10k);
  EXPECT_THAT(sequence.targets.at(0).boxes,
              ElementsAre(box_of_line(1, 1), std::nullopt, std::nullopt));
}

TEST_F(Sequences, TldIsReadBesideItsPicturesAndFromAFolder) {
  for (const char* pattern : {"{:05d}.png", "img/{:05d}.png"}) {
    const Scratch scratch;
    write_pictures(scratch / "01_david", pattern, 2);
    write_file(scratch / "01_david/gt.txt", "1,1,10,20\nNaN,NaN,NaN,NaN\n");
    const Sequence sequence = Sequence::open(scratch / "01_david");
    EXPECT_EQ(sequence.layout, SequenceLayout::kTld);
    EXPECT_THAT(sequence.pictures, SizeIs(2));
    EXPECT_THAT(sequence.targets.at(0).boxes, ElementsAre(box_of_line(1, 1), std::nullopt));
  }
}

TEST_F(Sequences, AVideoIsASequenceWithoutTruth) {
  Frame frame{.size = {.width = 32, .height = 32}, .rgb = {}};
  frame.rgb.assign(32 * 32 * 3, 100);
  {
    VideoEncoder encoder(scratch_ / "v.mp4", frame.size, 25);
    for (int i = 0; i < 5; ++i) encoder.write(frame);
    encoder.close();
  }
  const Sequence video = Sequence::open(scratch_ / "v.mp4");
  EXPECT_EQ(video.layout, SequenceLayout::kVideo);
  EXPECT_EQ(video.name, "v.mp4");
  EXPECT_THAT(video.targets, IsEmpty());

  fs::create_directories(scratch_ / "06_car");
  fs::copy(scratch_ / "v.mp4", scratch_ / "06_car/car.mp4");
  write_file(scratch_ / "06_car/gt.txt", "1,1,10,20\nNaN,NaN,NaN,NaN\n");
  const Sequence tld = Sequence::open(scratch_ / "06_car");
  EXPECT_EQ(tld.layout, SequenceLayout::kTld);
  EXPECT_EQ(tld.name, "06_car");
  EXPECT_EQ(tld.path, scratch_ / "06_car/car.mp4");
  EXPECT_THAT(tld.targets.at(0).boxes, ElementsAre(box_of_line(1, 1), std::nullopt));
}

TEST_F(Sequences, OfAFolderAreFoundByName) {
  for (const char* name : {"b", "a", "c"}) {
    write_pictures(scratch_ / "set" / name, "img/{:04d}.jpg", 2);
    write_file(scratch_ / "set" / name / "groundtruth_rect.txt", lines_of_boxes(2));
  }
  write_file(scratch_ / "set/list.txt", "a\nb\nc\n");
  write_file(scratch_ / "set/results/a.txt", "no sequence");
  fs::create_directories(scratch_ / "set/.hidden/img");
  std::vector<std::string> names;
  for (const Sequence& each : find_sequences(scratch_ / "set")) names.push_back(each.name);
  EXPECT_THAT(names, ElementsAre("a", "b", "c"));
  EXPECT_THAT(find_sequences(scratch_ / "set/b"), SizeIs(1));

  fs::remove(scratch_ / "set/b/groundtruth_rect.txt");
  EXPECT_THAT(complaint([&] { static_cast<void>(find_sequences(scratch_ / "set")); }),
              StartsWith((scratch_ / "set/b").string() + ": not annotated"))
      << "one that is half there is not passed over";
  EXPECT_THROW(static_cast<void>(find_sequences(scratch_ / "set/results")), UsageError);
  EXPECT_THROW(static_cast<void>(find_sequences(scratch_ / "nowhere")), UsageError);
}

TEST_F(Sequences, MayBePicturesThatNobodyAnnotated) {
  write_pictures(scratch_ / "bare", "{:04d}.jpg", 3);
  write_pictures(scratch_ / "inner", "img/{:04d}.jpg", 2);
  for (const auto& [name, count] : {std::pair{"bare", 3U}, {"inner", 2U}}) {
    const std::vector<Sequence> found = find_sequences(scratch_ / name);
    ASSERT_THAT(found, SizeIs(1)) << name;
    EXPECT_THAT(found[0].pictures, SizeIs(count)) << name;
    EXPECT_THAT(found[0].targets, IsEmpty()) << name;
  }
}

/// The real sequences; empty where they are not.
fs::path real_sequences() {
  const char* data = std::getenv("PACER_DATA");
  const fs::path root =
      data != nullptr ? fs::path(data) : fs::path(PACER_SOURCE_DIR) / "../shared/data";
  return fs::exists(root / "sequences/Dudek") ? root / "sequences" : fs::path();
}

TEST(RealSequences, AreReadWhole) {
  if (real_sequences().empty()) GTEST_SKIP() << "no tracking sequences: set PACER_DATA";
  struct Known {
    std::size_t pictures;
    cv::Size size;
    Box first;
  };
  const std::map<std::string, Known> known = {
      {"Car4", {659, {360, 240}, Box::of_pixels(69, 50, 107, 87)}},
      {"Couple", {140, {320, 240}, Box::of_pixels(50, 46, 25, 62)}},
      {"Dudek", {1145, {720, 480}, Box::of_pixels(122, 86, 132, 176)}},
      {"FaceOcc1", {892, {352, 288}, Box::of_pixels(117, 68, 114, 162)}},
      {"Human7", {250, {320, 240}, Box::of_pixels(109, 110, 37, 116)}}};
  std::size_t seen = 0;
  for (const Sequence& sequence : find_sequences(real_sequences())) {
    const auto found = known.find(sequence.name);
    if (found == known.end()) continue;
    ++seen;
    const auto& [pictures, size, first] = found->second;
    EXPECT_THAT(sequence.pictures, SizeIs(pictures));
    ASSERT_THAT(sequence.targets, SizeIs(1));
    EXPECT_THAT(sequence.targets[0].boxes, AllOf(SizeIs(pictures), Each(Not(Eq(std::nullopt)))));
    EXPECT_EQ(sequence.targets[0].boxes[0], first) << sequence.name;
    const auto source = read_pictures(sequence);
    cv::Mat picture;
    std::size_t read = 0;
    for (; source->next(picture); ++read) ASSERT_EQ(picture.size(), size);
    EXPECT_EQ(read, pictures);
  }
  EXPECT_EQ(seen, known.size());
}

}  // namespace
}  // namespace pacer::dataset
