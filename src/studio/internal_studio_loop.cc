#include "studio/internal_studio_loop.h"

#include <chrono>
#include <cmath>
#include <utility>

#include "base/wording.h"

namespace smile::studio {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kSlowest = 0.1, kFastest = 4;

}  // namespace

StudioLoop::StudioLoop(Workplace* workplace, Server* server, Errands* errands)
    : workplace_(workplace),
      server_(server),
      errands_(errands),
      requests_(AllRequests()),
      pacer_(Clock::now()),
      press_(server) {}

RequestTable StudioLoop::AllRequests() {
  RequestTable table = workplace_->requests();
  table.entries["speed"] = {[this](const Request& request) { return SetSpeed(request); }};
  return table;
}

Json StudioLoop::SetSpeed(const Request& request) {
  const Json factor = request.fields.value("factor", Json());
  if (!factor.is_number() || factor < kSlowest || factor > kFastest) {
    throw RequestError("`factor` is " + ToText(factor) + ", expected a number from " +
                       NumberText(kSlowest) + " to " + NumberText(kFastest));
  }
  pacer_.SetFactor(factor.get<double>());
  return Json::object();
}

void StudioLoop::Beat() {
  const int ticks_due = pacer_.BeginBeat(Clock::now());
  CarryOutRequests();
  errands_->CarryOut();
  pacer_.EndBeat(DoTicks(ticks_due), Clock::now());
  const Poses poses = workplace_->NextPoses();
  // What poses are of is told before them.
  TellNews(poses);
  TellNewClients();
  server_->SendPoses(poses);
}

void StudioLoop::CarryOutRequests() {
  for (const Request& request : server_->TakeRequests()) {
    server_->Send(request.client,
                  Answer(requests_, request, server_->IsController(request.client)));
  }
}

int StudioLoop::DoTicks(int count) {
  int done = 0;
  while (done < count && (done == 0 || Clock::now() < pacer_.next_beat())) {
    workplace_->Tick();
    ++done;
  }
  return done;
}

void StudioLoop::TellNews(const Poses& poses) {
  News news = workplace_->TakeNews();
  for (Json& message : news.messages) server_->SendToAll(WithSpeed(std::move(message)));
  if (news.view) {
    press_.Print({.image = std::move(*news.view),
                  .is_recorded = news.is_view_recorded,
                  .scene = poses.scene,
                  .tick = poses.tick});
  }
}

void StudioLoop::TellNewClients() {
  for (const ClientId client : server_->TakeNewClients()) {
    for (Json& message : workplace_->Everything()) {
      server_->Send(client, WithSpeed(std::move(message)));
    }
  }
}

/// Only here is known how much real time goes by.
Json StudioLoop::WithSpeed(Json message) const {
  if (message.value("t", "") != "state") return message;
  const bool is_paused = message.value("paused", false);
  message["speed"] = is_paused ? 0.0 : std::round(100 * pacer_.speed()) / 100;
  return message;
}

}  // namespace smile::studio
