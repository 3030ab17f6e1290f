#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "studio/internal_frames.h"
#include "studio/internal_pose_board.h"
#include "studio/internal_rate_limit.h"
#include "studio/internal_roles.h"
#include "studio/server.h"

namespace smile::studio {

/// All clients, what they asked for and what is to be sent to them: the place where the threads of
/// connections and the one of the session meet. Knows no sockets. Every function may be called from
/// any thread.
class Clients {
 public:
  explicit Clients(const ServerLimits& limits);
  Clients(const Clients&) = delete;
  Clients& operator=(const Clients&) = delete;

  // For the threads of a connection.

  /// A new client; nullopt if there are too many.
  std::optional<ClientId> Enter();
  /// Nothing more comes from it, nothing more is sent to it.
  void Leave(ClientId client);
  /// To be called last, when no other thread asks for its mail any more.
  void Forget(ClientId client);
  /// `count` frames came. False, and the client is told and closed, if they come too fast.
  bool CountFrames(ClientId client, std::uint64_t count);
  /// Takes in a request; waits while too many of this client wait already.
  void Receive(ClientId client, std::string_view text);
  /// Asks for a frame of the connection itself to be sent.
  void SendControl(ClientId client, Opcode opcode, std::string payload);
  /// What is under way is sent, then the reason, then nothing.
  void Close(ClientId client, CloseCode code, std::string_view reason);
  bool IsClosing(ClientId client) const;

  struct Mail {
    Opcode opcode = Opcode::kText;
    std::string head;                         ///< of binary messages
    std::shared_ptr<const std::string> body;  ///< shared by all it goes to
  };
  /// Waits for what is to be sent next; nullopt when nothing more will be.
  std::optional<Mail> NextMail(ClientId client);

  // For the thread of the session; see Server.

  std::vector<Request> TakeRequests();
  std::vector<ClientId> TakeNewClients();
  bool IsController(ClientId client) const;
  void Send(ClientId client, const Json& message);
  void SendToAll(const Json& message);
  void SendPoses(const Poses& poses);
  void SendView(std::uint32_t scene, std::uint32_t tick, std::string png, bool is_recorded);

  /// Closes all, and lets nobody in.
  void CloseAll();

 private:
  using Lock = std::unique_lock<std::mutex>;

  struct Waiting {
    Request request;
    std::size_t bytes = 0;
  };
  struct Client {
    explicit Client(const RateLimit& limit) : rate(limit) {}

    // What it asks for.
    RateLimit rate;
    int mistakes = 0;
    bool said_hello = false;
    std::deque<Waiting> waiting;
    std::size_t waiting_bytes = 0;
    std::condition_variable room;  ///< for another request

    // What it is told.
    bool knows_everything = false;  ///< it was told the scene, so news make sense
    std::deque<Mail> news;
    std::size_t news_bytes = 0;
    PoseBoard::Version known_poses = 0;
    std::uint64_t known_view = 0;
    std::uint32_t carried_out = 0;     ///< its last request that was
    std::uint32_t to_acknowledge = 0;  ///< the same, when poses were sent last
    std::uint32_t acknowledged = 0;
    bool is_closing = false;
    std::condition_variable mail;
  };
  struct View {
    std::uint64_t number = 0;
    std::uint32_t scene = 0, tick = 0;
    bool is_recorded = false;
    std::shared_ptr<const std::string> png;
  };

  Client* Find(ClientId id);
  void Refuse(Client* client, std::uint32_t seq, const std::string& error);
  void LetWait(Lock* lock, Client* client, Request request, std::size_t bytes);
  /// What the server itself carries out.
  RequestTable OwnRequests();
  Json Hello(const Request& request);
  Json TakeControl(const Request& request);
  Json GiveControl(const Request& request);
  Json ControllerNumber() const;
  void Post(Client* client, Mail mail);
  void PostJson(Client* client, const Json& message);
  void CloseNow(Client* client, CloseCode code, std::string_view reason);
  void TellWhoIsHere();
  bool HasMail(const Client& client) const;
  Mail TakeMail(Client* client);
  Mail PosesFor(Client* client);
  Mail ViewFor(Client* client);

  ServerLimits limits_;
  RequestTable own_requests_;
  mutable std::mutex mutex_;
  std::map<ClientId, Client> clients_;
  ClientId last_id_ = 0;
  bool is_open_ = true;
  Roles roles_;
  bool is_news_who_is_here_ = false;  ///< to be told after the answer
  std::vector<ClientId> new_clients_;
  PoseBoard poses_;
  View view_;
};

}  // namespace smile::studio
