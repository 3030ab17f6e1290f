#include "studio/internal_roles.h"

#include <algorithm>

namespace smile::studio {

void Roles::Leave(ClientId client) {
  std::erase(clients_, client);
  if (controller_ == client) controller_.reset();
}

void Roles::NoteSignOfLife(ClientId client, Time now) {
  if (controller_ == client) last_sign_ = now;
}

bool Roles::Take(ClientId client, bool by_force, Time now) {
  if (controller_ == client) return true;
  if (controller_ && !(by_force && now - last_sign_ >= silence_)) return false;
  controller_ = client;
  last_sign_ = now;
  return true;
}

void Roles::Give(ClientId from, std::optional<ClientId> to, Time now) {
  if (controller_ != from) throw RequestError("you are watching: there is no control to give");
  if (to && !IsHere(*to)) {
    throw RequestError("there is no client " + std::to_string(*to) + " to give control to");
  }
  controller_ = to;
  last_sign_ = now;
}

bool Roles::IsHere(ClientId client) const {
  return std::ranges::find(clients_, client) != clients_.end();
}

}  // namespace smile::studio
