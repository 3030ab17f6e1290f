#include "web_server/internal_tcp_link.h"

#include <boost/asio/ssl/context.hpp>
#include <boost/asio/ssl/stream.hpp>
#include <stdexcept>
#include <utility>

namespace smile::web_server {
namespace {

using net::ip::tcp;

/// Ends a TCP connection: reads and drops what the other end still sends, since closing with unread
/// bytes sends a reset, which could destroy the reply on its way.
class Drain : public std::enable_shared_from_this<Drain> {
 public:
  Drain(tcp::socket* socket, std::function<void()> completion)
      : socket_(socket), completion_(std::move(completion)) {}

  void Start() {
    // The other end may have closed already.
    error_code ignored;
    socket_->shutdown(tcp::socket::shutdown_send, ignored);
    Read();
  }

 private:
  // As much as a client may have on its way: a message of the maximal size and full buffers.
  static constexpr std::size_t kMaxDropped = 4 << 20;

  void Read() {
    socket_->async_read_some(net::buffer(dropped_),
                             [self = shared_from_this()](error_code error, std::size_t count) {
                               self->num_dropped_ += count;
                               // Bounded, as the other end may never stop.
                               const bool is_flood = self->num_dropped_ > kMaxDropped;
                               if (error || is_flood) return self->completion_();
                               self->Read();
                             });
  }

  tcp::socket* socket_;
  std::function<void()> completion_;
  std::array<char, 16384> dropped_{};
  std::size_t num_dropped_ = 0;
};

/// Unencrypted connection.
class TcpLink : public Link {
 public:
  explicit TcpLink(tcp::socket socket) : socket_(std::move(socket)) {}

  void Open(std::function<void(error_code)> completion) override {
    // Posted, since a completion may not be called from within the function that starts it.
    net::post(socket_.get_executor(),
              [completion = std::move(completion)] { completion(error_code()); });
  }
  void Read(net::mutable_buffer buffer, Completion completion) override {
    socket_.async_read_some(buffer, std::move(completion));
  }
  void Write(const Buffers& buffers, Completion completion) override {
    socket_.async_write_some(buffers, std::move(completion));
  }
  void Finish(std::function<void()> completion) override {
    std::make_shared<Drain>(&socket_, std::move(completion))->Start();
  }
  void CancelRead() override {
    error_code ignored;
    socket_.cancel(ignored);
  }
  void Close() override {
    error_code ignored;
    socket_.close(ignored);
  }

 private:
  tcp::socket socket_;
};

/// Encrypted connection.
class TlsLink : public Link {
 public:
  TlsLink(tcp::socket socket, net::ssl::context* tls) : stream_(std::move(socket), *tls) {}

  void Open(std::function<void(error_code)> completion) override {
    stream_.async_handshake(net::ssl::stream_base::server, std::move(completion));
  }
  void Read(net::mutable_buffer buffer, Completion completion) override {
    stream_.async_read_some(buffer, std::move(completion));
  }
  void Write(const Buffers& buffers, Completion completion) override {
    stream_.async_write_some(buffers, std::move(completion));
  }
  void Finish(std::function<void()> completion) override {
    // TLS has an end of its own, which must be sent before that of TCP.
    stream_.async_shutdown([this, completion = std::move(completion)](error_code) {
      std::make_shared<Drain>(&stream_.next_layer(), completion)->Start();
    });
  }
  void CancelRead() override {
    error_code ignored;
    stream_.next_layer().cancel(ignored);
  }
  void Close() override {
    error_code ignored;
    stream_.next_layer().close(ignored);
  }

 private:
  net::ssl::stream<tcp::socket> stream_;
};

/// Throws std::runtime_error that names the file.
[[noreturn]] void FailTls(const std::filesystem::path& file, const std::string& expected,
                          const error_code& error) {
  throw std::runtime_error(file.string() + ": " + error.message() + ", expected " + expected);
}

}  // namespace

std::shared_ptr<net::ssl::context> LoadTls(const TlsFiles& files) {
  using net::ssl::context;
  auto tls = std::make_shared<context>(context::tls_server);
  // TLS 1.2 and 1.3 remain. OpenSSL ignores the options for versions that it was built without.
  tls->set_options(context::default_workarounds | context::no_sslv2 | context::no_sslv3 |
                   context::no_tlsv1 | context::no_tlsv1_1);
  // Without this, OpenSSL would ask for the password of a key on the terminal.
  tls->set_password_callback([](std::size_t, context::password_purpose) { return std::string(); });
  error_code error;
  tls->use_certificate_chain_file(files.certificate.string(), error);
  if (error) FailTls(files.certificate, "a certificate in PEM format", error);
  // Also checks that the key belongs to the certificate.
  tls->use_private_key_file(files.key.string(), context::pem, error);
  if (error) {
    FailTls(files.key,
            "the key of " + files.certificate.string() + " in PEM format, without password", error);
  }
  return tls;
}

std::unique_ptr<Link> MakeTcpLink(tcp::socket socket, net::ssl::context* tls) {
  if (tls == nullptr) return std::make_unique<TcpLink>(std::move(socket));
  return std::make_unique<TlsLink>(std::move(socket), tls);
}

}  // namespace smile::web_server
