#include "page/internal_clients.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "base/bytes.h"
#include "base/version.h"

// Three parties meet here: the thread of the web server (Open, Receive, CanReceive, NextMessage,
// Close), the thread of the session (TakeRequests, Send...), and the thread that encodes the eye's
// pictures (SendView). mutex_ guards all members; no function holds it while it waits or writes to
// the network.
//
// Messages are of two kinds. Replies and updates are news: each is queued in the client's outbox
// and sent in order. Poses and views are state: only their newest version is stored, once for all
// clients, and each client remembers the version that it has.

namespace smile::page {
namespace {

// Version of docs/studio-protocol.md; `hello` refuses a page that was built for another one.
constexpr int kProtocolVersion = 1;
/// Number of invalid requests after which a client is closed: the page sends none.
constexpr int kMaxMistakes = 10;
/// Maximal number of waiting requests per client; further ones are not read from the network, which
/// slows the client down.
constexpr std::size_t kMaxWaitingRequests = 64;

// First byte of a binary message.
constexpr std::uint8_t kPosesKind = 1, kViewKind = 2;

std::chrono::steady_clock::time_point Now() { return std::chrono::steady_clock::now(); }

/// Returns the header of a binary message, 16 bytes, little-endian: kind u8, flag u8 (all frames,
/// or recorded), number of frames u16, scene u32, tick u32, acknowledged request u32. The pose
/// records or the PNG file follow.
std::string BinaryHead(std::uint8_t kind, bool flag, std::uint16_t count, std::uint32_t scene,
                       std::uint32_t tick, std::uint32_t ack) {
  ByteWriter head;
  head.Put(kind);
  head.Put(static_cast<std::uint8_t>(flag ? 1 : 0));
  head.Put(count);
  head.Put(scene);
  head.Put(tick);
  head.Put(ack);
  return {reinterpret_cast<const char*>(head.bytes().data()), head.size()};
}

/// @throws std::invalid_argument if the text is no request.
Request ParseRequest(ClientId client, std::string_view text) {
  Json fields = ParseJson(text);
  if (!fields.is_object()) throw std::invalid_argument("a request is an object");
  // `seq` begins at 1: replies to messages without a valid one have 0.
  const auto seq = fields.find("seq");
  constexpr std::uint64_t kMaxSeq = std::numeric_limits<std::uint32_t>::max();
  if (seq == fields.end() || !seq->is_number_unsigned() || seq->get<std::uint64_t>() < 1 ||
      seq->get<std::uint64_t>() > kMaxSeq) {
    throw std::invalid_argument("a request has a `seq`, a number from 1 up");
  }
  const auto what = fields.find("do");
  if (what == fields.end() || !what->is_string()) {
    throw std::invalid_argument("a request has a `do`, a word");
  }
  const auto number = seq->get<std::uint32_t>();
  std::string word = what->get<std::string>();
  return {.client = client, .seq = number, .what = std::move(word), .fields = std::move(fields)};
}

}  // namespace

Clients::Clients(const ServerLimits& limits)
    : limits_(limits),
      own_requests_(OwnRequests()),
      arbiter_(std::chrono::milliseconds(std::lround(1000 * limits.silence_seconds))) {}

Clients::Client* Clients::Find(ClientId id) {
  const auto client = clients_.find(id);
  return client == clients_.end() ? nullptr : &client->second;
}

bool Clients::MakeRoom() {
  // A client that is being closed stays in the map until its connection ends, but takes no place.
  const auto is_here = [](const auto& entry) { return !entry.second.is_closing; };
  if (std::ranges::count_if(clients_, is_here) < limits_.clients) return true;
  // Connections that never said hello are the least valuable, so they cannot exclude real clients.
  const auto silent = std::ranges::find_if(clients_, [](const auto& entry) {
    return !entry.second.is_closing && !entry.second.said_hello;
  });
  if (silent == clients_.end()) return false;
  CloseNow(&silent->second, CloseCode::kPolicyViolation,
           "no hello arrived, and other clients are waiting");
  return true;
}

bool Clients::Open(ClientId id) {
  const Lock lock(mutex_);
  if (!is_open_ || !MakeRoom()) return false;
  clients_[id].since = Now();
  return true;
}

void Clients::Close(ClientId id) {
  const Lock lock(mutex_);
  // Only clients that said hello appear in the list of the others.
  const bool was_here = arbiter_.IsHere(id);
  arbiter_.Leave(id);
  std::erase(new_clients_, id);
  // Its queued requests go with it: no client would receive the replies.
  clients_.erase(id);
  if (was_here) SendClientList();
}

void Clients::LimitExceeded(ClientId id, const std::string& reason) {
  const Lock lock(mutex_);
  Client* client = Find(id);
  PostJson(client, {{"t", "error"}, {"error", reason}});
  CloseNow(client, CloseCode::kPolicyViolation, reason);
}

void Clients::Receive(ClientId id, bool is_text, std::string_view text) {
  // Parsed before the lock, since it depends on nothing shared.
  std::optional<Request> request;
  std::string error;
  try {
    if (is_text) request = ParseRequest(id, text);
  } catch (const std::exception& failure) {
    error = failure.what();
  }
  const Lock lock(mutex_);
  Client* client = Find(id);
  // A message passes these gates in order: it is text, it is a request, the client has said hello.
  // Only then may it have an effect.
  if (client->is_closing) return;
  if (!is_text) return CloseNow(client, CloseCode::kUnsupported, "requests are text");
  if (!request) return Refuse(client, /*seq=*/0, error);
  if (!client->said_hello && request->what != "hello") {
    return Refuse(client, request->seq, "send hello first");
  }
  // Pings are sent by the page itself, without its user.
  if (request->what != "ping") arbiter_.NoteSignOfLife(id, Now());
  // Requests for the session wait for its thread; those about the connection are answered at once.
  if (!own_requests_.requests.contains(request->what)) {
    // Counted by the bytes of its text, which bound the memory of the parsed request up to a
    // constant factor.
    client->waiting.push_back({std::move(*request), text.size()});
    client->waiting_bytes += text.size();
    return;
  }
  // Handlers of own requests run with the lock held; they call only functions that expect it.
  PostJson(client, Answer(own_requests_, *request, arbiter_.controller() == id));
  client->carried_out = std::max(client->carried_out, request->seq);
  // After the reply, so that the client knows its own number.
  if (std::exchange(must_send_clients_, false)) SendClientList();
}

bool Clients::CanReceive(ClientId id) {
  const Lock lock(mutex_);
  // Both limits, as requests differ in size: 64 small ones, or about one of the maximal length. A
  // closing client is read on, since its close frame is yet to come.
  const Client& client = *Find(id);
  return client.is_closing || (client.waiting.size() < kMaxWaitingRequests &&
                               client.waiting_bytes < limits_.message_bytes);
}

void Clients::Refuse(Client* client, std::uint32_t seq, const std::string& error) {
  PostJson(client, {{"t", "reply"}, {"seq", seq}, {"ok", false}, {"error", error}});
  // Repeated mistakes are a fault of the client's program; refusing them forever costs the others.
  if (++client->mistakes >= kMaxMistakes) {
    CloseNow(client, CloseCode::kPolicyViolation, "too many invalid requests");
  }
}

RequestTable Clients::OwnRequests() {
  RequestTable table;
  table.requests["hello"] = {[this](const Request& request) { return Hello(request); }, true};
  table.requests["ping"] = {[](const Request&) { return Json::object(); }, true};
  table.requests["take_control"] = {[this](const Request& request) { return TakeControl(request); },
                                    true};
  table.requests["give_control"] = {
      [this](const Request& request) { return GiveControl(request); }};
  return table;
}

Json Clients::Hello(const Request& request) {
  // Compared as JSON, so that a missing version or one of another type is reported as found.
  const Json version = request.fields.value("version", Json());
  if (version != kProtocolVersion) {
    throw RequestError("found version " + ToText(version) + ", expected " +
                       std::to_string(kProtocolVersion));
  }
  Client* client = Find(request.client);
  // A repeated hello is answered, but the client joins once.
  if (!client->said_hello) {
    client->said_hello = true;
    arbiter_.Join(request.client);
    new_clients_.push_back(request.client);
    must_send_clients_ = true;
  }
  return {
      {"client", request.client}, {"controller", ControllerNumber()}, {"program", ProgramName()}};
}

Json Clients::TakeControl(const Request& request) {
  // A missing flag, or any value but `true`, only asks.
  const bool by_force = request.fields.value("by_force", Json(false)) == true;
  const std::optional<ClientId> before = arbiter_.controller();
  const bool is_granted = arbiter_.Take(request.client, by_force, Now());
  // Take() returns false only if there is a controller, so `before` has a value.
  // The controller is asked; it may answer with `give_control` or `keep_control`.
  if (!is_granted) {
    PostJson(Find(*before), {{"t", "control_wanted"}, {"by", request.client}});
  } else if (before != request.client) {
    must_send_clients_ = true;
  }
  return {{"granted", is_granted}};
}

Json Clients::GiveControl(const Request& request) {
  const Json to = request.fields.value("to", Json());
  if (!to.is_null() && !(to.is_number_unsigned() && to <= std::numeric_limits<ClientId>::max())) {
    throw RequestError("`to` is " + ToText(to) + ", expected the number of a client or null");
  }
  std::optional<ClientId> receiver;
  if (!to.is_null()) receiver = to.get<ClientId>();
  arbiter_.Give(request.client, receiver, Now());
  must_send_clients_ = true;
  return Json::object();
}

Json Clients::ControllerNumber() const {
  return arbiter_.controller() ? Json(*arbiter_.controller()) : Json();
}

void Clients::SendClientList() {
  // Each client receives its own number with the list, so the text differs per client.
  for (const ClientId id : arbiter_.clients()) {
    PostJson(Find(id), {{"t", "clients"},
                        {"controller", ControllerNumber()},
                        {"clients", arbiter_.clients()},
                        {"you", id}});
  }
}

void Clients::Post(Client* client, OutgoingMessage message) {
  if (client->is_closing) return;
  // The limit bounds the memory that a stalled client can occupy. Dropping single messages instead
  // would leave the page with a wrong state without notice, so the client is closed.
  // A single message is always accepted, whatever its length.
  if (!client->outbox.empty() &&
      client->outbox_bytes + message.body->size() > limits_.outbox_bytes) {
    client->outbox.clear();
    return CloseNow(client, CloseCode::kPolicyViolation,
                    "too slow: too much data is waiting for this client");
  }
  client->outbox_bytes += message.body->size();
  client->outbox.push_back(std::move(message));
}

void Clients::PostJson(Client* client, const Json& message) {
  Post(client, {.body = std::make_shared<const std::string>(ToText(message))});
}

void Clients::CloseNow(Client* client, CloseCode code, std::string_view reason) {
  if (client->is_closing) return;
  // From here on Post() ignores this client, so the close message is the last one in its outbox.
  client->is_closing = true;
  client->outbox.push_back({.kind = OutgoingMessage::Kind::kClose,
                            .body = std::make_shared<const std::string>(reason),
                            .code = code});
}

void Clients::CloseAll() {
  const Lock lock(mutex_);
  is_open_ = false;
  for (auto& [id, client] : clients_)
    CloseNow(&client, CloseCode::kGoingAway, "the studio is closing");
}

bool Clients::HasMessage(const Client& client) const {
  if (!client.outbox.empty()) return true;
  // State is sent only to clients that have received the scene to which it refers.
  return client.has_scene && !client.is_closing &&
         (client.known_poses < poses_.version() || client.acknowledged != client.to_acknowledge ||
          client.known_view < view_.number);
}

std::optional<web_server::OutgoingMessage> Clients::NextMessage(ClientId id) {
  const Lock lock(mutex_);
  Client* client = Find(id);
  if (!HasMessage(*client)) return std::nullopt;
  return TakeMessage(client);
}

Clients::OutgoingMessage Clients::TakeMessage(Client* client) {
  if (!client->outbox.empty()) {
    // Messages in order come first; poses and views are state, of which only the newest is sent.
    OutgoingMessage message = std::move(client->outbox.front());
    client->outbox.pop_front();
    client->outbox_bytes -= std::min(client->outbox_bytes, message.body->size());
    return message;
  }
  // Poses acknowledge requests, so they are also sent if nothing has moved.
  const bool are_poses_due =
      client->known_poses < poses_.version() || client->acknowledged != client->to_acknowledge;
  return are_poses_due ? PosesFor(client) : ViewFor(client);
}

Clients::OutgoingMessage Clients::PosesFor(Client* client) {
  // The difference is computed when the network is ready to send and not when poses arrive: a slow
  // client receives one message with all that has moved in the meantime.
  const PoseBroadcaster::Change change = poses_.Since(client->known_poses);
  client->known_poses = poses_.version();
  client->acknowledged = client->to_acknowledge;
  return {.kind = OutgoingMessage::Kind::kBinary,
          .head = BinaryHead(kPosesKind, change.is_key, change.count, poses_.scene(), poses_.tick(),
                             client->acknowledged),
          .body = change.bytes};
}

Clients::OutgoingMessage Clients::ViewFor(Client* client) {
  client->known_view = view_.number;
  return {.kind = OutgoingMessage::Kind::kBinary,
          .head = BinaryHead(kViewKind, view_.is_recorded, 0, view_.scene, view_.tick,
                             client->acknowledged),
          .body = view_.png};
}

void Clients::CloseSilentClients() {
  // Connections that never speak would occupy places of clients without bound in time.
  const std::chrono::duration<double> longest(limits_.hello_seconds);
  for (auto& [id, client] : clients_) {
    if (client.said_hello || Now() - client.since < longest) continue;
    CloseNow(&client, CloseCode::kPolicyViolation, "no hello arrived");
  }
}

std::vector<Request> Clients::TakeRequests() {
  const Lock lock(mutex_);
  CloseSilentClients();
  std::vector<Request> taken;
  for (auto& [id, client] : clients_) {
    // One request per watcher and frame: many watchers must not delay the controller.
    const bool takes_all = arbiter_.controller() == id;
    while (!client.waiting.empty()) {
      client.waiting_bytes -= client.waiting.front().bytes;
      taken.push_back(std::move(client.waiting.front().request));
      client.waiting.pop_front();
      if (!takes_all) break;
    }
  }
  return taken;
}

std::vector<ClientId> Clients::TakeNewClients() {
  const Lock lock(mutex_);
  // The caller sends the scene next, before any other message: updates may follow from now on.
  for (const ClientId id : new_clients_) Find(id)->has_scene = true;
  return std::exchange(new_clients_, {});
}

bool Clients::IsController(ClientId id) const {
  const Lock lock(mutex_);
  return arbiter_.controller() == id;
}

void Clients::Send(ClientId id, const Json& message) {
  const Lock lock(mutex_);
  Client* client = Find(id);
  if (client == nullptr) return;
  PostJson(client, message);
  if (message.value("t", "") == "reply") {
    // The maximum, since slow requests are answered after later ones.
    client->carried_out = std::max(client->carried_out, message.value("seq", 0U));
  }
}

void Clients::SendToAll(const Json& message) {
  const auto body = std::make_shared<const std::string>(ToText(message));
  const Lock lock(mutex_);
  for (auto& [id, client] : clients_) {
    if (client.has_scene) Post(&client, {.body = body});
  }
}

void Clients::SendPoses(const Poses& poses) {
  const Lock lock(mutex_);
  poses_.Update(poses);
  for (auto& [id, client] : clients_) {
    // These poses contain the effects of all requests carried out so far.
    client.to_acknowledge = client.carried_out;
  }
}

void Clients::SendView(std::uint32_t scene, std::uint32_t tick, std::string png, bool is_recorded) {
  auto shared = std::make_shared<const std::string>(std::move(png));
  const Lock lock(mutex_);
  view_ = {view_.number + 1, scene, tick, is_recorded, std::move(shared)};
}

}  // namespace smile::page
