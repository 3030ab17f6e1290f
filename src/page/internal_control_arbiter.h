#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <vector>

#include "page/requests.h"

namespace smile::page {

/// Control arbiter: the list of clients, of which at most one is the controller.
class ControlArbiter {
 public:
  using Time = std::chrono::steady_clock::time_point;

  /// @param silence  inactivity of the asked controller after which control may be taken by force.
  explicit ControlArbiter(std::chrono::milliseconds silence) : silence_(silence) {}

  void Join(ClientId client) { clients_.push_back(client); }
  void Leave(ClientId client);
  /// Records that the client was active.
  void NoteSignOfLife(ClientId client, Time now);

  /// Returns true if the client is the controller from now on, or already is; false if the current
  /// controller has to be asked now.
  ///
  /// Taking by force succeeds only if this client has asked the controller, who has been inactive
  /// for the time of silence since.
  /// @throws RequestError if the client or another asked too recently, or the silence is not over.
  [[nodiscard]] bool Take(ClientId client, bool by_force, Time now);
  /// @throws RequestError if `from` does not control, or `to` is not a client.
  void Give(ClientId from, std::optional<ClientId> to, Time now);

  std::optional<ClientId> controller() const { return controller_; }
  bool IsHere(ClientId client) const;
  const std::vector<ClientId>& clients() const { return clients_; }

 private:
  bool RequestControl(ClientId client, Time now);
  bool ForceControl(ClientId client, Time now);
  /// @throws RequestError if any client asked the controller too recently.
  void NoteRequest(ClientId client, Time now);
  void SetController(std::optional<ClientId> client, Time now);

  std::chrono::milliseconds silence_;
  std::vector<ClientId> clients_;  ///< in order of arrival
  std::optional<ClientId> controller_;
  Time last_sign_{};                    ///< of the controller
  std::map<ClientId, Time> requested_;  ///< time of the last request of each client
  std::optional<Time> last_request_;    ///< time of the last request of any client
};

}  // namespace smile::page
