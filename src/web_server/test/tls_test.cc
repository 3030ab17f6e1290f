// The same over TLS, seen by OpenSSL's own client.

#include <array>
#include <cstdio>

#include "web_server_fixture.h"

namespace smile::web_server {
namespace {

/// All that a line of shell prints.
std::string OutputOf(const std::string& line) {
  FILE* pipe = popen(("exec 2>&1; " + line).c_str(), "r");
  std::string output;
  std::array<char, 4096> piece;
  while (const std::size_t count = fread(piece.data(), 1, piece.size(), pipe)) {
    output.append(piece.data(), count);
  }
  pclose(pipe);
  return output;
}

class TlsTest : public WebServerTest {
 protected:
  TlsTest() {
    certificate_ = folder_ / "certificate.pem";
    key_ = folder_ / "key.pem";
    OutputOf(
        "openssl req -x509 -newkey ec -pkeyopt ec_paramgen_curve:prime256v1 -nodes -days 2 "
        "-subj /CN=localhost -addext subjectAltName=DNS:localhost,IP:127.0.0.1 -keyout " +
        key_.string() + " -out " + certificate_.string());
    options_.tls = TlsFiles{.certificate = certificate_, .key = key_};
  }

  /// What comes back over TLS; the certificate is checked.
  std::string Exchange(const std::string& printf_format, const std::string& options = "") {
    return OutputOf("printf '" + printf_format +
                    "' | timeout 20 openssl s_client -quiet -connect 127.0.0.1:" +
                    std::to_string(port()) + " -CAfile " + certificate_.string() +
                    " -verify_return_error -verify_ip 127.0.0.1 " + options);
  }
  std::string HostLine() { return "Host: localhost:" + std::to_string(port()) + "\\r\\n"; }
  /// The response to the only request of a connection.
  std::string Get(const std::string& path, const std::string& options = "") {
    return Exchange(
        "GET " + path + " HTTP/1.1\\r\\n" + HostLine() + "Connection: close\\r\\n\\r\\n", options);
  }

  std::string FailureOf(const TlsFiles& files) {
    options_.tls = files;
    try {
      server();
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }

  std::filesystem::path certificate_, key_;
};

TEST_F(TlsTest, ServesThePageOverHttps) {
  EXPECT_EQ(server().link(), "https://127.0.0.1:" + std::to_string(port()) + "/");
  const std::string page = Get("/");
  EXPECT_NE(page.find("HTTP/1.1 200 OK"), std::string::npos) << page;
  EXPECT_NE(page.find("connect-src 'self' blob: wss://localhost:"), std::string::npos) << page;
  EXPECT_NE(page.find("<html>the page</html>"), std::string::npos);
}

TEST_F(TlsTest, CarriesWebSocketsOfItsOwnPages) {
  const std::string upgrade =
      "GET /ws HTTP/1.1\\r\\n" + HostLine() +
      "Upgrade: websocket\\r\\nConnection: Upgrade\\r\\nSec-WebSocket-Version: 13\\r\\n"
      "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\\r\\nOrigin: ";
  const std::string host = "localhost:" + std::to_string(port());
  const std::string hello =
      "\\r\\n\\r\\n\\201\\205\\000\\000\\000\\000hello"
      "\\210\\200\\000\\000\\000\\000";  // and a close frame
  const std::string own = Exchange(upgrade + "https://" + host + hello);
  EXPECT_NE(own.find("101 Switching Protocols"), std::string::npos) << own;
  EXPECT_NE(own.find("\x81\x05hello"), std::string::npos);
  EXPECT_NE(Exchange(upgrade + "http://" + host + hello).find("403 Forbidden"), std::string::npos);
}

TEST_F(TlsTest, TheTokensCookieTravelsOverTlsOnly) {
  options_.address = "0.0.0.0";
  const std::string link = server().link();
  const std::string answer = Get("/" + link.substr(link.find("?token=")));
  EXPECT_NE(answer.find("303 See Other"), std::string::npos) << answer;
  EXPECT_NE(answer.find("; Secure"), std::string::npos);
}

TEST_F(TlsTest, RefusesPlainAndOutdatedConnections) {
  EXPECT_EQ(Connect().Get("/").find("the page"), std::string::npos);
  const std::string old = Get("/", "-tls1_1");
  EXPECT_EQ(old.find("the page"), std::string::npos);
}

TEST_F(TlsTest, SilentHandshakesDoNotBlockOtherClients) {
  options_.limits.connections = 20;
  std::vector<WebClient> silent;
  for (int k = 0; k < 100; ++k) silent.push_back(Connect());
  const std::string page = Get("/");
  EXPECT_NE(page.find("<html>the page</html>"), std::string::npos);
}

TEST_F(TlsTest, NamesTheFileThatIsWrong) {
  const std::string missing = folder_ / "nothing.pem";
  EXPECT_TRUE(FailureOf({missing, key_}).starts_with(missing + ": ")) << FailureOf({missing, key_});
  EXPECT_TRUE(FailureOf({certificate_, missing}).starts_with(missing + ": "));
  const std::filesystem::path other = folder_ / "other.pem", locked = folder_ / "locked.pem";
  OutputOf("openssl genpkey -algorithm EC -pkeyopt ec_paramgen_curve:prime256v1 -out " +
           other.string());
  EXPECT_TRUE(FailureOf({certificate_, other}).starts_with(other.string() + ": "));
  OutputOf("openssl pkey -aes128 -passout pass:secret -in " + key_.string() + " -out " +
           locked.string());
  EXPECT_TRUE(FailureOf({certificate_, locked}).starts_with(locked.string() + ": "));
}

}  // namespace
}  // namespace smile::web_server
