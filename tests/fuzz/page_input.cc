#include "page_input.h"

#include <vector>

#include "studio/internal_frames.h"
#include "studio/internal_http.h"

namespace smile::fuzz {
namespace {

constexpr std::size_t kMaxMessageBytes = 1024;

bool IsHttp(std::string_view bytes) { return bytes.starts_with('H'); }

std::string FaultWithHead(std::string_view head) {
  try {
    const studio::HttpRequest request = studio::ParseHttpHead(head);
    if (!request.path.starts_with('/')) return "a path does not begin at the root";
    if ((request.path + "/").find("/../") != std::string::npos) return "a path leads upwards";
    if (request.path.find('\0') != std::string::npos) return "a path holds a zero";
    return "";
  } catch (const studio::HttpError& error) {
    if (error.status() < 400 || error.status() > 599) return "a refusal is no refusal";
    return *error.what() == '\0' ? "refused without a reason" : "";
  }
}

/// Messages, and why there are no more of them.
struct Conversation {
  std::vector<std::string> messages;
  std::string reason;

  bool operator==(const Conversation&) const = default;
};

Conversation Read(std::string_view bytes, std::size_t piece_bytes) {
  studio::MessageReader reader(kMaxMessageBytes);
  Conversation conversation;
  try {
    for (std::size_t at = 0; at < bytes.size(); at += piece_bytes) {
      reader.Feed(bytes.substr(at, piece_bytes));
      while (auto message = reader.Next()) {
        conversation.messages.push_back(std::move(message->payload));
      }
    }
  } catch (const studio::FrameError& error) {
    conversation.reason = error.what();
    if (conversation.reason.empty()) conversation.reason = "refused without a reason";
  }
  return conversation;
}

std::string FaultWithFrames(std::string_view bytes) {
  const Conversation whole = Read(bytes, bytes.size() + 1);
  if (whole.reason == "refused without a reason") return whole.reason;
  for (const std::string& message : whole.messages) {
    if (message.size() > kMaxMessageBytes) return "a message is too large";
  }
  if (Read(bytes, 1) != whole) return "in pieces it means something else";
  return "";
}

}  // namespace

std::string ReasonAgainstPageInput(std::string_view bytes) {
  if (!IsHttp(bytes)) return Read(bytes, bytes.size() + 1).reason;
  try {
    studio::ParseHttpHead(bytes.substr(1));
    return "";
  } catch (const studio::HttpError& error) {
    return error.what();
  }
}

std::string FaultWithPageInput(std::string_view bytes) {
  return IsHttp(bytes) ? FaultWithHead(bytes.substr(1)) : FaultWithFrames(bytes);
}

}  // namespace smile::fuzz
