#pragma once

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libswscale/swscale.h>
}

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>

namespace smile::video::internal {

struct CodecDeleter {
  void operator()(AVCodecContext* codec) const { avcodec_free_context(&codec); }
};
struct FrameDeleter {
  void operator()(AVFrame* frame) const { av_frame_free(&frame); }
};
struct PacketDeleter {
  void operator()(AVPacket* packet) const { av_packet_free(&packet); }
};
struct ScalerDeleter {
  void operator()(SwsContext* scaler) const { sws_freeContext(scaler); }
};
struct InputDeleter {
  void operator()(AVFormatContext* input) const { avformat_close_input(&input); }
};
struct OutputDeleter {
  void operator()(AVFormatContext* output) const {
    avio_closep(&output->pb);
    avformat_free_context(output);
  }
};

using Codec = std::unique_ptr<AVCodecContext, CodecDeleter>;
using Frame = std::unique_ptr<AVFrame, FrameDeleter>;
using Packet = std::unique_ptr<AVPacket, PacketDeleter>;
using Scaler = std::unique_ptr<SwsContext, ScalerDeleter>;
using Input = std::unique_ptr<AVFormatContext, InputDeleter>;
using Output = std::unique_ptr<AVFormatContext, OutputDeleter>;

/// @throws std::runtime_error `<path>: <call>: <reason>`.
[[noreturn]] inline void Fail(const std::filesystem::path& path, const char* call,
                              const std::string& reason) {
  throw std::runtime_error(path.string() + ": " + call + ": " + reason);
}

/// Returns a path as libav's URL; without it, `day:1.mp4` would be a protocol called `day`.
inline std::string UrlOf(const std::filesystem::path& path) { return "file:" + path.string(); }

/// Throws if `result`, a return value of libav, is an error.
inline int Check(int result, const std::filesystem::path& path, const char* call) {
  if (result >= 0) return result;
  char reason[AV_ERROR_MAX_STRING_SIZE] = "";
  av_strerror(result, reason, sizeof reason);
  Fail(path, call, reason);
}

template <class T>
T* CheckMade(T* thing, const std::filesystem::path& path, const char* call) {
  if (thing == nullptr) Fail(path, call, "not available here, or out of memory");
  return thing;
}

}  // namespace smile::video::internal
