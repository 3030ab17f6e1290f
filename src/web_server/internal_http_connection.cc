#include "web_server/internal_http_connection.h"

#include <boost/beast/http/read.hpp>
#include <boost/beast/http/write.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <cmath>
#include <exception>
#include <utility>

#include "web_server/internal_relay.h"
#include "web_server/internal_web_socket.h"

// An HTTP connection is a chain of asynchronous steps in the server's thread: ReadRequest,
// HandleHead, Answer, Send, HandleSent, and again. Exactly one step is pending at a time, and its
// completion holds the shared pointer that keeps the connection alive. Only the program's handler
// runs elsewhere, in a worker thread.

namespace smile::web_server {
namespace {

namespace http = boost::beast::http;

std::chrono::milliseconds Milliseconds(double seconds) {
  return std::chrono::milliseconds(std::lround(1000 * seconds));
}

/// Returns where the page's WebSocket is.
std::string WebSocketOrigin(const HttpRequest& request, const WebServerOptions& options) {
  if (!options.public_origin.empty()) return "ws" + options.public_origin.substr(4);
  return (options.tls ? "wss://" : "ws://") + std::string(request.Header("host"));
}

/// Returns a Content-Security-Policy: pages load from this server only, may show pictures from
/// memory, and connect to this server.
std::string ContentPolicy(const HttpRequest& request, const WebServerOptions& options) {
  // Scripts from anywhere else do not run, even if text from a file should reach the page as
  // markup. Older browsers do not count `ws:` as 'self', so it is listed.
  return "default-src 'self'; img-src 'self' blob: data:; connect-src 'self' blob: " +
         WebSocketOrigin(request, options) +
         "; worker-src 'self' blob:; style-src 'self' 'unsafe-inline'; object-src 'none'; "
         "base-uri 'none'; form-action 'none'" +
         (options.may_be_framed ? "" : "; frame-ancestors 'none'");
}

void AddSafetyHeaders(const HttpRequest& request, const Services& services, HttpReply* reply) {
  const bool is_tls = services.options->tls.has_value();
  const std::pair<std::string, std::string> headers[] = {
      {"Content-Security-Policy", ContentPolicy(request, *services.options)},
      {"X-Content-Type-Options", "nosniff"},
      {"Referrer-Policy", "no-referrer"},
      {"Cross-Origin-Resource-Policy", "same-origin"}};
  reply->headers.insert(reply->headers.end(), std::begin(headers), std::end(headers));
  // Without TLS, browsers ignore this header for other machines and print a warning.
  if (services.is_loopback || is_tls) {
    reply->headers.emplace_back("Cross-Origin-Opener-Policy", "same-origin");
  }
}

HttpReply FileReply(const StaticFiles::File& file, const HttpRequest& request) {
  HttpReply reply;
  // Browsers revalidate each time and get 304 if nothing has changed: a new build is visible
  // immediately.
  reply.headers = {{"Content-Type", file.type}, {"ETag", file.tag}, {"Cache-Control", "no-cache"}};
  // The body depends on what the browser can decompress, which caches on the way must know.
  if (file.gzipped) reply.headers.emplace_back("Vary", "Accept-Encoding");
  if (request.Header("if-none-match") == file.tag) {
    reply.status = 304;
  } else if (file.gzipped &&
             request.Header("accept-encoding").find("gzip") != std::string_view::npos) {
    reply.headers.emplace_back("Content-Encoding", "gzip");
    reply.body = file.gzipped;
  } else {
    reply.body = file.bytes;
  }
  return reply;
}

HttpReply ContentReply(HttpResponse response) {
  HttpReply reply;
  reply.headers = {{"Content-Type", response.type}, {"Cache-Control", "no-cache"}};
  if (!response.file_name.empty()) {
    reply.headers.emplace_back("Content-Disposition", "attachment; filename*=UTF-8''" +
                                                          PercentEncoded(response.file_name));
  }
  if (response.gzipped != nullptr) {
    reply.headers.emplace_back("Content-Encoding", "gzip");
    reply.body = std::move(response.gzipped);
  } else {
    reply.body = std::make_shared<const std::string>(std::move(response.body));
  }
  return reply;
}

HttpReply ErrorReply(const std::exception& error) {
  // Any other exception is a fault of this program: 500.
  const auto* refusal = dynamic_cast<const HttpError*>(&error);
  return TextReply(refusal == nullptr ? 500 : refusal->status(), error.what());
}

HttpReply HandlerReply(const HttpHandler& get, const std::string& path) {
  try {
    std::optional<HttpResponse> response;
    if (get) response = get(path);
    if (!response) throw HttpError(404, "there is no such page");
    return ContentReply(std::move(*response));
  } catch (const std::exception& error) {
    return ErrorReply(error);
  }
}

}  // namespace

HttpConnection::HttpConnection(std::unique_ptr<Link> link, Services* services)
    : services_(services),
      stream_(services->context, std::move(link),
              Milliseconds(services->options->limits.stall_seconds)),
      deadline_(services->context) {}

void HttpConnection::Start() {
  BeginIdle();
  const double timeout_seconds = services_->options->limits.head_seconds;
  // One deadline for the handshake; ReadRequest() sets a new one for the head.
  deadline_.Set(Milliseconds(timeout_seconds), [self = shared_from_this()] { self->Abort(); });
  stream_.link().Open([self = shared_from_this(), timeout_seconds](error_code error) {
    if (error) return self->End();
    self->ReadRequest(timeout_seconds);
  });
}

void HttpConnection::Abort() { stream_.link().Close(); }

void HttpConnection::ReadRequest(double timeout_seconds) {
  BeginIdle();
  parser_.emplace();
  parser_->header_limit(kMaxHeadBytes);
  deadline_.Set(Milliseconds(timeout_seconds), [self = shared_from_this()] {
    self->has_timed_out_ = true;
    self->stream_.link().CancelRead();
  });
  http::async_read_header(stream_, buffer_, *parser_,
                          [self = shared_from_this()](error_code error, std::size_t) {
                            self->EndOnFailure([&] { self->HandleHead(error); });
                          });
}

void HttpConnection::HandleHead(error_code error) {
  deadline_.Clear();
  EndIdle();
  if (!error) return Answer();
  // The reply to a faulty head must not depend on the request before it.
  request_ = {};
  stays_open_ = false;
  // A connection that was kept alive without a further request ends without a reply.
  if (has_timed_out_ && parser_->got_some()) {
    return Send(TextReply(408, "the request is incomplete"));
  }
  const bool is_end = error == http::error::end_of_stream || error == http::error::partial_message;
  // Beast does not export the category of its parser's errors; any of its errors has it.
  const auto& parser_category = http::make_error_code(http::error::bad_version).category();
  // Only faults of the request get a reply; a broken connection just ends.
  if (is_end || error.category() != parser_category) return End();
  Send(ErrorReply(ToHttpError(error)));
}

void HttpConnection::Answer() {
  // Bodies are not read, so the begin of a following request would be unknown: the connection
  // closes after the reply.
  const bool has_body = parser_->chunked() || parser_->content_length().value_or(0) > 0;
  stays_open_ = parser_->keep_alive() && !has_body;
  try {
    request_ = {};
    request_ = ToHttpRequest(parser_->get());
    services_->access->Check(request_);
    // The order matters: access is checked before anything reveals whether a path exists.
    if (request_.path == services_->options->web_socket_path) return Upgrade();
    const RelayFinder& relay = services_->options->relay;
    if (const auto target = relay ? relay(request_.path) : std::nullopt) return PassOn(*target);
    if (request_.method != "GET" && request_.method != "HEAD") {
      HttpReply reply = TextReply(405, "only GET and HEAD are supported");
      reply.headers.emplace_back("Allow", "GET, HEAD");
      return Send(std::move(reply));
    }
    const std::string cookie = services_->access->CookieFor(request_);
    if (!cookie.empty() && request_.path == "/") {
      // A redirect removes the token from the address line, once the browser has stored it as a
      // cookie.
      return Send({.status = 303, .headers = {{"Location", "/"}, {"Set-Cookie", cookie}}});
    }
    // Files come from memory and are sent in this thread; everything else may take long.
    const StaticFiles::File* file = services_->files->Find(request_.path);
    if (file != nullptr) return Send(FileReply(*file, request_));
    CallHandler();
  } catch (const std::exception& error) {
    Send(ErrorReply(error));
  }
}

void HttpConnection::CallHandler() {
  // The handler may be slow; it runs in a worker thread, and its reply returns to the server's
  // thread.
  net::post(*services_->workers, [self = shared_from_this()] {
    Services* services = self->services_;
    HttpReply reply = HandlerReply(services->options->get, self->request_.path);
    net::post(*services->context, [self, reply = std::move(reply)]() mutable {
      self->EndOnFailure([&] { self->Send(std::move(reply)); });
    });
  });
}

void HttpConnection::Upgrade() {
  if (!boost::beast::websocket::is_upgrade(parser_->get())) {
    throw HttpError(426, "this is the address of a WebSocket");
  }
  const WebSocketId id = services_->last_id + 1;
  if (!services_->handler->Open(id)) throw HttpError(503, "too many clients are connected");
  // Numbers are used only for sockets that the handler has opened, so they have no gaps.
  services_->last_id = id;
  // Bytes after the head belong to the WebSocket already.
  stream_.PutBack({static_cast<const char*>(buffer_.data().data()), buffer_.size()});
  const auto web_socket = std::make_shared<WebSocket>(std::move(stream_), id, services_);
  // The WebSocket takes this connection's place; this object ends with the current completion.
  services_->connections->Add(web_socket);
  services_->connections->Remove(this);
  web_socket->Start(parser_->get());
}

void HttpConnection::PassOn(const RelayTarget& target) {
  const bool has_body = parser_->chunked() || parser_->content_length().value_or(0) > 0;
  if ((request_.method != "GET" && request_.method != "HEAD") || has_body) {
    throw HttpError(405, "only GET and HEAD without a body are passed on");
  }
  // Bytes after the head belong to the WebSocket already.
  stream_.PutBack({static_cast<const char*>(buffer_.data().data()), buffer_.size()});
  const auto relay = std::make_shared<Relay>(std::move(stream_), RelayedHead(request_, target),
                                             target.port, services_);
  // It takes this connection's place, as a WebSocket does.
  services_->connections->Add(relay);
  services_->connections->Remove(this);
  relay->Start();
}

void HttpConnection::Send(HttpReply reply) {
  // After a malformed request, the begin of the next one is unknown.
  if (reply.status == 400) stays_open_ = false;
  AddSafetyHeaders(request_, *services_, &reply);
  // Reply and response are members, since the write refers to them until it completes.
  reply_ = std::move(reply);
  response_ = Response(http::int_to_status(static_cast<unsigned>(reply_.status)), 11);
  for (const auto& [name, value] : reply_.headers) response_.set(name, value);
  // A reply 304 has no body, and a length of 0 would describe the file wrongly (RFC 9110, 8.6).
  if (reply_.status != 304) response_.content_length(reply_.body->size());
  response_.keep_alive(stays_open_);
  // The reply to HEAD has the length of the body, but no body.
  if (request_.method != "HEAD") {
    response_.body() = boost::beast::span<const char>(reply_.body->data(), reply_.body->size());
  }
  http::async_write(stream_, response_, [self = shared_from_this()](error_code error, std::size_t) {
    self->HandleSent(error);
  });
}

void HttpConnection::HandleSent(error_code error) {
  if (error) return End();
  if (!stays_open_) return Linger();
  ReadRequest(services_->options->limits.keep_alive_seconds);
}

void HttpConnection::Linger() {
  BeginIdle();
  deadline_.Set(kLastWordTimeout, [self = shared_from_this()] { self->Abort(); });
  stream_.link().Finish([self = shared_from_this()] { self->End(); });
}

void HttpConnection::End() {
  deadline_.Clear();
  Abort();
  services_->connections->Remove(this);
}

}  // namespace smile::web_server
