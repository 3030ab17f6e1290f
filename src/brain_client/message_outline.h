#pragma once

#include <string>

#include "wire/wire.h"

namespace smile::brain_client {

/// Detects whether a message differs from the previous one in more than its numbers: in its type,
/// in names, kinds and shapes of its arrays, or in texts. Otherwise clients reuse their structures.
class MessageOutline {
 public:
  /// Returns true if the message differs from the previous one, and for the first message.
  bool Changes(const wire::MessageView& message);

 private:
  std::string outline_, last_;  ///< members, to reuse their memory
};

}  // namespace smile::brain_client
