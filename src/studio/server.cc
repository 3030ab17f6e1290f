#include "studio/server.h"

#include <atomic>
#include <chrono>
#include <list>
#include <system_error>
#include <thread>
#include <utility>

#include "studio/internal_clients.h"
#include "studio/internal_doorkeeper.h"
#include "studio/internal_frames.h"
#include "studio/internal_handshake.h"
#include "studio/internal_http.h"
#include "studio/internal_page.h"
#include "studio/internal_socket.h"

namespace smile::studio {
namespace {

constexpr int kFirstPort = 8470;
constexpr std::size_t kMaxHeadBytes = 16384;
constexpr std::chrono::seconds kHeadPatience{10};
/// Connections beside those of clients: a page's files, and who is about to become a client.
constexpr int kMaxPlainConnections = 64;
/// After the last word of ours, so that it arrives although the other end still talks.
constexpr Patience kLastWordPatience{500};
constexpr int kMaxLastReads = 1000;

constexpr std::string_view kHeadEnd = "\r\n\r\n";

/// What a page of ours may do: load from here, show pictures it has in memory, talk to us.
std::string ContentPolicy(const HttpRequest& request) {
  return "default-src 'self'; img-src 'self' blob: data:; connect-src 'self' blob: ws://" +
         std::string(request.Header("host")) +
         "; worker-src 'self' blob:; style-src 'self' 'unsafe-inline'; object-src 'none'; "
         "base-uri 'none'; form-action 'none'; frame-ancestors 'none'";
}

void AddSafetyHeaders(const HttpRequest& request, bool is_loopback, HttpReply* reply) {
  const std::pair<std::string, std::string> headers[] = {
      {"Content-Security-Policy", ContentPolicy(request)},
      {"X-Content-Type-Options", "nosniff"},
      {"Referrer-Policy", "no-referrer"},
      {"Cross-Origin-Resource-Policy", "same-origin"},
      {"Connection", "close"}};
  reply->headers.insert(reply->headers.end(), std::begin(headers), std::end(headers));
  // From elsewhere than this machine browsers ignore it without TLS, and complain.
  if (is_loopback) reply->headers.emplace_back("Cross-Origin-Opener-Policy", "same-origin");
}

HttpReply FileReply(const Page::File& file, const HttpRequest& request) {
  HttpReply reply;
  // Asked for again each time, and told that nothing changed: a new build shows at once.
  reply.headers = {{"Content-Type", file.type}, {"ETag", file.tag}, {"Cache-Control", "no-cache"}};
  if (request.Header("if-none-match") == file.tag) {
    reply.status = 304;
  } else if (!file.gzipped.empty() &&
             request.Header("accept-encoding").find("gzip") != std::string_view::npos) {
    reply.headers.emplace_back("Content-Encoding", "gzip");
    reply.body = file.gzipped;
  } else {
    reply.body = file.bytes;
  }
  return reply;
}

HttpReply AnswerReply(HttpAnswer answer) {
  HttpReply reply;
  reply.headers = {{"Content-Type", answer.type}, {"Cache-Control", "no-cache"}};
  if (!answer.file_name.empty()) {
    reply.headers.emplace_back("Content-Disposition",
                               "attachment; filename*=UTF-8''" + PercentEncoded(answer.file_name));
  }
  reply.body = std::move(answer.body);
  return reply;
}

bool IsUpgrade(const HttpRequest& request) {
  return LowerCase(request.Header("upgrade")) == "websocket" &&
         LowerCase(request.Header("connection")).find("upgrade") != std::string::npos &&
         request.Header("sec-websocket-version") == "13" &&
         !request.Header("sec-websocket-key").empty();
}

HttpReply UpgradeReply(const HttpRequest& request) {
  return {101,
          {{"Upgrade", "websocket"},
           {"Connection", "Upgrade"},
           {"Sec-WebSocket-Accept", AcceptKeyOf(request.Header("sec-websocket-key"))}},
          ""};
}

}  // namespace

class Server::Impl {
 public:
  explicit Impl(ServerOptions options)
      : options_(std::move(options)),
        page_(options_.page),
        listening_(ListenAt(options_.address, options_.port, kFirstPort)),
        doorkeeper_(options_.address, listening_.port, listening_.is_loopback),
        stall_(static_cast<int>(1000 * options_.limits.stall_seconds)),
        clients_(options_.limits),
        doorman_([this] { LetIn(); }) {}

  ~Impl() {
    clients_.CloseAll();
    listening_.Stop();
    doorman_.join();
    // Those that listen have heard the last word by now; the others are not waited for.
    const auto deadline = std::chrono::steady_clock::now() + kLastWordPatience;
    while (!IsEverybodyGone() && std::chrono::steady_clock::now() < deadline) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    for (const Connection& connection : connections_) connection.socket.Stop();
    for (Connection& connection : connections_) connection.thread.join();
  }

  std::string link() const { return doorkeeper_.link(); }
  Clients* clients() { return &clients_; }

 private:
  struct Connection {
    Socket socket;
    std::thread thread;
    std::atomic<bool> is_over = false;
  };

  struct LeavesAtEnd {
    Clients* clients;
    ClientId client;
    ~LeavesAtEnd() { clients->Leave(client); }
  };

  bool IsEverybodyGone() const {
    for (const Connection& connection : connections_) {
      if (!connection.is_over) return false;
    }
    return true;
  }

  /// Gives everybody who comes a thread of their own. Only this thread touches the list.
  void LetIn() {
    while (true) {
      Socket socket = listening_.Accept(stall_);
      if (!socket.is_open()) return;
      connections_.remove_if([](Connection& connection) {
        const bool is_over = connection.is_over;
        if (is_over) connection.thread.join();
        return is_over;
      });
      const int most = options_.limits.clients + kMaxPlainConnections;
      if (connections_.size() >= static_cast<std::size_t>(most)) continue;  // and it is closed
      Connection& connection = connections_.emplace_back();
      connection.socket = std::move(socket);
      try {
        connection.thread = std::thread([this, &connection] {
          Serve(connection.socket);
          connection.socket.Stop();
          connection.is_over = true;
        });
      } catch (const std::system_error&) {
        connections_.pop_back();  // no more threads: whoever came is sent away
      }
    }
  }

  void Serve(const Socket& socket) {
    std::string bytes;
    HttpRequest request;
    HttpReply reply;
    try {
      request = ReadRequest(socket, &bytes);
      doorkeeper_.Check(request);
      if (request.path == "/ws") return ServeClient(socket, request, bytes);
      reply = ReplyTo(request);
    } catch (const HttpError& error) {
      reply = TextReply(error.status(), error.what());
    } catch (const std::exception& error) {
      reply = TextReply(500, error.what());
    }
    SendReply(socket, request, std::move(reply));
  }

  /// `bytes` keeps what comes after its head.
  static HttpRequest ReadRequest(const Socket& socket, std::string* bytes) {
    const auto deadline = std::chrono::steady_clock::now() + kHeadPatience;
    std::size_t end = std::string::npos;
    while ((end = bytes->find(kHeadEnd)) == std::string::npos) {
      if (bytes->size() > kMaxHeadBytes) throw HttpError(431, "the request is too long");
      const auto left = std::chrono::ceil<Patience>(deadline - std::chrono::steady_clock::now());
      if (left.count() <= 0 || socket.Read(bytes, left) == Socket::Reading::kEnd) {
        throw HttpError(408, "the request does not end");
      }
    }
    const HttpRequest request = ParseHttpHead(std::string_view(*bytes).substr(0, end));
    bytes->erase(0, end + kHeadEnd.size());
    return request;
  }

  HttpReply ReplyTo(const HttpRequest& request) const {
    if (request.method != "GET" && request.method != "HEAD") {
      HttpReply reply = TextReply(405, "only GET and HEAD are understood");
      reply.headers.emplace_back("Allow", "GET, HEAD");
      return reply;
    }
    const std::string cookie = doorkeeper_.CookieFor(request);
    if (!cookie.empty() && request.path == "/") {
      // Once the browser remembers the token, it need not be seen in its address line.
      return {303, {{"Location", "/"}, {"Set-Cookie", cookie}}, ""};
    }
    if (const Page::File* file = page_.Find(request.path)) return FileReply(*file, request);
    std::optional<HttpAnswer> answer;
    if (options_.get) answer = options_.get(request.path);
    if (!answer) throw HttpError(404, "there is no such page");
    return AnswerReply(std::move(*answer));
  }

  void SendReply(const Socket& socket, const HttpRequest& request, HttpReply reply) const {
    AddSafetyHeaders(request, listening_.is_loopback, &reply);
    if (reply.status != 304) {
      reply.headers.emplace_back("Content-Length", std::to_string(reply.body.size()));
    }
    const bool wants_body = request.method != "HEAD";
    socket.Write(reply.Head(), wants_body ? reply.body : std::string_view(), stall_);
    socket.FinishWriting();
    ReadOut(socket);
  }

  /// Were a connection closed with something unread, the other end could lose what we wrote.
  static void ReadOut(const Socket& socket) {
    std::string rest;
    for (int k = 0; k < kMaxLastReads; ++k) {
      rest.clear();
      if (socket.Read(&rest, kLastWordPatience) != Socket::Reading::kBytes) return;
    }
  }

  void ServeClient(const Socket& socket, const HttpRequest& request, std::string_view bytes) {
    if (!IsUpgrade(request) || request.method != "GET") {
      throw HttpError(426, "this is the address of a WebSocket");
    }
    const std::optional<ClientId> client = clients_.Enter();
    if (!client) throw HttpError(503, "the studio has as many clients as it can");
    try {
      if (socket.Write(UpgradeReply(request).Head(), "", stall_)) Talk(socket, *client, bytes);
    } catch (const std::exception&) {
      // The machine has no more memory or threads: this client goes, the others stay.
    }
    clients_.Forget(*client);
  }

  void Talk(const Socket& socket, ClientId client, std::string_view first_bytes) {
    // Joined at the end of this, whatever happens: but it ends only when the client has left.
    const std::jthread sender([this, &socket, client] { SendMail(socket, client); });
    const LeavesAtEnd leaving{&clients_, client};
    Listen(socket, client, first_bytes);
  }

  /// Until the client or we have closed the connection.
  void Listen(const Socket& socket, ClientId client, std::string_view first_bytes) {
    MessageReader reader(options_.limits.message_bytes);
    std::string bytes(first_bytes);
    int last_reads = 0;
    while (true) {
      if (!clients_.IsClosing(client)) TakeMessages(client, bytes, &reader);
      bytes.clear();
      const Socket::Reading reading = socket.Read(&bytes, kLastWordPatience);
      if (reading == Socket::Reading::kEnd) return;
      if (!clients_.IsClosing(client)) continue;
      if (reading == Socket::Reading::kNothing || ++last_reads > kMaxLastReads) return;
    }
  }

  void TakeMessages(ClientId client, std::string_view bytes, MessageReader* reader) {
    try {
      reader->Feed(bytes);
      std::uint64_t counted = reader->num_frames();
      while (const std::optional<MessageReader::Message> message = reader->Next()) {
        if (!clients_.CountFrames(client, reader->num_frames() - counted)) return;
        counted = reader->num_frames();
        TakeMessage(client, *message);
      }
      clients_.CountFrames(client, reader->num_frames() - counted);
    } catch (const FrameError& error) {
      clients_.Close(client, error.code(), error.what());
    }
  }

  void TakeMessage(ClientId client, const MessageReader::Message& message) {
    switch (message.opcode) {
      case Opcode::kText:
        return clients_.Receive(client, message.payload);
      case Opcode::kPing:
        return clients_.SendControl(client, Opcode::kPong, message.payload);
      case Opcode::kClose:
        return clients_.Close(client, CloseCode::kNormal, "");
      case Opcode::kBinary:
        throw FrameError(CloseCode::kUnsupported, "requests are text");
      default:
        return;
    }
  }

  void SendMail(const Socket& socket, ClientId client) {
    while (const std::optional<Clients::Mail> mail = clients_.NextMail(client)) {
      const std::string head = FrameHead(mail->opcode, mail->head.size() + mail->body->size());
      if (!socket.Write(head + mail->head, *mail->body, stall_)) return socket.Stop();
    }
    socket.FinishWriting();
  }

  ServerOptions options_;
  Page page_;
  Listening listening_;
  Doorkeeper doorkeeper_;
  Patience stall_;
  Clients clients_;
  std::list<Connection> connections_;
  std::thread doorman_;
};

Server::Server(ServerOptions options) : impl_(std::make_unique<Impl>(std::move(options))) {}
Server::~Server() = default;

std::string Server::link() const { return impl_->link(); }
std::vector<Request> Server::TakeRequests() { return impl_->clients()->TakeRequests(); }
std::vector<ClientId> Server::TakeNewClients() { return impl_->clients()->TakeNewClients(); }
bool Server::IsController(ClientId client) const { return impl_->clients()->IsController(client); }
void Server::Send(ClientId client, const Json& message) { impl_->clients()->Send(client, message); }
void Server::SendToAll(const Json& message) { impl_->clients()->SendToAll(message); }
void Server::SendPoses(const Poses& poses) { impl_->clients()->SendPoses(poses); }
void Server::SendView(std::uint32_t scene, std::uint32_t tick, std::string png, bool is_recorded) {
  impl_->clients()->SendView(scene, tick, std::move(png), is_recorded);
}

}  // namespace smile::studio
