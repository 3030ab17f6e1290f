#include "studio/internal_http.h"

#include <algorithm>
#include <charconv>

namespace smile::studio {
namespace {

constexpr std::string_view kNewLine = "\r\n";

bool IsAlphanumeric(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

/// RFC 9110, section 5.6.2.
bool IsHttpToken(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) {
    return IsAlphanumeric(c) ||
           std::string_view("!#$%&'*+-.^_`|~").find(c) != std::string_view::npos;
  });
}

bool HasControlCharacter(std::string_view text) {
  return std::ranges::any_of(
      text, [](char c) { return (static_cast<unsigned char>(c) < ' ' && c != '\t') || c == 0x7F; });
}

std::string_view WithoutBlanks(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

/// Cuts off what stands before `separator`, or all, and returns it.
std::string_view CutAt(std::string_view separator, std::string_view* rest) {
  const std::size_t end = std::min(rest->find(separator), rest->size());
  const std::string_view first = rest->substr(0, end);
  rest->remove_prefix(std::min(end + separator.size(), rest->size()));
  return first;
}

/// The value of `name=value` among those that `separator` parts.
std::string_view ValueInPairs(std::string_view name, std::string_view pairs,
                              std::string_view separator) {
  while (!pairs.empty()) {
    std::string_view value = WithoutBlanks(CutAt(separator, &pairs));
    if (CutAt("=", &value) == name) return value;
  }
  return {};
}

std::string PercentDecoded(std::string_view text) {
  std::string decoded;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] != '%') {
      decoded.push_back(text[k]);
      continue;
    }
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

/// A path whose every name is one, so that nobody climbs out of a folder with it.
std::string CheckedPath(std::string_view raw) {
  std::string path = PercentDecoded(raw);
  if (path.empty() || path[0] != '/') throw HttpError(400, "the path does not begin with /");
  if (HasControlCharacter(path) || path.find('\\') != std::string::npos) {
    throw HttpError(400, "the path has characters that no name has");
  }
  std::string_view rest = std::string_view(path).substr(1);
  while (!rest.empty()) {
    const std::string_view name = CutAt("/", &rest);
    if (name.empty() || name == "." || name == "..") throw HttpError(404, "there is no such page");
  }
  return path;
}

const char* StatusReason(int status) {
  switch (status) {
    case 101:
      return "Switching Protocols";
    case 200:
      return "OK";
    case 303:
      return "See Other";
    case 304:
      return "Not Modified";
    case 400:
      return "Bad Request";
    case 403:
      return "Forbidden";
    case 404:
      return "Not Found";
    case 405:
      return "Method Not Allowed";
    case 408:
      return "Request Timeout";
    case 426:
      return "Upgrade Required";
    case 431:
      return "Request Header Fields Too Large";
    case 503:
      return "Service Unavailable";
    default:
      return "Internal Server Error";
  }
}

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

HttpRequest ParseHttpHead(std::string_view head) {
  std::string_view line = CutAt(kNewLine, &head);
  HttpRequest request;
  request.method = CutAt(" ", &line);
  std::string_view target = CutAt(" ", &line);
  if (!IsHttpToken(request.method) || (line != "HTTP/1.1" && line != "HTTP/1.0")) {
    throw HttpError(400, "this is not HTTP/1.1");
  }
  request.path = CheckedPath(CutAt("?", &target));
  request.query = target;
  while (!head.empty()) {
    std::string_view value = CutAt(kNewLine, &head);
    const std::string_view name = CutAt(":", &value);
    value = WithoutBlanks(value);
    if (!IsHttpToken(name) || HasControlCharacter(value)) {
      throw HttpError(400, "a header is no `name: value`");
    }
    if (!request.headers.emplace(LowerCase(name), value).second) {
      throw HttpError(400, "a header is given twice");
    }
  }
  return request;
}

std::string HttpReply::Head() const {
  std::string head =
      "HTTP/1.1 " + std::to_string(status) + " " + StatusReason(status) + std::string(kNewLine);
  for (const auto& [name, value] : headers) {
    head.append(name).append(": ").append(value).append(kNewLine);
  }
  return head.append(kNewLine);
}

HttpReply TextReply(int status, std::string_view text) {
  return {status, {{"Content-Type", "text/plain; charset=utf-8"}}, std::string(text) + "\n"};
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

}  // namespace smile::studio
