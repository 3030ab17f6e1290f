#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <memory>

#include "web_server/internal_stream.h"
#include "web_server/web_server_options.h"

namespace boost::asio::ssl {
class context;
}

namespace smile::web_server {

/// Reads certificate and key.
/// @throws std::runtime_error naming the file and what is wrong with it.
std::shared_ptr<net::ssl::context> LoadTls(const TlsFiles& files);

/// A connection that was accepted, with TLS if there is a context for it.
std::unique_ptr<Link> MakeTcpLink(net::ip::tcp::socket socket, net::ssl::context* tls);

}  // namespace smile::web_server
