// SPDX-License-Identifier: Apache-2.0
// Private to the module: owners of libav's objects.
#pragma once

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/opt.h>
#include <libswscale/swscale.h>
}

#include <memory>
#include <string>

namespace pacer::dataset {

struct LibavDeleter {
  void operator()(AVCodecContext* context) const { avcodec_free_context(&context); }
  void operator()(AVFrame* frame) const { av_frame_free(&frame); }
  void operator()(AVPacket* packet) const { av_packet_free(&packet); }
  void operator()(SwsContext* context) const { sws_freeContext(context); }
};
template <class T>
using LibavPtr = std::unique_ptr<T, LibavDeleter>;

/// Libraries never print; every error of libav's becomes an exception.
inline void silence_libav() { av_log_set_level(AV_LOG_QUIET); }

inline std::string libav_message(int error) {
  char text[AV_ERROR_MAX_STRING_SIZE] = {};
  av_strerror(error, text, sizeof text);
  return text;
}

}  // namespace pacer::dataset
