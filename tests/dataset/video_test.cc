// SPDX-License-Identifier: Apache-2.0
#include "dataset/video.h"

#include <gmock/gmock.h>

#include <cstdint>
#include <fstream>

#include "tests/dataset/recording.h"

namespace pacer::dataset {
namespace {

using testing::made_up_step;
using testing::Scratch;
using testing::small_spec;

void encode(const std::filesystem::path& path, int frames, const VideoSettings& settings = {}) {
  VideoEncoder encoder(path, small_spec().image_size, 25, settings);
  for (int i = 0; i < frames; ++i) encoder.write(made_up_step(small_spec(), 0, i).frame);
  encoder.close();
}

TEST(Video, TheSameFramesGiveTheSameBytes) {
  const Scratch scratch;
  encode(scratch / "one.mp4", 12);
  encode(scratch / "other.mp4", 12);
  EXPECT_EQ(read_text(scratch / "one.mp4"), read_text(scratch / "other.mp4"));
}

TEST(Video, KeepsColoursAndOrder) {
  const Scratch scratch;
  encode(scratch / "video.mp4", 12);
  VideoDecoder decoder(scratch / "video.mp4");
  EXPECT_EQ(decoder.size(), small_spec().image_size);
  EXPECT_EQ(decoder.rate_hz(), 25.0);
  EXPECT_EQ(decoder.declared_frames(), 12);
  Frame frame;
  for (int i = 0; i < 12; ++i) {
    ASSERT_TRUE(decoder.next(frame));
    const Frame sent = made_up_step(small_spec(), 0, i).frame;
    std::array<double, 3> distance{};
    for (std::size_t p = 0; p < sent.rgb.size(); ++p) {
      distance[p % 3] += std::abs(frame.rgb[p] - sent.rgb[p]);
    }
    for (const double sum : distance) EXPECT_LT(sum / (64 * 48), 5.0) << "frame " << i;
    EXPECT_NEAR(frame.time.count(), i / 25.0, 1e-9);
  }
  EXPECT_FALSE(decoder.next(frame));
  EXPECT_FALSE(decoder.next(frame));
}

/// An MP4 with its index moved to the front, as the web has them: it can be opened when its end is
/// missing.
std::string with_index_first(const std::string& mp4) {
  const auto number = [](const std::string& bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
      value = value << 8 | static_cast<std::uint8_t>(bytes[at + i]);
    return value;
  };
  const std::size_t moov = mp4.find("moov") - 4;
  const std::size_t size = number(mp4, moov);
  std::string index = mp4.substr(moov, size);
  const std::size_t offsets = index.find("stco") + 12;
  for (std::size_t i = 0; i < number(index, offsets - 4); ++i) {
    const std::uint32_t moved = number(index, offsets + 4 * i) + static_cast<std::uint32_t>(size);
    for (std::size_t byte = 0; byte < 4; ++byte) {
      index[offsets + 4 * i + byte] = static_cast<char>(moved >> (24 - 8 * byte));
    }
  }
  const std::size_t head = number(mp4, 0);  // ftyp
  return mp4.substr(0, head) + index + mp4.substr(head, moov - head) + mp4.substr(moov + size);
}

TEST(Video, SaysWhenItIsCutShort) {
  const Scratch scratch;
  encode(scratch / "video.mp4", 20);
  const std::string whole = with_index_first(read_text(scratch / "video.mp4"));
  const auto frames_of = [&](const std::string& bytes) {
    std::ofstream(scratch / "web.mp4", std::ios::binary) << bytes;
    VideoDecoder decoder(scratch / "web.mp4");
    Frame frame;
    int frames = 0;
    while (decoder.next(frame)) ++frames;
    return frames;
  };
  EXPECT_EQ(frames_of(whole), 20);
  for (const double share : {0.6, 0.8, 0.95}) {
    const auto kept = static_cast<std::size_t>(share * static_cast<double>(whole.size()));
    EXPECT_THROW((void)frames_of(whole.substr(0, kept)), std::runtime_error) << share;
  }
}

TEST(Video, SeeksToTheFrameShownAtATime) {
  const Scratch scratch;
  encode(scratch / "video.mp4", 20, {.preset = "veryfast", .quality = 20, .key_frame_every = 7});
  VideoDecoder decoder(scratch / "video.mp4");
  Frame frame;
  for (const int wanted : {17, 3, 0, 19, 8}) {
    decoder.seek(Seconds{wanted / 25.0});
    ASSERT_TRUE(decoder.next(frame));
    EXPECT_NEAR(frame.time.count(), wanted / 25.0, 1e-9);
  }
}

TEST(Video, RefusesOddSizesAndUnknownPresets) {
  const Scratch scratch;
  EXPECT_THROW(VideoEncoder(scratch / "v.mp4", {.width = 63, .height = 48}, 25),
               std::invalid_argument);
  EXPECT_THROW(VideoEncoder(scratch / "v.mp4", {.width = 64, .height = 48}, 25,
                            {.preset = "warp", .quality = 20, .key_frame_every = 2}),
               std::invalid_argument);
  EXPECT_THROW((VideoSettings{.preset = "fast", .quality = 99, .key_frame_every = 2}.validate()),
               std::invalid_argument);
}

TEST(Video, NamesTheFileThatCannotBeWritten) {
  try {
    VideoEncoder encoder("/nowhere/video.mp4", {.width = 64, .height = 48}, 25);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("/nowhere/video.mp4"));
  }
}

}  // namespace
}  // namespace pacer::dataset
