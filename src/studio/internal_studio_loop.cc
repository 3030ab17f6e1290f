#include "studio/internal_studio_loop.h"

#include <chrono>
#include <utility>

namespace smile::studio {
namespace {

using Clock = std::chrono::steady_clock;

}  // namespace

StudioLoop::StudioLoop(Workplace* workplace, page::Server* server)
    : workplace_(workplace), server_(server), pacer_(Clock::now()), press_(server) {}

void StudioLoop::Beat() {
  pacer_.SetFactor(workplace_->speed_factor());
  const int ticks_due = pacer_.BeginBeat(Clock::now());
  CarryOutRequests();
  DoTicks(ticks_due);
  workplace_->SetMeasuredSpeed(pacer_.speed());
  const page::Poses poses = workplace_->NextPoses();
  // What poses are of is told before them.
  SendUpdates(poses);
  TellNewClients();
  server_->SendPoses(poses);
}

void StudioLoop::CarryOutRequests() {
  for (const page::Request& request : server_->TakeRequests()) {
    const Json answer =
        Answer(workplace_->requests(), request, server_->IsController(request.client));
    if (!page::IsLater(answer)) server_->Send(request.client, answer);
  }
}

void StudioLoop::DoTicks(int count) {
  const Clock::time_point deadline = Clock::now() + Pacer::kBeat;
  int done = 0;
  bool is_waiting = false;
  while (done < count && !is_waiting && (done == 0 || Clock::now() < deadline)) {
    is_waiting = !workplace_->Tick();
    if (!is_waiting) ++done;
  }
  pacer_.EndBeat(done, is_waiting ? count - done : 0, Clock::now());
}

void StudioLoop::SendUpdates(const page::Poses& poses) {
  SessionUpdates updates = workplace_->TakeUpdates();
  for (const Json& message : updates.messages) server_->SendToAll(message);
  for (const page::DeferredMessage& deferred : TakeDeferred(workplace_->requests())) {
    if (deferred.client == 0) {
      server_->SendToAll(deferred.message);
    } else {
      server_->Send(deferred.client, deferred.message);
    }
  }
  if (updates.view) {
    press_.Print({.image = std::move(*updates.view),
                  .is_recorded = updates.is_view_recorded,
                  .scene = poses.scene,
                  .tick = poses.tick});
  }
}

void StudioLoop::TellNewClients() {
  for (const page::ClientId client : server_->TakeNewClients()) {
    for (const Json& message : workplace_->Everything()) server_->Send(client, message);
  }
}

}  // namespace smile::studio
