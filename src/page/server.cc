#include "page/server.h"

#include <stdexcept>
#include <utility>

#include "page/internal_clients.h"

// The page's server: Clients keeps the queues, WebServer does the network. Every function that adds
// a message also resumes the web server, which otherwise sleeps until a client sends something.

namespace smile::page {
namespace {

/// Returns the options of the web server below.
/// @throws std::runtime_error if the page is missing.
web_server::WebServerOptions WebOptions(ServerOptions options) {
  if (!std::filesystem::is_regular_file(options.page / "index.html")) {
    // Checked here and not by the web server, whose message could not say how the page is built.
    throw std::runtime_error(options.page.string() +
                             ": the studio's page is not built; run ./run studio to build it");
  }
  return {.address = options.address,
          .port = options.port,
          .cookie = "smile_studio",
          .files = options.page,
          .get = std::move(options.get),
          .public_prefix = std::move(options.public_prefix),
          .may_be_framed = options.may_be_framed,
          .tls = options.tls,
          .limits = {.message_bytes = options.limits.message_bytes,
                     .messages_per_second = options.limits.requests_per_second,
                     .connections = options.limits.connections,
                     .stall_seconds = options.limits.stall_seconds}};
}

}  // namespace

class Server::Impl {
 public:
  explicit Impl(ServerOptions options)
      : clients_(options.limits), web_(WebOptions(std::move(options)), &clients_) {}
  // Clients learn the reason; the web server sends it before its threads end.
  ~Impl() { clients_.CloseAll(); }

  Clients* clients() { return &clients_; }
  web_server::WebServer* web() { return &web_; }

 private:
  Clients clients_;
  // Destroyed first, as its threads call `clients_`.
  web_server::WebServer web_;
};

Server::Server(ServerOptions options) : impl_(std::make_unique<Impl>(std::move(options))) {}
Server::~Server() = default;

std::string Server::link() const { return impl_->web()->link(); }
std::string Server::origin() const { return impl_->web()->origin(); }
bool Server::is_loopback() const { return impl_->web()->is_loopback(); }

std::vector<Request> Server::TakeRequests() {
  std::vector<Request> requests = impl_->clients()->TakeRequests();
  // Clients whose reading was paused may send again.
  impl_->web()->Resume();
  return requests;
}

std::vector<ClientId> Server::TakeNewClients() { return impl_->clients()->TakeNewClients(); }
bool Server::IsController(ClientId client) const { return impl_->clients()->IsController(client); }

// The web server sends queued messages only when it is resumed.
void Server::Send(ClientId client, const Json& message) {
  impl_->clients()->Send(client, message);
  impl_->web()->Resume();
}

void Server::SendToAll(const Json& message) {
  impl_->clients()->SendToAll(message);
  impl_->web()->Resume();
}

void Server::SendPoses(const Poses& poses) {
  impl_->clients()->SendPoses(poses);
  impl_->web()->Resume();
}

void Server::SendView(std::uint32_t scene, std::uint32_t tick, std::string png, bool is_recorded) {
  impl_->clients()->SendView(scene, tick, std::move(png), is_recorded);
  impl_->web()->Resume();
}

}  // namespace smile::page
