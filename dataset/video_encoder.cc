// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "core/check.h"
#include "dataset/libav.h"
#include "dataset/video.h"

namespace pacer::dataset {
namespace {

constexpr std::array kPresets{"ultrafast", "superfast", "veryfast", "faster",   "fast",
                              "medium",    "slow",      "slower",   "veryslow", "placebo"};
constexpr int kClockPerFrame = 512;  // as other writers do: every container's clock divides it

struct OutputDeleter {
  void operator()(AVFormatContext* output) const {
    if (output->pb != nullptr) avio_closep(&output->pb);
    avformat_free_context(output);
  }
};

}  // namespace

void VideoSettings::validate() const {
  require(std::ranges::find(kPresets, preset) != kPresets.end(),
          "preset: '" + preset + "' is none of libx264's, e.g. ultrafast");
  require(quality >= 0 && quality <= 51, "quality: must lie in [0, 51]");
  require(key_frame_every >= 1 && key_frame_every <= 1000,
          "key_frame_every: must lie in [1, 1000]");
}

struct VideoEncoder::Impl {
  std::filesystem::path path;
  ImageSize size;
  std::unique_ptr<AVFormatContext, OutputDeleter> output;
  LibavPtr<AVCodecContext> codec;
  LibavPtr<AVFrame> picture;
  LibavPtr<AVPacket> packet;
  AVStream* stream = nullptr;  // the output's
  cv::Mat planes;              // Y, U and V one below the other, without padding
  std::int64_t frames = 0;
  bool open = false;

  [[noreturn]] void fail(const char* what, int error) const {
    throw std::runtime_error(
        fmt::format("{}: cannot {}: {}", path.string(), what, libav_message(error)));
  }
  void require_good(int result, const char* what) const {
    if (result < 0) fail(what, result);
  }

  void drain(const AVFrame* input) {
    require_good(avcodec_send_frame(codec.get(), input), "encode");
    for (;;) {
      const int result = avcodec_receive_packet(codec.get(), packet.get());
      if (result == AVERROR(EAGAIN) || result == AVERROR_EOF) return;
      require_good(result, "encode");
      packet->duration = 1;
      av_packet_rescale_ts(packet.get(), codec->time_base, stream->time_base);
      packet->stream_index = stream->index;
      require_good(av_write_frame(output.get(), packet.get()), "write");
      av_packet_unref(packet.get());
      require_good(output->pb->error, "write");  // a full disk shows here first
    }
  }
};

VideoEncoder::VideoEncoder(std::filesystem::path path, ImageSize size, int rate_hz,
                           const VideoSettings& settings)
    : impl_(std::make_unique<Impl>()) {
  settings.validate();
  require(size.width >= 16 && size.width <= 8192 && size.width % 2 == 0,
          "width: must be even and lie in [16, 8192]");
  require(size.height >= 16 && size.height <= 8192 && size.height % 2 == 0,
          "height: must be even and lie in [16, 8192]");
  require(rate_hz >= 1 && rate_hz <= 1000, "rate: must lie in [1, 1000] Hz");
  silence_libav();
  Impl& my = *impl_;
  my.path = std::move(path);
  my.size = size;
  my.planes.create(size.height * 3 / 2, size.width, CV_8UC1);

  const AVCodec* libx264 = avcodec_find_encoder_by_name("libx264");
  if (libx264 == nullptr) {
    throw std::runtime_error("FFmpeg has no libx264: install a build of FFmpeg that has it");
  }
  my.codec.reset(avcodec_alloc_context3(libx264));
  my.picture.reset(av_frame_alloc());
  my.packet.reset(av_packet_alloc());
  if (!my.codec || !my.picture || !my.packet) throw std::bad_alloc();
  AVCodecContext& codec = *my.codec;
  codec.width = size.width;
  codec.height = size.height;
  codec.pix_fmt = AV_PIX_FMT_YUV420P;
  codec.time_base = {1, rate_hz};
  codec.framerate = {rate_hz, 1};
  codec.gop_size = settings.key_frame_every;
  codec.max_b_frames = 0;
  codec.thread_count = 1;
  codec.color_range = AVCOL_RANGE_MPEG;
  codec.colorspace = AVCOL_SPC_SMPTE170M;
  codec.color_primaries = AVCOL_PRI_SMPTE170M;
  codec.color_trc = AVCOL_TRC_SMPTE170M;
  codec.flags |= AV_CODEC_FLAG_GLOBAL_HEADER | AV_CODEC_FLAG_BITEXACT;
  AVDictionary* options = nullptr;
  av_dict_set(&options, "preset", settings.preset.c_str(), 0);
  av_dict_set_int(&options, "crf", settings.quality, 0);
  const int opened = avcodec_open2(&codec, libx264, &options);
  av_dict_free(&options);
  my.require_good(opened, fmt::format("open libx264 with preset '{}'", settings.preset).c_str());

  AVFormatContext* output = nullptr;
  my.require_good(avformat_alloc_output_context2(&output, nullptr, "mp4", my.path.c_str()),
                  "make an mp4");
  my.output.reset(output);
  output->flags |= AVFMT_FLAG_BITEXACT;
  my.stream = avformat_new_stream(output, nullptr);
  if (my.stream == nullptr) throw std::bad_alloc();
  my.stream->time_base = {1, rate_hz * kClockPerFrame};
  my.stream->avg_frame_rate = codec.framerate;
  my.require_good(avcodec_parameters_from_context(my.stream->codecpar, &codec), "make an mp4");
  my.require_good(avio_open(&output->pb, my.path.c_str(), AVIO_FLAG_WRITE), "write");
  my.require_good(avformat_write_header(output, nullptr), "write");

  my.picture->format = codec.pix_fmt;
  my.picture->width = size.width;
  my.picture->height = size.height;
  my.open = true;
}

VideoEncoder::~VideoEncoder() = default;

void VideoEncoder::write(const Frame& frame) {
  Impl& my = *impl_;
  check(my.open, "frames are written before the video is closed");
  check(frame.size == my.size && frame.rgb.size() == static_cast<std::size_t>(my.size.width) *
                                                         static_cast<std::size_t>(my.size.height) *
                                                         3U,
        "every frame of a video has its size");
  const cv::Mat rgb(my.size.height, my.size.width, CV_8UC3,
                    const_cast<std::uint8_t*>(frame.rgb.data()));  // only read
  cv::cvtColor(rgb, my.planes, cv::COLOR_RGB2YUV_I420);
  const std::ptrdiff_t luma = std::ptrdiff_t{my.size.width} * my.size.height;
  AVFrame& picture = *my.picture;
  picture.data[0] = my.planes.data;
  picture.data[1] = picture.data[0] + luma;
  picture.data[2] = picture.data[1] + luma / 4;
  picture.linesize[0] = my.size.width;
  picture.linesize[1] = picture.linesize[2] = my.size.width / 2;
  picture.pts = my.frames++;
  my.drain(&picture);
}

void VideoEncoder::close() {
  Impl& my = *impl_;
  if (!my.open) return;
  my.open = false;
  my.drain(nullptr);
  my.require_good(av_write_trailer(my.output.get()), "write");
  const int flushed = avio_closep(&my.output->pb);
  my.require_good(flushed, "write");
}

}  // namespace pacer::dataset
