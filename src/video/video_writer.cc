#include "video/video_writer.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "video/internal_libav.h"

// Writes films with libav and x264. The same pictures must give the same bytes, so that films can
// be compared in tests: one thread, fixed settings, bit-exact flags, no dates. Films of numbers are
// made by x265.

namespace smile::video {

using internal::Check;
using internal::CheckMade;

/// Pipeline of libav from a picture to the file: pad, convert to YUV, encode, write.
class VideoWriter::Encoder {
 public:
  Encoder(std::filesystem::path path, int width_px, int height_px, double frames_per_second,
          VideoCoding coding)
      : path_(std::move(path)),
        width_px_(width_px),
        height_px_(height_px),
        has_levels_(coding == VideoCoding::kLevels) {
    av_log_set_level(AV_LOG_ERROR);  // x264 reports statistics otherwise
    OpenOutput();
    OpenCodec(av_d2q(frames_per_second, 1'000'000), coding);
    OpenFile();
    MakeFrames();
  }

  void Add(const Image& image) {
    RequireOpen(false);
    const std::size_t row_bytes = std::size_t{3} * width_px_;
    if (image.width_px != width_px_ || image.height_px != height_px_ ||
        image.color.size() != row_bytes * height_px_) {
      throw std::invalid_argument(
          path_.string() + ": a picture has " + std::to_string(image.width_px) + "x" +
          std::to_string(image.height_px) + " pixels and " + std::to_string(image.color.size()) +
          " bytes of color, expected " + std::to_string(width_px_) + "x" +
          std::to_string(height_px_) + " pixels with 3 bytes each");
    }
    CopyPadded(image, row_bytes);
    // The encoder may still refer to the former content of the frame.
    Check(av_frame_make_writable(yuv_.get()), path_, "av_frame_make_writable");
    sws_scale(scaler_.get(), rgb_->data, rgb_->linesize, 0, rgb_->height, yuv_->data,
              yuv_->linesize);
    yuv_->pts = num_frames_++;
    Encode(yuv_.get());
  }

  void AddLevels(std::span<const std::uint16_t> levels) {
    RequireOpen(true);
    const auto num_pixels = static_cast<std::size_t>(width_px_) * height_px_;
    const auto highest = std::ranges::max_element(levels);
    if (levels.size() != num_pixels || *highest > kMaxLevel) {
      throw std::invalid_argument(
          path_.string() + ": a picture has " + std::to_string(levels.size()) + " numbers up to " +
          std::to_string(levels.empty() ? 0 : *highest) + ", expected " +
          std::to_string(num_pixels) + " up to " + std::to_string(kMaxLevel));
    }
    Check(av_frame_make_writable(yuv_.get()), path_, "av_frame_make_writable");
    const std::size_t row_bytes = sizeof(std::uint16_t) * width_px_;
    for (int v = 0; v < height_px_; ++v) {
      std::memcpy(yuv_->data[0] + static_cast<std::ptrdiff_t>(v) * yuv_->linesize[0],
                  levels.data() + static_cast<std::size_t>(v) * width_px_, row_bytes);
    }
    yuv_->pts = num_frames_++;
    Encode(yuv_.get());
  }

  void Finish() {
    if (is_finished_) return;
    if (num_frames_ == 0) throw std::logic_error(path_.string() + ": a film needs a picture");
    is_finished_ = true;
    // Writes the pictures that the encoder has delayed.
    Encode(nullptr);
    Check(av_write_trailer(output_.get()), path_, "av_write_trailer");
    // A full disk may be reported only here.
    Check(avio_closep(&output_->pb), path_, "avio_close");
  }

  int num_frames() const { return num_frames_; }

 private:
  static constexpr std::uint16_t kMaxLevel = 4095;

  void RequireOpen(bool has_levels) const {
    if (is_finished_)
      throw std::logic_error(path_.string() + ": is finished; no more pictures can be added");
    if (has_levels != has_levels_) {
      throw std::invalid_argument(
          path_.string() + ": is a film of " +
          (has_levels_ ? "numbers, expected no colors" : "colors, expected no numbers"));
    }
  }

  void OpenOutput() {
    AVFormatContext* output = nullptr;
    Check(avformat_alloc_output_context2(&output, nullptr, "mp4", internal::UrlOf(path_).c_str()),
          path_, "avformat_alloc_output_context2");
    output_.reset(output);
    output_->flags |= AVFMT_FLAG_BITEXACT;  // no date, no version of the library
    stream_ = CheckMade(avformat_new_stream(output_.get(), nullptr), path_, "avformat_new_stream");
  }

  /// Opens the encoder. Every setting that influences the bytes is fixed, so that equal pictures
  /// give equal files.
  void OpenCodec(AVRational rate, VideoCoding coding) {
    const char* name = has_levels_ ? "libx265" : "libx264";
    const AVCodec* encoder =
        CheckMade(avcodec_find_encoder_by_name(name), path_, "avcodec_find_encoder_by_name");
    codec_.reset(CheckMade(avcodec_alloc_context3(encoder), path_, "avcodec_alloc_context3"));
    // 4:2:0 subsampling needs even sizes.
    codec_->width = width_px_ + (has_levels_ ? 0 : width_px_ % 2);
    codec_->height = height_px_ + (has_levels_ ? 0 : height_px_ % 2);
    codec_->pix_fmt = has_levels_ ? AV_PIX_FMT_GRAY12 : AV_PIX_FMT_YUV420P;
    codec_->framerate = rate;
    // One unit of time is one frame, so time stamps are frame numbers.
    codec_->time_base = av_inv_q(rate);
    if (has_levels_) {
      codec_->color_range = AVCOL_RANGE_JPEG;
    } else {
      // BT.709 in limited range: what players assume of films in high definition.
      codec_->color_range = AVCOL_RANGE_MPEG;
      codec_->colorspace = AVCOL_SPC_BT709;
      codec_->color_primaries = AVCOL_PRI_BT709;
      codec_->color_trc = AVCOL_TRC_BT709;
    }
    if (coding != VideoCoding::kCompact) {
      codec_->gop_size = 2;
      codec_->max_b_frames = 0;
    }
    codec_->thread_count = 1;  // the bytes depend on the number of threads
    codec_->flags |= AV_CODEC_FLAG_GLOBAL_HEADER | AV_CODEC_FLAG_BITEXACT;
    AVDictionary* options = nullptr;
    if (has_levels_) {
      av_dict_set(&options, "preset", "ultrafast", 0);
      // One thread, and no name of the encoder in the stream.
      av_dict_set(&options, "x265-params",
                  "lossless=1:pools=none:frame-threads=1:wpp=0:bframes=0:keyint=2:min-keyint=2:"
                  "scenecut=0:info=0:log-level=error",
                  0);
    } else {
      // A fast preset, as one thread encodes.
      av_dict_set(&options, "preset", "veryfast", 0);
      // Constant quality: the size follows from the content. 20 is nearly without visible loss.
      av_dict_set(&options, "crf", "20", 0);
    }
    const int result = avcodec_open2(codec_.get(), encoder, &options);
    av_dict_free(&options);
    Check(result, path_, "avcodec_open2");

    stream_->time_base = codec_->time_base;
    stream_->avg_frame_rate = rate;
    Check(avcodec_parameters_from_context(stream_->codecpar, codec_.get()), path_,
          "avcodec_parameters_from_context");
    // The one of two names of HEVC in mp4 that all players know.
    if (has_levels_) stream_->codecpar->codec_tag = MKTAG('h', 'v', 'c', '1');
  }

  void OpenFile() {
    Check(avio_open(&output_->pb, output_->url, AVIO_FLAG_WRITE), path_, "avio_open");
    AVDictionary* options = nullptr;
    // Moves the index to the front, so that players can start before the whole file is there.
    av_dict_set(&options, "movflags", "+faststart", 0);
    const int result = avformat_write_header(output_.get(), &options);
    av_dict_free(&options);
    Check(result, path_, "avformat_write_header");
  }

  void MakeFrames() {
    yuv_ = MakeFrame(codec_->pix_fmt);
    packet_.reset(CheckMade(av_packet_alloc(), path_, "av_packet_alloc"));
    if (has_levels_) return;
    rgb_ = MakeFrame(AV_PIX_FMT_RGB24);
    scaler_.reset(CheckMade(
        sws_getContext(codec_->width, codec_->height, AV_PIX_FMT_RGB24, codec_->width,
                       codec_->height, AV_PIX_FMT_YUV420P,
                       SWS_BILINEAR | SWS_ACCURATE_RND | SWS_BITEXACT, nullptr, nullptr, nullptr),
        path_, "sws_getContext"));
    const int* bt709 = sws_getCoefficients(SWS_CS_ITU709);
    // From full-range RGB to limited-range BT.709, as the stream declares.
    sws_setColorspaceDetails(scaler_.get(), bt709, 1, bt709, 0, 0, 1 << 16, 1 << 16);
  }

  internal::Frame MakeFrame(AVPixelFormat format) const {
    internal::Frame frame(CheckMade(av_frame_alloc(), path_, "av_frame_alloc"));
    frame->format = format;
    frame->width = codec_->width;
    frame->height = codec_->height;
    Check(av_frame_get_buffer(frame.get(), 0), path_, "av_frame_get_buffer");
    return frame;
  }

  /// Copies the picture row by row; an odd last row or column is repeated.
  void CopyPadded(const Image& image, std::size_t row_bytes) {
    for (int v = 0; v < rgb_->height; ++v) {
      const std::uint8_t* from = image.color.data() + row_bytes * std::min(v, height_px_ - 1);
      std::uint8_t* to = rgb_->data[0] + static_cast<std::ptrdiff_t>(v) * rgb_->linesize[0];
      std::memcpy(to, from, row_bytes);
      if (rgb_->width > width_px_) std::memcpy(to + row_bytes, from + row_bytes - 3, 3);
    }
  }

  /// Passes a frame to the encoder (nullptr: the end) and writes the packets that it returns; the
  /// encoder may delay them.
  void Encode(const AVFrame* frame) {
    Check(avcodec_send_frame(codec_.get(), frame), path_, "avcodec_send_frame");
    for (;;) {
      const int result = avcodec_receive_packet(codec_.get(), packet_.get());
      if (result == AVERROR(EAGAIN) || result == AVERROR_EOF) return;
      Check(result, path_, "avcodec_receive_packet");
      // In the codec's time base, one frame; the file's time base is finer.
      packet_->duration = 1;
      av_packet_rescale_ts(packet_.get(), codec_->time_base, stream_->time_base);
      packet_->stream_index = stream_->index;
      Check(av_interleaved_write_frame(output_.get(), packet_.get()), path_,
            "av_interleaved_write_frame");
    }
  }

  std::filesystem::path path_;
  int width_px_, height_px_;
  bool has_levels_;
  int num_frames_ = 0;
  bool is_finished_ = false;
  internal::Output output_;
  AVStream* stream_ = nullptr;  // of output_
  internal::Codec codec_;
  internal::Scaler scaler_;
  internal::Frame rgb_, yuv_;
  internal::Packet packet_;
};

VideoWriter::VideoWriter(std::filesystem::path path, int width_px, int height_px,
                         double frames_per_second, VideoCoding coding) {
  constexpr int kMaxSize = 8192;
  if (width_px < 1 || width_px > kMaxSize || height_px < 1 || height_px > kMaxSize) {
    throw std::invalid_argument(path.string() + ": size is " + std::to_string(width_px) + "x" +
                                std::to_string(height_px) + ", expected 1 to " +
                                std::to_string(kMaxSize) + " pixels each");
  }
  if (!(frames_per_second > 0 && frames_per_second <= 1000)) {
    throw std::invalid_argument(path.string() + ": rate is " + std::to_string(frames_per_second) +
                                " frames per second, expected above 0 and at most 1000");
  }
  encoder_ =
      std::make_unique<Encoder>(std::move(path), width_px, height_px, frames_per_second, coding);
}

VideoWriter::~VideoWriter() {
  try {
    Finish();
  } catch (const std::exception&) {
    // A destructor cannot report errors; call Finish() for them.
  }
}

void VideoWriter::Add(const Image& image) { encoder_->Add(image); }
void VideoWriter::AddLevels(std::span<const std::uint16_t> levels) { encoder_->AddLevels(levels); }
void VideoWriter::Finish() { encoder_->Finish(); }
int VideoWriter::num_frames() const { return encoder_->num_frames(); }

VideoInfo ReadVideoInfo(const std::filesystem::path& path) {
  // Faults of the file are reported by exceptions below.
  av_log_set_level(AV_LOG_FATAL);
  const AVInputFormat* mp4 =
      CheckMade(av_find_input_format("mp4"), path, "av_find_input_format(mp4)");
  AVFormatContext* opened = nullptr;
  Check(avformat_open_input(&opened, internal::UrlOf(path).c_str(), mp4, nullptr), path,
        "avformat_open_input");
  const internal::Input input(opened);
  const int index = Check(av_find_best_stream(input.get(), AVMEDIA_TYPE_VIDEO, -1, -1, nullptr, 0),
                          path, "a film");
  const AVStream* stream = input->streams[index];
  const AVRational rate = stream->avg_frame_rate;
  return {.width_px = stream->codecpar->width,
          .height_px = stream->codecpar->height,
          .frames_per_second = rate.den == 0 ? 0 : av_q2d(rate),
          .num_frames = stream->nb_frames};
}

}  // namespace smile::video
