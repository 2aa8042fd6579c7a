// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>

#include "dataset/libav.h"
#include "dataset/video.h"

namespace pacer::dataset {
namespace {

constexpr std::int64_t kMostPixels = 8192LL * 8192;

struct InputDeleter {
  void operator()(AVFormatContext* input) const { avformat_close_input(&input); }
};

}  // namespace

struct VideoDecoder::Impl {
  std::filesystem::path path;
  std::unique_ptr<AVFormatContext, InputDeleter> input;
  LibavPtr<AVCodecContext> codec;
  LibavPtr<AVFrame> picture;
  LibavPtr<AVPacket> packet;
  LibavPtr<SwsContext> to_rgb;
  AVPixelFormat format = AV_PIX_FMT_NONE;
  AVStream* stream = nullptr;  // the input's
  ImageSize size;
  double skip_before = -1.0;  // s
  double expected = 0.0;      // when the next picture should be shown, s; negative: not known
  std::uint64_t frames = 0;
  int packets = 0;  // of the stream, since the beginning
  bool sought = false;
  bool ended = false;

  [[noreturn]] void fail(const std::string& why) const {
    throw std::runtime_error(fmt::format("{}: not a readable video: {}", path.string(), why));
  }
  void require_good(int result) const {
    if (result < 0) fail(libav_message(result));
  }

  /// False at the end of the file.
  bool feed() {
    for (;;) {
      const int result = av_read_frame(input.get(), packet.get());
      if (result == AVERROR_EOF) {
        const int listed = avformat_index_get_entries_count(stream);
        if (!sought && packets < listed) {
          fail(fmt::format("it is cut short: {} of {} pictures are there", packets, listed));
        }
        require_good(avcodec_send_packet(codec.get(), nullptr));
        return false;
      }
      require_good(result);
      const bool ours = packet->stream_index == stream->index;
      const int sent = ours ? avcodec_send_packet(codec.get(), packet.get()) : 0;
      av_packet_unref(packet.get());
      require_good(sent);
      packets += ours ? 1 : 0;
      if (ours) return true;
    }
  }

  /// The next picture's time, s; negative after the last.
  double decode() {
    for (;;) {
      const int result = avcodec_receive_frame(codec.get(), picture.get());
      if (result == AVERROR_EOF) return -1.0;
      if (result == AVERROR(EAGAIN) && !ended) {
        ended = !feed();
        continue;
      }
      require_good(result);
      const std::int64_t shown = picture->best_effort_timestamp;
      double time = expected;
      if (shown != AV_NOPTS_VALUE) {
        time = std::max(0.0, static_cast<double>(shown - start()) * av_q2d(stream->time_base));
      } else if (rate_hz() <= 0.0 || time < 0.0) {  // MPEG-1 stamps only some
        fail("a picture has no time");
      }
      expected = rate_hz() > 0.0 ? time + 1.0 / rate_hz() : -1.0;
      return time;
    }
  }
  [[nodiscard]] std::int64_t start() const {
    return stream->start_time == AV_NOPTS_VALUE ? 0 : stream->start_time;
  }

  [[nodiscard]] double rate_hz() const {
    const AVRational rate = stream->avg_frame_rate;
    return rate.num > 0 && rate.den > 0 ? av_q2d(rate) : 0.0;
  }

  void convert(Frame& frame) {
    if (picture->width != size.width || picture->height != size.height) {
      fail("its pictures change size");
    }
    const auto now = static_cast<AVPixelFormat>(picture->format);
    if (!to_rgb || now != format) {
      format = now;
      to_rgb.reset(sws_getContext(size.width, size.height, format, size.width, size.height,
                                  AV_PIX_FMT_RGB24, SWS_POINT, nullptr, nullptr, nullptr));
      if (!to_rgb) fail("its pixel format cannot be turned into RGB");
    }
    frame.size = size;
    frame.rgb.resize(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height) *
                     3U);
    std::uint8_t* rgb[] = {frame.rgb.data()};
    const int stride[] = {3 * size.width};
    sws_scale(to_rgb.get(), picture->data, picture->linesize, 0, size.height, rgb, stride);
  }
};

VideoDecoder::VideoDecoder(std::filesystem::path path) : impl_(std::make_unique<Impl>()) {
  silence_libav();
  Impl& my = *impl_;
  my.path = std::move(path);
  my.picture.reset(av_frame_alloc());
  my.packet.reset(av_packet_alloc());
  if (!my.picture || !my.packet) throw std::bad_alloc();

  AVFormatContext* input = nullptr;
  AVDictionary* options = nullptr;
  av_dict_set(&options, "protocol_whitelist", "file", 0);  // a playlist must not reach a network
  const int opened =
      avformat_open_input(&input, ("file:" + my.path.string()).c_str(), nullptr, &options);
  av_dict_free(&options);
  if (opened == AVERROR_INVALIDDATA)
    my.fail("its format is not known, or its beginning is damaged");
  my.require_good(opened);
  my.input.reset(input);
  // libav takes any text for the recording of a terminal, and would draw it.
  if (std::string_view(input->iformat->name) == "tty") my.fail("it is a text");
  my.require_good(avformat_find_stream_info(input, nullptr));
  const AVCodec* codec = nullptr;
  const int index = av_find_best_stream(input, AVMEDIA_TYPE_VIDEO, -1, -1, &codec, 0);
  my.require_good(index);
  my.stream = input->streams[index];
  my.codec.reset(avcodec_alloc_context3(codec));
  if (!my.codec) throw std::bad_alloc();
  my.require_good(avcodec_parameters_to_context(my.codec.get(), my.stream->codecpar));
  my.codec->thread_count = 1;
  my.codec->max_pixels = kMostPixels;
  my.require_good(avcodec_open2(my.codec.get(), codec, nullptr));
  my.size = {.width = my.codec->width, .height = my.codec->height};
  if (my.size.width <= 0 || my.size.height <= 0 ||
      std::int64_t{my.size.width} * my.size.height > kMostPixels) {
    my.fail(fmt::format("its pictures are {} x {} pixels", my.size.width, my.size.height));
  }
}

VideoDecoder::~VideoDecoder() = default;

bool VideoDecoder::next(Frame& frame) {
  Impl& my = *impl_;
  double time = my.decode();
  while (time >= 0.0 && time < my.skip_before) time = my.decode();
  if (time < 0.0) return false;
  my.convert(frame);
  frame.time = Seconds{time};
  frame.index = my.frames++;
  return true;
}

void VideoDecoder::seek(Seconds time) {
  Impl& my = *impl_;
  const double half_frame = rate_hz() > 0.0 ? 0.5 / rate_hz() : 0.0;
  my.skip_before = time.count() - half_frame;
  const double ticks = std::clamp(time.count() / av_q2d(my.stream->time_base), 0.0, 1e15);
  my.require_good(av_seek_frame(my.input.get(), my.stream->index,
                                my.start() + static_cast<std::int64_t>(ticks),
                                AVSEEK_FLAG_BACKWARD));
  avcodec_flush_buffers(my.codec.get());
  my.sought = true;
  my.ended = false;
  my.expected = -1.0;
  my.frames = 0;
}

ImageSize VideoDecoder::size() const { return impl_->size; }
double VideoDecoder::rate_hz() const { return impl_->rate_hz(); }
std::int64_t VideoDecoder::declared_frames() const { return impl_->stream->nb_frames; }

}  // namespace pacer::dataset
