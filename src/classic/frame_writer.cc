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
  const std::uint64_t size = index_size_ + frame.line.size();
  if (frame.image.color.empty() && waiting_.empty()) {
    // A line alone is not worth a thread, but must not overtake the lines that wait.
    failure_ = Write(frame);
    if (failure_) std::rethrow_exception(failure_);
  } else {
    // The thread first: without it, nothing may wait.
    if (!thread_.joinable()) thread_ = std::thread([this] { WriteWaiting(); });
    waiting_.push_back(std::move(frame));
    changed_.notify_all();
  }
  index_size_ = size;
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
    const std::exception_ptr failure = Write(frame);
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

std::exception_ptr FrameWriter::Write(const Frame& frame) {
  try {
    if (!frame.image.color.empty()) WritePng(frame.picture, frame.image);
    index_.Append(frame.line);
    return nullptr;
  } catch (...) {
    return std::current_exception();
  }
}

}  // namespace smile::classic
