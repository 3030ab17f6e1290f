#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <memory>

#include "web_server/internal_stream.h"
#include "web_server/web_server_options.h"

namespace boost::asio::ssl {
class context;
}

namespace smile::web_server {

/// Reads certificate and key into a TLS context.
/// @throws std::runtime_error with the file and the fault.
std::shared_ptr<net::ssl::context> LoadTls(const TlsFiles& files);

/// Returns a link for an accepted connection, with TLS if a context is given.
std::unique_ptr<Link> MakeTcpLink(net::ip::tcp::socket socket, net::ssl::context* tls);

}  // namespace smile::web_server
