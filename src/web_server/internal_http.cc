#include "web_server/internal_http.h"

#include <algorithm>
#include <boost/asio/buffer.hpp>
#include <boost/beast/http/error.hpp>
#include <boost/beast/http/parser.hpp>
#include <charconv>

// Requests as the rest of the room sees them: Beast parses the grammar of HTTP, and this file
// refuses what is grammatical and still ambiguous or dangerous, such as repeated headers or paths
// that lead out of a folder.

namespace smile::web_server {
namespace {

namespace http = boost::beast::http;

// Not std::isalnum, whose answer depends on the locale.
bool IsAlphanumeric(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

/// True if a text has ASCII control characters other than tabs.
bool HasControlCharacter(std::string_view text) {
  return std::ranges::any_of(
      text, [](char c) { return (static_cast<unsigned char>(c) < ' ' && c != '\t') || c == 0x7F; });
}

std::string_view WithoutBlanks(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

/// Removes and returns the text before `separator`, or all of it.
std::string_view CutAt(std::string_view separator, std::string_view* rest) {
  const std::size_t end = std::min(rest->find(separator), rest->size());
  const std::string_view first = rest->substr(0, end);
  rest->remove_prefix(std::min(end + separator.size(), rest->size()));
  return first;
}

/// Returns the value of `name=value` in a list with this separator; empty if it is missing.
std::string_view ValueInPairs(std::string_view name, std::string_view pairs,
                              std::string_view separator) {
  while (!pairs.empty()) {
    std::string_view value = WithoutBlanks(CutAt(separator, &pairs));
    if (CutAt("=", &value) == name) return value;
  }
  return {};
}

/// Decodes `%XX`; throws HttpError for incomplete escapes.
std::string PercentDecoded(std::string_view text) {
  std::string decoded;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] != '%') {
      decoded.push_back(text[k]);
      continue;
    }
    // std::from_chars accepts neither signs nor a prefix for unsigned numbers, so only digits pass.
    unsigned value = 256;
    const std::string_view digits = text.substr(k + 1, 2);
    const char* end = digits.data() + digits.size();
    if (digits.size() != 2 || std::from_chars(digits.data(), end, value, 16).ptr != end) {
      throw HttpError(400, "the path has a % without two digits");
    }
    decoded.push_back(static_cast<char>(value));
    k += 2;
  }
  return decoded;
}

/// Returns the decoded path; throws HttpError unless each of its segments is a name, so that none
/// leads out of a folder. The checks follow the decoding, as `%2e%2e` must not pass.
std::string CheckedPath(std::string_view raw) {
  std::string path = PercentDecoded(raw);
  if (path.empty() || path[0] != '/') throw HttpError(400, "the path does not begin with /");
  if (HasControlCharacter(path) || path.find('\\') != std::string::npos) {
    throw HttpError(400, "the path has invalid characters");
  }
  std::string_view rest = std::string_view(path).substr(1);
  while (!rest.empty()) {
    const std::string_view name = CutAt("/", &rest);
    if (name.empty() || name == "." || name == "..") throw HttpError(404, "there is no such page");
  }
  return path;
}

std::string ToText(boost::beast::string_view text) { return {text.data(), text.size()}; }

}  // namespace

std::string_view HttpRequest::Header(std::string_view name) const {
  const auto header = headers.find(name);
  return header == headers.end() ? std::string_view() : header->second;
}

std::string_view HttpRequest::Parameter(std::string_view name) const {
  return ValueInPairs(name, query, "&");
}

std::string_view HttpRequest::Cookie(std::string_view name) const {
  return ValueInPairs(name, Header("cookie"), ";");
}

HttpRequest ToHttpRequest(const BeastRequest& received) {
  HttpRequest request;
  request.method = ToText(received.method_string());
  const std::string whole = ToText(received.target());
  std::string_view target = whole;
  request.path = CheckedPath(CutAt("?", &target));
  request.query = target;
  for (const auto& field : received) {
    // Repeated headers are refused, since a proxy on the way might use another one than this
    // server.
    if (!request.headers.emplace(LowerCase(ToText(field.name_string())), ToText(field.value()))
             .second) {
      throw HttpError(400, "a header is given twice");
    }
  }
  return request;
}

HttpRequest ParseHttpHead(std::string_view head) {
  http::request_parser<http::empty_body> parser;
  parser.header_limit(kMaxHeadBytes);
  const std::string bytes = std::string(head) + "\r\n\r\n";
  boost::system::error_code error;
  parser.put(boost::asio::buffer(bytes), error);
  if (error) throw ToHttpError(error);
  return ToHttpRequest(parser.get());
}

HttpError ToHttpError(const boost::system::error_code& error) {
  // Both mean that kMaxHeadBytes was exceeded: in the parser, or in the buffer before it.
  const bool is_long = error == http::error::header_limit || error == http::error::buffer_overflow;
  if (is_long) return {431, "the head of the request is too long"};
  return {400, "this is not HTTP/1.1: " + error.message()};
}

HttpReply TextReply(int status, std::string_view text) {
  return {status,
          {{"Content-Type", "text/plain; charset=utf-8"}},
          std::make_shared<const std::string>(std::string(text) + "\n")};
}

std::string LowerCase(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

std::string PercentEncoded(std::string_view text) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string encoded;
  for (const char c : text) {
    if (IsAlphanumeric(c) || c == '-' || c == '.' || c == '_') {
      encoded.push_back(c);
    } else {
      const auto byte = static_cast<unsigned char>(c);
      encoded.append({'%', kDigits[byte >> 4], kDigits[byte & 15]});
    }
  }
  return encoded;
}

}  // namespace smile::web_server
