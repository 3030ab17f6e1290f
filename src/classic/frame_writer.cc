#include "classic/frame_writer.h"

#include <utility>

#include "image/png.h"

namespace smile::classic {

FrameWriter::FrameWriter(const std::filesystem::path& index) : index_(index) {}

FrameWriter::~FrameWriter() {
  {
    const std::lock_guard lock(mutex_);
    is_ending_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void FrameWriter::Add(Frame frame) {
  std::unique_lock lock(mutex_);
  // A slow disk delays the simulation; pictures are never left out.
  changed_.wait(lock, [this] { return waiting_.size() < kMaxWaiting; });
  if (failure_) std::rethrow_exception(failure_);
  index_size_ += frame.line.size();
  // A line alone is not worth a thread, but must not overtake the lines that wait.
  if (frame.image.color.empty() && waiting_.empty()) return Write(frame);
  waiting_.push_back(std::move(frame));
  if (!thread_.joinable()) thread_ = std::thread([this] { WriteWaiting(); });
  changed_.notify_all();
}

void FrameWriter::Flush() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return waiting_.empty(); });
  if (failure_) std::rethrow_exception(failure_);
}

void FrameWriter::CutIndex(std::uint64_t size) {
  // Nothing waits from here on, so the index belongs to the caller's thread.
  Flush();
  index_.Cut(size);
  index_size_ = size;
}

void FrameWriter::WriteWaiting() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return !waiting_.empty() || is_ending_; });
    if (waiting_.empty()) return;
    // Additions to a deque leave its elements where they are.
    const Frame& frame = waiting_.front();
    lock.unlock();
    std::exception_ptr failure;
    try {
      Write(frame);
    } catch (...) {
      failure = std::current_exception();
    }
    lock.lock();
    // After a failure nothing is written: the view ends with its last whole frame.
    if (failure) {
      failure_ = failure;
      waiting_.clear();
    } else {
      waiting_.pop_front();
    }
    changed_.notify_all();
  }
}

void FrameWriter::Write(const Frame& frame) {
  if (!frame.image.color.empty()) WritePng(frame.picture, frame.image);
  index_.Append(frame.line);
}

}  // namespace smile::classic
