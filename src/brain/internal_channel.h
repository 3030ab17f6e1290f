#pragma once

#include <sys/types.h>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <variant>

#include "process/unique_fd.h"
#include "process/wait_limit.h"
#include "wire/inbox.h"
#include "wire/wire.h"

namespace smile::brain {

/// Why there is no message.
struct ChannelFault {
  enum class Kind { kTimedOut, kCancelled, kClosed, kNonsense };

  Kind kind = Kind::kClosed;
  std::string message;
};

/// Carries messages to a brain and back, over a socket or a pair of pipes.
///
/// Most programs answer within microseconds, and to fall asleep and be woken takes longer than
/// that: before it sleeps, Receive() lets others work and looks again, for up to kWatchfulTime.
class Channel {
 public:
  /// For pipes. Both ends are made non-blocking.
  Channel(process::UniqueFd read_end, process::UniqueFd write_end);
  /// For a socket, which is both.
  explicit Channel(process::UniqueFd socket);

  std::optional<ChannelFault> Send(std::span<const std::byte> frame,
                                   const process::WaitLimit& limit);
  std::variant<wire::Message, ChannelFault> Receive(const process::WaitLimit& limit);

 private:
  /// Reads what has come into the room of `inbox_`; 0 when that is nothing.
  std::variant<std::size_t, ChannelFault> ReadSome();
  ssize_t WriteSome(std::span<const std::byte> bytes) const;
  bool is_socket() const { return !write_end_; }
  int write_fd() const { return write_end_ ? write_end_.get() : read_end_.get(); }

  process::UniqueFd read_end_;
  process::UniqueFd write_end_;  ///< none when the read end is a socket
  wire::Inbox inbox_;
};

}  // namespace smile::brain
