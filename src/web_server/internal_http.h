#pragma once

#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/message.hpp>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace smile::web_server {

/// Refusal of a request, with status and text.
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
  std::string path;   ///< decoded; begins with `/`, has no `.` or `..` segment
  std::string query;  ///< as received
  std::map<std::string, std::string, std::less<>> headers;  ///< names in lower case

  /// Returns a header, by its name in lower case; empty if it is missing.
  std::string_view Header(std::string_view name) const;
  /// Returns a parameter of the query; empty if it is missing.
  std::string_view Parameter(std::string_view name) const;
  /// Returns a cookie; empty if it is missing.
  std::string_view Cookie(std::string_view name) const;
};

using BeastRequest = boost::beast::http::request<boost::beast::http::empty_body>;

/// @throws HttpError if the path or the headers are ambiguous or unsafe.
HttpRequest ToHttpRequest(const BeastRequest& request);
/// Parses the head of a request, up to the empty line, as a connection does.
/// @throws HttpError with the reason.
HttpRequest ParseHttpHead(std::string_view head);
/// Converts an error of Beast's parser.
HttpError ToHttpError(const boost::system::error_code& error);

/// Maximal size of a request up to its empty line.
constexpr std::size_t kMaxHeadBytes = 16384;

struct HttpReply {
  int status = 200;
  std::vector<std::pair<std::string, std::string>> headers;
  std::shared_ptr<const std::string> body = std::make_shared<const std::string>();
};

/// Returns a plain text for people.
HttpReply TextReply(int status, std::string_view text);

/// Returns the text with ASCII letters in lower case.
std::string LowerCase(std::string_view text);
/// Encodes everything but letters, digits and `-._` as `%XX`.
std::string PercentEncoded(std::string_view text);

}  // namespace smile::web_server
