#include "studio/internal_eye_view_encoder.h"

#include <utility>

#include "image/png.h"

// Encoding a picture as PNG can take longer than a frame; one thread does it, with at most one
// picture waiting. mutex_ guards next_ and is_over_.

namespace smile::studio {

EyeViewEncoder::EyeViewEncoder(page::Server* server)
    : server_(server), thread_([this] { WorkerLoop(); }) {}

EyeViewEncoder::~EyeViewEncoder() {
  {
    const std::lock_guard lock(mutex_);
    is_over_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void EyeViewEncoder::Encode(Picture picture) {
  {
    const std::lock_guard lock(mutex_);
    // Overwrites a picture that is still waiting: only the newest is of interest.
    next_ = std::move(picture);
  }
  changed_.notify_all();
}

std::optional<EyeViewEncoder::Picture> EyeViewEncoder::Next() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return is_over_ || next_; });
  // A picture that still waits at the end is of no use.
  if (is_over_) return std::nullopt;
  return std::exchange(next_, std::nullopt);
}

void EyeViewEncoder::WorkerLoop() {
  while (const std::optional<Picture> picture = Next()) {
    // Without the lock, so that Encode() never waits for the encoder.
    server_->SendView(picture->scene, picture->tick, EncodePng(picture->image),
                      picture->is_recorded);
  }
}

}  // namespace smile::studio
