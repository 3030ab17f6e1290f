#include "web_server/secret.h"

#include <sys/random.h>

#include <array>
#include <stdexcept>

namespace smile::web_server {

std::string RandomSecret() {
  constexpr std::string_view kHexDigits = "0123456789abcdef";
  std::array<unsigned char, kSecretDigits / 2> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
    throw std::runtime_error("no random numbers are available for a secret");
  }
  std::string secret;
  for (const unsigned char byte : bytes)
    secret.append({kHexDigits[byte >> 4], kHexDigits[byte & 15]});
  return secret;
}

bool IsSecret(std::string_view text, std::string_view secret) {
  if (text.size() != secret.size()) return false;
  unsigned difference = 0;
  for (std::size_t k = 0; k < secret.size(); ++k) {
    difference |= static_cast<unsigned char>(text[k]) ^ static_cast<unsigned char>(secret[k]);
  }
  return difference == 0;
}

}  // namespace smile::web_server
