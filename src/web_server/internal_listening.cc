#include "web_server/internal_listening.h"

#include <algorithm>
#include <boost/system/system_error.hpp>
#include <stdexcept>
#include <utility>

namespace smile::web_server {
namespace {

using boost::asio::io_context;
using boost::asio::ip::tcp;
using boost::system::error_code;
namespace errc = boost::system::errc;

// Length of the kernel's queue of connections that are not accepted yet.
constexpr int kMaxWaiting = 64;
// Several studios may run on one machine, but a hundred taken ports are a fault.
constexpr int kNumPortsTried = 100;

void AddEndpointsOf(io_context* context, const std::string& name,
                    std::vector<tcp::endpoint>* endpoints) {
  error_code error;
  const auto found = tcp::resolver(*context).resolve(name, "", tcp::resolver::passive, error);
  if (error) throw std::runtime_error("cannot listen at " + name + ": " + error.message());
  for (const auto& entry : found) {
    // A name may resolve to the same address several times.
    if (std::ranges::find(*endpoints, entry.endpoint()) == endpoints->end()) {
      endpoints->push_back(entry.endpoint());
    }
  }
}

/// Returns the addresses of a name. Browsers take `localhost` for both 127.0.0.1 and ::1, whatever
/// the machine's tables say.
std::vector<tcp::endpoint> EndpointsOf(io_context* context, const std::string& name) {
  std::vector<tcp::endpoint> endpoints;
  const bool is_localhost = name == "localhost";
  AddEndpointsOf(context, is_localhost ? "127.0.0.1" : name, &endpoints);
  if (is_localhost) AddEndpointsOf(context, "::1", &endpoints);
  return endpoints;
}

struct Attempt {
  std::vector<tcp::acceptor> acceptors;  ///< none if it failed
  error_code error;                      ///< the reason of a failure, also a partial one
};

/// Opens an acceptor, or returns the reason.
error_code Open(tcp::acceptor* acceptor, const tcp::endpoint& endpoint) {
  error_code error;
  acceptor->open(endpoint.protocol(), error);
  // A restarted server gets its port although connections of the former one are still closing. On
  // Linux this does not allow two servers at one port.
  if (!error) acceptor->set_option(tcp::acceptor::reuse_address(true), error);
  if (!error) acceptor->bind(endpoint, error);
  if (!error) acceptor->listen(kMaxWaiting, error);
  return error;
}

/// Listens at all addresses that this machine has; at none if the port is taken at one of them,
/// since another program would then answer part of the requests.
Attempt TryToListen(io_context* context, std::vector<tcp::endpoint> endpoints, int port) {
  Attempt attempt;
  for (tcp::endpoint& endpoint : endpoints) {
    endpoint.port(static_cast<unsigned short>(port));
    tcp::acceptor acceptor(*context);
    const error_code error = Open(&acceptor, endpoint);
    if (!error) {
      attempt.acceptors.push_back(std::move(acceptor));
      continue;
    }
    attempt.error = error;
    // For example a name with an IPv6 address on a machine without IPv6.
    const bool is_elsewhere =
        error == errc::address_not_available || error == errc::address_family_not_supported;
    if (!is_elsewhere) return {.acceptors = {}, .error = error};
  }
  return attempt;
}

}  // namespace

Listening ListenAt(io_context* context, const std::string& address, int port, int first_port) {
  const std::vector<tcp::endpoint> endpoints = EndpointsOf(context, address);
  // A given port must be free; otherwise the first free one of a range is used.
  const int begin = port == 0 ? first_port : port;
  const int end = port == 0 ? first_port + kNumPortsTried : port + 1;
  error_code error;
  for (int tried = begin; tried < end; ++tried) {
    Attempt attempt = TryToListen(context, endpoints, tried);
    if (!attempt.acceptors.empty()) {
      // Over all addresses, also those where listening failed: rather a token too many than too
      // few.
      const bool is_loopback = std::ranges::all_of(
          endpoints, [](const tcp::endpoint& each) { return each.address().is_loopback(); });
      return {std::move(attempt.acceptors), tried, is_loopback};
    }
    error = attempt.error;
    // Another port would not help.
    if (error != errc::address_in_use) break;
  }
  throw std::runtime_error("cannot listen at " + address + ", port " + std::to_string(begin) +
                           (port == 0 ? " and the following ports" : "") + ": " + error.message());
}

}  // namespace smile::web_server
