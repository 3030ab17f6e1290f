#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <thread>

#include "image/image.h"
#include "page/server.h"

namespace smile::studio {

/// Eye view encoder: encodes the pictures of the robot's eye as PNG and sends them, on a worker
/// thread. When pictures arrive faster than it encodes, older ones are skipped.
class EyeViewEncoder {
 public:
  explicit EyeViewEncoder(page::Server* server);
  ~EyeViewEncoder();
  EyeViewEncoder(const EyeViewEncoder&) = delete;
  EyeViewEncoder& operator=(const EyeViewEncoder&) = delete;

  struct Picture {
    Image image;
    bool is_recorded = false;
    std::uint32_t scene = 0, tick = 0;
  };
  /// Encodes and sends a picture; returns at once.
  void Encode(Picture picture);

 private:
  void WorkerLoop();
  /// Returns nullopt when this object is destroyed.
  std::optional<Picture> Next();

  page::Server* server_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<Picture> next_;
  bool is_over_ = false;
  std::thread thread_;
};

}  // namespace smile::studio
