#include "page/internal_control_arbiter.h"
#include "texts/user_message.h"

#include <algorithm>
#include <string>

// Rules of control. A free place is granted at once. A controller is first asked; only a client
// that has asked may take control by force, and only after the controller has been inactive since.
// So control is never lost while its owner works, and never blocked by one who has left. All times
// are parameters: the rules have no clock of their own, and tests choose the times.

namespace smile::page {

using texts::Say;
namespace {

/// Minimum time between two requests of one client for control.
constexpr std::chrono::seconds kRequestInterval(10);
/// Minimum time between requests of any clients: a client that reconnects counts as another one.
constexpr std::chrono::seconds kRequestIntervalOfAll(3);

/// Returns a time in seconds, rounded up.
std::int64_t WholeSeconds(std::chrono::steady_clock::duration time) {
  return std::chrono::ceil<std::chrono::seconds>(time).count();
}

}  // namespace

void ControlArbiter::Leave(ClientId client) {
  std::erase(clients_, client);
  requested_.erase(client);
  // Control does not pass to another client by itself: the next owner must want it.
  if (controller_ == client) SetController(std::nullopt, last_sign_);
}

void ControlArbiter::NoteSignOfLife(ClientId client, Time now) {
  if (controller_ == client) last_sign_ = now;
}

bool ControlArbiter::Take(ClientId client, bool by_force, Time now) {
  if (controller_ == client) return true;
  if (controller_ && !(by_force ? ForceControl(client, now) : RequestControl(client, now)))
    return false;
  SetController(client, now);
  return true;
}

/// Records that the client asks, unless it asked a short time ago; control is never granted at
/// once.
bool ControlArbiter::RequestControl(ClientId client, Time now) {
  const auto requested = requested_.find(client);
  if (requested != requested_.end() && now - requested->second < kRequestInterval) {
    const auto wait = kRequestInterval - (now - requested->second);
    throw RequestError(Say("control.wasAsked", {{"seconds", WholeSeconds(wait)}}));
  }
  NoteRequest(client, now);
  return false;
}

/// Returns true if the controller has been silent long enough since this client asked. The first
/// attempt counts as asking.
bool ControlArbiter::ForceControl(ClientId client, Time now) {
  const auto requested = requested_.find(client);
  const bool is_first = requested == requested_.end();
  // Silence starts with the later one of the question and the controller's last activity.
  const auto silence = now - std::max(is_first ? now : requested->second, last_sign_);
  if (silence >= silence_) return true;
  if (is_first) {
    NoteRequest(client, now);
    return false;
  }
  throw RequestError(Say("control.isActive", {{"silence", WholeSeconds(silence_)},
                                              {"seconds", WholeSeconds(silence_ - silence)}}));
}

void ControlArbiter::NoteRequest(ClientId client, Time now) {
  // The limit holds for all clients together, since each question interrupts the
  // controller.
  if (last_request_ && now - *last_request_ < kRequestIntervalOfAll) {
    const auto wait = kRequestIntervalOfAll - (now - *last_request_);
    throw RequestError(Say("control.wasAskedByOther", {{"seconds", WholeSeconds(wait)}}));
  }
  requested_[client] = now;
  last_request_ = now;
}

void ControlArbiter::Give(ClientId from, std::optional<ClientId> to, Time now) {
  if (controller_ != from) throw RequestError(Say("control.noneToGive"));
  if (to && !IsHere(*to)) {
    throw RequestError(Say("control.noClient", {{"client", *to}}));
  }
  SetController(to, now);
}

void ControlArbiter::SetController(std::optional<ClientId> client, Time now) {
  controller_ = client;
  last_sign_ = now;
  // Questions were directed at the former controller; the new one has not been asked.
  requested_.clear();
  last_request_.reset();
}

bool ControlArbiter::IsHere(ClientId client) const {
  return std::ranges::find(clients_, client) != clients_.end();
}

}  // namespace smile::page
