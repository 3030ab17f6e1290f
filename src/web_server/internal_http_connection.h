#pragma once

#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/span_body.hpp>
#include <memory>
#include <optional>

#include "web_server/internal_connection.h"
#include "web_server/internal_http.h"
#include "web_server/internal_stream.h"

namespace smile::web_server {

/// HTTP connection: serves requests one after another, until one upgrades to a WebSocket.
class HttpConnection : public ClientConnection,
                       public std::enable_shared_from_this<HttpConnection> {
 public:
  HttpConnection(std::unique_ptr<Link> link, Services* services);

  void Start();
  void Abort() override;

 private:
  using Parser = boost::beast::http::request_parser<boost::beast::http::empty_body>;
  using Response = boost::beast::http::response<boost::beast::http::span_body<const char>>;

  void ReadRequest(double timeout_seconds);
  void HandleHead(error_code error);
  void Answer();
  HttpReply ReplyTo(const HttpRequest& request);
  /// Calls the program's handler in a worker thread.
  void CallHandler();
  void Upgrade();
  void PassOn(const RelayTarget& target);
  void Send(HttpReply reply);
  void HandleSent(error_code error);
  /// Waits for the other end to close the connection.
  void Linger();
  void End() override;

  Services* services_;
  Stream stream_;
  Deadline deadline_;
  boost::beast::flat_buffer buffer_{kMaxHeadBytes + 1};
  std::optional<Parser> parser_;
  HttpRequest request_;
  HttpReply reply_;
  Response response_;
  bool stays_open_ = false, has_timed_out_ = false;
};

}  // namespace smile::web_server
