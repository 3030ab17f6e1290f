#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <vector>

#include "page/requests.h"

namespace smile::page {

/// Who is here, and who of them is the controller: one at most.
class Roles {
 public:
  using Time = std::chrono::steady_clock::time_point;

  /// @param silence  of a controller who was asked, after which control may be taken by force.
  explicit Roles(std::chrono::milliseconds silence) : silence_(silence) {}

  void Join(ClientId client) { clients_.push_back(client); }
  void Leave(ClientId client);
  /// The client did something.
  void NoteSignOfLife(ClientId client, Time now);

  /// True if the client is the controller from now on, or already is; false if the one who is has
  /// to be asked now.
  ///
  /// By force control is taken only from a controller whom this client has asked, and who has done
  /// nothing since for the time of silence.
  /// @throws RequestError if the client or another asked a moment ago, or the silence is not over.
  [[nodiscard]] bool Take(ClientId client, bool by_force, Time now);
  /// @throws RequestError if `from` does not control, or `to` is not here.
  void Give(ClientId from, std::optional<ClientId> to, Time now);

  std::optional<ClientId> controller() const { return controller_; }
  bool IsHere(ClientId client) const;
  const std::vector<ClientId>& clients() const { return clients_; }

 private:
  bool MayAsk(ClientId client, Time now);
  bool MayForce(ClientId client, Time now);
  /// @throws RequestError if the controller was asked a moment ago, whoever did that.
  void NoteAsked(ClientId client, Time now);
  void SetController(std::optional<ClientId> client, Time now);

  std::chrono::milliseconds silence_;
  std::vector<ClientId> clients_;  ///< in the order in which they came
  std::optional<ClientId> controller_;
  Time last_sign_{};                ///< of the controller
  std::map<ClientId, Time> asked_;  ///< those who asked the controller for control, and when
  std::optional<Time> last_asked_;  ///< when anyone did, also one who left since
};

}  // namespace smile::page
