#include "page_input.h"

#include "web_server/internal_http.h"
#include "web_server/internal_transcript.h"

namespace smile::fuzz {
namespace {

constexpr std::size_t kMaxMessageBytes = 1024;

bool IsHttp(std::string_view bytes) { return bytes.starts_with('H'); }

std::string FaultWithHead(std::string_view head) {
  try {
    const web_server::HttpRequest request = web_server::ParseHttpHead(head);
    if (!request.path.starts_with('/')) return "a path does not begin at the root";
    if ((request.path + "/").find("/../") != std::string::npos) return "a path leads upwards";
    if (request.path.find('\0') != std::string::npos) return "a path holds a zero";
    return "";
  } catch (const web_server::HttpError& error) {
    if (error.status() < 400 || error.status() > 599) return "a refusal is no refusal";
    return *error.what() == '\0' ? "refused without a reason" : "";
  }
}

web_server::Transcript Read(std::string_view bytes, std::size_t piece_bytes) {
  return web_server::ReadWebSocket(bytes, piece_bytes, kMaxMessageBytes);
}

std::string FaultWithFrames(std::string_view bytes) {
  const web_server::Transcript whole = Read(bytes, bytes.size() + 1);
  for (const std::string& message : whole.messages) {
    if (message.size() > kMaxMessageBytes) return "a message is too large";
  }
  if (Read(bytes, 1) != whole) return "in pieces it means something else";
  return "";
}

}  // namespace

std::string ReasonAgainstPageInput(std::string_view bytes) {
  if (!IsHttp(bytes)) {
    // 1000 answers a client that says so first.
    const int code = Read(bytes, bytes.size() + 1).close_code;
    return code == 0 || code == 1000 ? "" : "closed with " + std::to_string(code);
  }
  try {
    web_server::ParseHttpHead(bytes.substr(1));
    return "";
  } catch (const web_server::HttpError& error) {
    return error.what();
  }
}

std::string FaultWithPageInput(std::string_view bytes) {
  return IsHttp(bytes) ? FaultWithHead(bytes.substr(1)) : FaultWithFrames(bytes);
}

}  // namespace smile::fuzz
