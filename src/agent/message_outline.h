#pragma once

#include <string>

#include "wire/wire.h"

namespace smile::agent {

/// Notices when a message differs from the one before in more than its numbers: in its type, or in
/// names, kinds and shapes of its arrays, or in texts. Clients need not prepare anew what did not.
class MessageOutline {
 public:
  /// Whether it is other than the message given before; the first one is.
  bool Changes(const wire::MessageView& message);

 private:
  std::string outline_, last_;  ///< members, so that their memory is used again
};

}  // namespace smile::agent
