#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "page/internal_control_arbiter.h"
#include "page/internal_pose_broadcaster.h"
#include "page/server.h"
#include "web_server/web_socket_handler.h"

namespace smile::page {

/// Clients: their requests and messages, exchanged between the threads of the web server and the
/// thread of the session. Thread-safe; no function waits.
class Clients : public web_server::WebSocketHandler {
 public:
  explicit Clients(const ServerLimits& limits);
  Clients(const Clients&) = delete;
  Clients& operator=(const Clients&) = delete;

  // For the web server.

  /// Closes the oldest client that has not said hello if the limit of clients is reached.
  bool Open(ClientId client) override;
  void Receive(ClientId client, bool is_text, std::string_view message) override;
  /// Returns false while too many requests of this client wait for the session.
  bool CanReceive(ClientId client) override;
  void LimitExceeded(ClientId client, const std::string& reason) override;
  std::optional<web_server::OutgoingMessage> NextMessage(ClientId client) override;
  void Close(ClientId client) override;

  // For the thread of the session; see Server.

  std::vector<Request> TakeRequests();
  std::vector<ClientId> TakeNewClients();
  bool IsController(ClientId client) const;
  void Send(ClientId client, const Json& message);
  void SendToAll(const Json& message);
  void SendPoses(const Poses& poses);
  void SendView(std::uint32_t scene, std::uint32_t tick, std::string png, bool is_recorded);

  /// Closes all clients, and refuses new ones.
  void CloseAll();

 private:
  using Lock = std::lock_guard<std::mutex>;
  using Time = std::chrono::steady_clock::time_point;
  using CloseCode = web_server::CloseCode;
  using OutgoingMessage = web_server::OutgoingMessage;

  struct Waiting {
    Request request;
    std::size_t bytes = 0;
  };
  struct Client {
    Time since;

    // Its requests.
    int mistakes = 0;
    bool said_hello = false;
    std::deque<Waiting> waiting;
    std::size_t waiting_bytes = 0;

    // Its messages.
    bool has_scene = false;  ///< has received the scene, so updates make sense
    std::deque<OutgoingMessage> outbox;
    std::size_t outbox_bytes = 0;
    PoseBroadcaster::Version known_poses = 0;
    std::uint64_t known_view = 0;
    std::uint32_t carried_out = 0;     ///< seq of its last request that was carried out
    std::uint32_t to_acknowledge = 0;  ///< the same, when poses were sent last
    std::uint32_t acknowledged = 0;
    bool is_closing = false;
  };
  struct EyeView {
    std::uint64_t number = 0;
    std::uint32_t scene = 0, tick = 0;
    bool is_recorded = false;
    std::shared_ptr<const std::string> png;
  };

  Client* Find(ClientId id);
  void Refuse(Client* client, std::uint32_t seq, const std::string& error);
  bool MakeRoom();
  void CloseSilentClients();
  /// Returns the requests that the server itself carries out.
  RequestTable OwnRequests();
  Json Hello(const Request& request);
  Json TakeControl(const Request& request);
  Json GiveControl(const Request& request);
  Json ControllerNumber() const;
  void Post(Client* client, OutgoingMessage message);
  void PostJson(Client* client, const Json& message);
  void CloseNow(Client* client, CloseCode code, std::string_view reason);
  void SendClientList();
  bool HasMessage(const Client& client) const;
  OutgoingMessage TakeMessage(Client* client);
  OutgoingMessage PosesFor(Client* client);
  OutgoingMessage ViewFor(Client* client);

  ServerLimits limits_;
  RequestTable own_requests_;
  mutable std::mutex mutex_;
  std::map<ClientId, Client> clients_;
  ClientId last_id_ = 0;
  bool is_open_ = true;
  ControlArbiter arbiter_;
  bool must_send_clients_ = false;  ///< after the reply
  std::vector<ClientId> new_clients_;
  PoseBroadcaster poses_;
  EyeView view_;
};

}  // namespace smile::page
