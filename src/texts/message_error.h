#pragma once

#include <stdexcept>
#include <utility>

#include "texts/user_message.h"

namespace smile::texts {

/// Error whose message people read on the page.
class MessageError : public std::runtime_error {
 public:
  explicit MessageError(UserMessage message)
      : std::runtime_error(message), message_(std::move(message)) {}

  const UserMessage& message() const { return message_; }

 private:
  UserMessage message_;
};

}  // namespace smile::texts
