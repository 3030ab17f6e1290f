#include "web_server/internal_connection.h"

#include <algorithm>
#include <vector>

namespace smile::web_server {

bool Connections::MakeRoom() {
  if (all_.size() < max_) return true;
  std::shared_ptr<ClientConnection> longest;
  // Only idle connections may be closed; a download or WebSocket is not interrupted for a newcomer.
  for (const std::shared_ptr<ClientConnection>& each : all_) {
    if (!each->idle_since()) continue;
    if (!longest || *each->idle_since() < *longest->idle_since()) longest = each;
  }
  if (!longest) return false;
  // Removed at once: its own End() comes later, and the newcomer takes the place now. `longest`
  // keeps it until this function returns, and its pending operations keep it until they have
  // failed.
  Remove(longest.get());
  longest->Abort();
  return true;
}

void Connections::Remove(const ClientConnection* connection) {
  all_.remove_if([connection](const auto& each) { return each.get() == connection; });
}

void Connections::Resume() {
  // A copy, since a connection that ends during the loop leaves the list.
  const std::vector<std::shared_ptr<ClientConnection>> all(all_.begin(), all_.end());
  for (const std::shared_ptr<ClientConnection>& each : all) each->Resume();
}

void Connections::AbortIdle() {
  // A copy, as in Resume().
  const std::vector<std::shared_ptr<ClientConnection>> all(all_.begin(), all_.end());
  for (const std::shared_ptr<ClientConnection>& each : all) {
    if (each->idle_since()) each->Abort();
  }
}

}  // namespace smile::web_server
