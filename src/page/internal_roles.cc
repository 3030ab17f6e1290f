#include "page/internal_roles.h"

#include <algorithm>
#include <string>

namespace smile::page {
namespace {

/// Between two requests of one client for control.
constexpr std::chrono::seconds kAskPause(10);

std::string SecondsText(std::chrono::steady_clock::duration time) {
  return std::to_string(std::chrono::ceil<std::chrono::seconds>(time).count()) + " s";
}

}  // namespace

void Roles::Leave(ClientId client) {
  std::erase(clients_, client);
  asked_.erase(client);
  if (controller_ == client) SetController(std::nullopt, last_sign_);
}

void Roles::NoteSignOfLife(ClientId client, Time now) {
  if (controller_ == client) last_sign_ = now;
}

bool Roles::Take(ClientId client, bool by_force, Time now) {
  if (controller_ == client) return true;
  if (controller_ && !(by_force ? MayForce(client, now) : MayAsk(client, now))) return false;
  SetController(client, now);
  return true;
}

bool Roles::MayAsk(ClientId client, Time now) {
  const auto [asked, is_first] = asked_.try_emplace(client, now);
  if (!is_first && now - asked->second < kAskPause) {
    throw RequestError("the controller was asked already; you may ask again in " +
                       SecondsText(kAskPause - (now - asked->second)));
  }
  asked->second = now;
  return false;
}

bool Roles::MayForce(ClientId client, Time now) {
  const auto [asked, is_first] = asked_.try_emplace(client, now);
  const auto silent = now - std::max(asked->second, last_sign_);
  if (silent >= silence_) return true;
  if (is_first) return false;
  throw RequestError("the controller was asked; control may be taken after a silence of " +
                     SecondsText(silence_) + ", which is over in " +
                     SecondsText(silence_ - silent) + " at the earliest");
}

void Roles::Give(ClientId from, std::optional<ClientId> to, Time now) {
  if (controller_ != from) throw RequestError("you are watching: there is no control to give");
  if (to && !IsHere(*to)) {
    throw RequestError("there is no client " + std::to_string(*to) + " to give control to");
  }
  SetController(to, now);
}

void Roles::SetController(std::optional<ClientId> client, Time now) {
  controller_ = client;
  last_sign_ = now;
  asked_.clear();
}

bool Roles::IsHere(ClientId client) const {
  return std::ranges::find(clients_, client) != clients_.end();
}

}  // namespace smile::page
