#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

#include "image/image.h"

namespace smile::video {

/// Trade between the size of a film and access to its pictures.
enum class VideoCoding {
  kCompact,  ///< for people: pictures refer to many former and later ones
  /// For readers of single pictures: every second one stands alone, and none refers to a later one,
  /// so that times begin at 0 and pictures are stored in the order in which they are shown.
  kSeekable,
  /// For numbers, 0 to 4095, without loss: HEVC, 12 bits of gray; otherwise as kSeekable.
  kLevels,
};

/// Writer of an mp4 film that browsers and players show directly: H.264, 4:2:0, BT.709, with the
/// index in front. Equal pictures give equal bytes.
///
/// The format requires even sizes: the last column or row of an odd picture is repeated. Films of
/// numbers (VideoCoding::kLevels) may have any size from 16x16.
class VideoWriter {
 public:
  /// @param frames_per_second  above 0, at most 1000.
  /// @throws std::invalid_argument if sizes are not 1 to 8192 or the rate is out of range.
  /// @throws std::runtime_error naming the path and the reason.
  VideoWriter(std::filesystem::path path, int width_px, int height_px, double frames_per_second,
              VideoCoding coding = VideoCoding::kCompact);
  /// Finishes the film unless Finish() was called, so that the pictures so far can be watched;
  /// ignores errors.
  ~VideoWriter();
  VideoWriter(const VideoWriter&) = delete;
  VideoWriter& operator=(const VideoWriter&) = delete;

  /// Appends one picture, of which only the color is used.
  /// @throws std::invalid_argument if it has another size, or no color, or the film is of numbers.
  /// @throws std::logic_error after Finish().
  /// @throws std::runtime_error naming the path and the reason.
  void Add(const Image& image);

  /// Appends a picture of numbers, row by row from the top.
  /// @throws as Add(); std::invalid_argument if a number is above 4095, or the film is of colors.
  void AddLevels(std::span<const std::uint16_t> levels);

  /// Completes the file. Calling it again does nothing.
  /// @throws std::logic_error if no picture was added: players refuse such a film.
  /// @throws std::runtime_error naming the path and the reason.
  void Finish();

  int num_frames() const;

 private:
  class Encoder;
  std::unique_ptr<Encoder> encoder_;
};

/// Properties of a film from its index.
struct VideoInfo {
  int width_px = 0;
  int height_px = 0;
  double frames_per_second = 0;
  std::int64_t num_frames = 0;

  bool operator==(const VideoInfo&) const = default;
};

/// Reads an mp4 film's index.
/// @throws std::runtime_error naming the path and the reason.
VideoInfo ReadVideoInfo(const std::filesystem::path& path);

}  // namespace smile::video
