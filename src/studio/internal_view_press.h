#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <thread>

#include "image/image.h"
#include "page/server.h"

namespace smile::studio {

/// Makes PNGs of the robot's views and sends them, in a thread of its own: the simulation does not
/// wait for it. When views come faster than it works, the newest counts.
class ViewPress {
 public:
  explicit ViewPress(page::Server* server);
  ~ViewPress();
  ViewPress(const ViewPress&) = delete;
  ViewPress& operator=(const ViewPress&) = delete;

  struct View {
    Image image;
    bool is_recorded = false;
    std::uint32_t scene = 0, tick = 0;
  };
  void Print(View view);

 private:
  void Work();
  /// nullopt when the work is over.
  std::optional<View> Next();

  page::Server* server_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<View> next_;
  bool is_over_ = false;
  std::thread thread_;
};

}  // namespace smile::studio
