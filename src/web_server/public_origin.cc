#include "web_server/public_origin.h"

#include <regex>
#include <stdexcept>

#include "base/wording.h"
#include "web_server/internal_http.h"

namespace smile::web_server {

std::string OriginOf(const std::string& url) {
  // Names of DNS; a number of IPv6 in brackets is no public name.
  static const std::regex kOrigin("https?://[a-z0-9]([a-z0-9.-]{0,251}[a-z0-9])?(:[0-9]{1,5})?/?",
                                  std::regex::icase);
  constexpr std::size_t kMaxLength = 300;
  if (url.size() > kMaxLength || !std::regex_match(url, kOrigin)) {
    throw std::invalid_argument("is \"" + Printable(url.substr(0, kMaxLength)) +
                                "\", expected https://NAME or https://NAME:PORT, without a path");
  }
  return LowerCase(url.ends_with('/') ? url.substr(0, url.size() - 1) : url);
}

}  // namespace smile::web_server
