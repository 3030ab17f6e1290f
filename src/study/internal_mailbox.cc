#include "study/internal_mailbox.h"

#include <memory>
#include <stdexcept>
#include <utility>

namespace smile::study {
namespace {

using web_server::CloseCode;
using web_server::OutgoingMessage;
using web_server::WebSocketId;

constexpr std::size_t kMaxWebSockets = 512;
/// Messages that wait for the study's thread; then nothing is read for a while.
constexpr std::size_t kMaxIncoming = 4096;

OutgoingMessage CloseMessage(const std::string& reason, CloseCode code) {
  return {.kind = OutgoingMessage::Kind::kClose,
          .body = std::make_shared<const std::string>(reason),
          .code = code};
}

}  // namespace

bool Mailbox::Open(WebSocketId id) {
  const std::lock_guard lock(mutex_);
  return outgoing_.size() < kMaxWebSockets && outgoing_.try_emplace(id).second;
}

void Mailbox::Receive(WebSocketId id, bool is_text, std::string_view message) {
  Json content;
  try {
    if (is_text) content = ParseJson(message);
  } catch (const std::invalid_argument&) {
    // Refused below, as other messages that are no objects.
  }
  const std::lock_guard lock(mutex_);
  if (content.is_object()) {
    incoming_.push_back({id, std::move(content)});
  } else {
    Post(id, CloseMessage("expected a JSON object", CloseCode::kUnsupported));
  }
}

bool Mailbox::CanReceive(WebSocketId) {
  const std::lock_guard lock(mutex_);
  return incoming_.size() < kMaxIncoming;
}

void Mailbox::LimitExceeded(WebSocketId id, const std::string& reason) {
  const std::lock_guard lock(mutex_);
  Post(id, CloseMessage(reason, CloseCode::kPolicyViolation));
}

std::optional<OutgoingMessage> Mailbox::NextMessage(WebSocketId id) {
  const std::lock_guard lock(mutex_);
  const auto waiting = outgoing_.find(id);
  if (waiting == outgoing_.end() || waiting->second.empty()) return std::nullopt;
  OutgoingMessage message = std::move(waiting->second.front());
  waiting->second.pop_front();
  return message;
}

void Mailbox::Close(WebSocketId id) {
  const std::lock_guard lock(mutex_);
  if (outgoing_.erase(id) > 0) incoming_.push_back({id, nullptr});
}

std::vector<PageMessage> Mailbox::Take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(incoming_, {});
}

void Mailbox::Send(WebSocketId id, const Json& message) {
  const std::lock_guard lock(mutex_);
  Post(id, {.body = std::make_shared<const std::string>(ToText(message))});
}

void Mailbox::CloseAfterAll(WebSocketId id, const std::string& reason) {
  const std::lock_guard lock(mutex_);
  Post(id, CloseMessage(reason, CloseCode::kNormal));
}

void Mailbox::Post(WebSocketId id, OutgoingMessage message) {
  const auto waiting = outgoing_.find(id);
  if (waiting != outgoing_.end()) waiting->second.push_back(std::move(message));
}

}  // namespace smile::study
