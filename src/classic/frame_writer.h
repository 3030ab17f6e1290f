#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "image/image.h"
#include "recording/append_file.h"

namespace smile::classic {

/// Writer of the frames of a classic view: pictures, and the index of frames. Pictures are
/// compressed by a thread of its own, since one takes as long as many ticks.
///
/// Frames are written in order, and the picture of a frame before its line in the index: every line
/// names a picture that exists, however the program ends. If one cannot be written, no later one
/// is.
class FrameWriter {
 public:
  struct Frame {
    std::filesystem::path picture;  ///< file to write
    Image image;                    ///< nothing to write if it has no color
    std::string line;               ///< for the index
  };
  /// Number of frames that may wait for the thread; memory for that many images.
  static constexpr std::size_t kMaxWaiting = 8;

  /// Makes a new index. Throws like AppendFile.
  explicit FrameWriter(const std::filesystem::path& index);
  /// Writes the frames that wait. Does not report errors: see Flush().
  ~FrameWriter();
  FrameWriter(const FrameWriter&) = delete;
  FrameWriter& operator=(const FrameWriter&) = delete;

  /// Takes a frame. Returns at once, unless kMaxWaiting frames wait.
  /// @throws std::runtime_error with path and reason if this or an earlier frame could not be
  ///         written.
  void Add(Frame frame);
  /// Waits until all frames are written. Throws like Add().
  void Flush();

  /// Returns the size of the index with the lines of all frames so far [bytes].
  std::uint64_t index_size() const { return index_size_; }
  /// Waits until all frames are written, and cuts the index. Throws like Add().
  void CutIndex(std::uint64_t size);

 private:
  void WriteWaiting();
  /// Returns why the frame could not be written; nullptr if it was.
  std::exception_ptr Write(const Frame& frame);

  recording::AppendFile index_;  ///< of the thread while frames wait
  std::uint64_t index_size_ = 0;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Frame> waiting_;  ///< the first one is being written
  std::exception_ptr failure_;
  bool is_ending_ = false;
  std::thread thread_;  ///< begins with the first picture
};

}  // namespace smile::classic
