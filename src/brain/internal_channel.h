#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <variant>

#include "brain/internal_unique_fd.h"
#include "brain/internal_wait_limit.h"
#include "wire/wire.h"

namespace smile::brain {

/// Why there is no message.
struct ChannelFault {
  enum class Kind { kTimedOut, kCancelled, kClosed, kNonsense };

  Kind kind = Kind::kClosed;
  std::string message;
};

/// Carries messages to a brain and back, over a socket or a pair of pipes.
class Channel {
 public:
  /// For pipes. Both ends are made non-blocking.
  Channel(UniqueFd read_end, UniqueFd write_end);
  /// For a socket, which is both.
  explicit Channel(UniqueFd socket);

  std::optional<ChannelFault> Send(std::span<const std::byte> frame, const WaitLimit& limit);
  std::variant<wire::Message, ChannelFault> Receive(const WaitLimit& limit);

 private:
  std::optional<ChannelFault> ReadAll(std::span<std::byte> bytes, const WaitLimit& limit);
  int write_fd() const { return write_end_ ? write_end_.get() : read_end_.get(); }

  UniqueFd read_end_;
  UniqueFd write_end_;  ///< none when the read end is a socket
};

}  // namespace smile::brain
