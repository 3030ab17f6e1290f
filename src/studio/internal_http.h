#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace smile::studio {

// HTTP/1.1 as far as a page needs it: GET and HEAD, one request a connection, no bodies.

/// A request that is not answered as it wishes: with this status and this text.
class HttpError : public std::runtime_error {
 public:
  HttpError(int status, const std::string& message)
      : std::runtime_error(message), status_(status) {}
  int status() const { return status_; }

 private:
  int status_;
};

struct HttpRequest {
  std::string method;
  std::string path;   ///< decoded; it begins with `/` and names nothing outside
  std::string query;  ///< as it came
  std::map<std::string, std::string, std::less<>> headers;  ///< names in lower case

  /// Empty if there is none.
  std::string_view Header(std::string_view name) const;
  /// Of the query; empty if there is none.
  std::string_view Parameter(std::string_view name) const;
  /// Empty if there is none.
  std::string_view Cookie(std::string_view name) const;
};

/// @param head  all before the empty line.
/// @throws HttpError saying what is wrong with it.
HttpRequest ParseHttpHead(std::string_view head);

struct HttpReply {
  int status = 200;
  std::vector<std::pair<std::string, std::string>> headers;
  std::string body;

  std::string Head() const;
};

/// A text for people.
HttpReply TextReply(int status, std::string_view text);

/// `a`-`z` for `A`-`Z`.
std::string LowerCase(std::string_view text);
/// All but letters, digits and `-._` as `%XX`.
std::string PercentEncoded(std::string_view text);

}  // namespace smile::studio
