#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <string>
#include <vector>

namespace smile::web_server {

/// Acceptors at one port of one or several addresses.
struct Listening {
  std::vector<boost::asio::ip::tcp::acceptor> acceptors;
  int port = 0;
  bool is_loopback = false;  ///< only programs of this machine can connect
};

/// @param address  a number like `127.0.0.1` or `::1`, or a name of this machine: then at all
///                 addresses that it resolves to and this machine has. `localhost` is both of these
///                 numbers.
/// @param port     0 for the first of `first_port` and the hundred after it that is free at all.
/// @throws std::runtime_error naming address, port and reason.
Listening ListenAt(boost::asio::io_context* context, const std::string& address, int port,
                   int first_port);

}  // namespace smile::web_server
