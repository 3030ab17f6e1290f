#include "studio/internal_studio_loop.h"

#include <chrono>
#include <utility>

// One frame of the studio. Everything that touches the session happens here, in one thread and in a
// fixed order; other threads only queue requests before and send messages after.

namespace smile::studio {
namespace {

using Clock = std::chrono::steady_clock;

}  // namespace

StudioLoop::StudioLoop(SessionInterface* session, page::Server* server)
    : session_(session), server_(server), timer_(Clock::now()), view_encoder_(server) {}

void StudioLoop::Step() {
  // Order of a frame: requests, ticks, updates, poses; so a command is visible in the frame in
  // which it arrives.
  timer_.SetFactor(session_->speed_factor());
  const int ticks_due = timer_.BeginFrame(Clock::now());
  CarryOutRequests();
  DoTicks(ticks_due);
  session_->SetMeasuredSpeed(timer_.speed());
  const page::Poses poses = session_->NextPoses();
  // The scene must be sent before its poses.
  SendUpdates(poses);
  SendToNewClients();
  server_->SendPoses(poses);
}

void StudioLoop::CarryOutRequests() {
  for (const page::Request& request : server_->TakeRequests()) {
    const Json answer =
        Answer(session_->requests(), request, server_->IsController(request.client));
    if (!page::IsLater(answer)) server_->Send(request.client, answer);
  }
}

void StudioLoop::DoTicks(int count) {
  // At least one tick per frame, so that a slow simulation advances; a waiting program ends the
  // loop.
  const Clock::time_point deadline = Clock::now() + FrameTimer::kFramePeriod;
  int done = 0;
  bool is_waiting = false;
  while (done < count && !is_waiting && (done == 0 || Clock::now() < deadline)) {
    is_waiting = !session_->Tick();
    if (!is_waiting) ++done;
  }
  timer_.EndFrame(done, is_waiting ? count - done : 0, Clock::now());
}

void StudioLoop::SendUpdates(const page::Poses& poses) {
  SessionUpdates updates = session_->TakeUpdates();
  for (const Json& message : updates.messages) server_->SendToAll(message);
  for (const page::DeferredMessage& deferred : TakeDeferred(session_->requests())) {
    if (deferred.client == 0) {
      server_->SendToAll(deferred.message);
    } else {
      server_->Send(deferred.client, deferred.message);
    }
  }
  if (updates.view) {
    view_encoder_.Encode({.image = std::move(*updates.view),
                          .is_recorded = updates.is_view_recorded,
                          .scene = poses.scene,
                          .tick = poses.tick});
  }
}

void StudioLoop::SendToNewClients() {
  for (const page::ClientId client : server_->TakeNewClients()) {
    for (const Json& message : session_->Everything()) server_->Send(client, message);
  }
}

}  // namespace smile::studio
