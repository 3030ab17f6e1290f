#pragma once

#include "page/server.h"
#include "studio/internal_eye_view_encoder.h"
#include "studio/internal_frame_timer.h"
#include "studio/session_interface.h"

namespace smile::studio {

/// Studio loop: executes requests, advances the session and sends updates, 60 times a second.
/// Belongs to the thread of the session.
class StudioLoop {
 public:
  /// Both must outlive this.
  StudioLoop(SessionInterface* session, page::Server* server);

  /// Runs one frame of 1/60 s.
  void Step();
  /// Returns the time at which the next step is due.
  FrameTimer::Time next_step() const { return timer_.next_frame(); }

 private:
  void CarryOutRequests();
  /// Does at most `count` ticks, as many as fit into one step.
  void DoTicks(int count);
  void SendUpdates(const page::Poses& poses);
  void SendToNewClients();

  SessionInterface* session_;
  page::Server* server_;
  FrameTimer timer_;
  EyeViewEncoder view_encoder_;
};

}  // namespace smile::studio
