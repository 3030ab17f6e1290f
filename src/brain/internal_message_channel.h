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

/// Reason why there is no message.
struct ChannelFault {
  enum class Kind { kTimedOut, kCancelled, kClosed, kNonsense };

  Kind kind = Kind::kClosed;
  std::string message;
};

/// Message channel to a brain, over a socket or a pair of pipes.
///
/// Most programs answer within microseconds, which is less than sleeping and waking takes: before
/// it sleeps, Receive() yields the processor and polls again, for up to kWatchfulTime.
class MessageChannel {
 public:
  /// Makes a channel of two pipes; sets both ends to non-blocking.
  MessageChannel(process::UniqueFd read_end, process::UniqueFd write_end);
  /// Makes a channel of a socket, which is both ends.
  explicit MessageChannel(process::UniqueFd socket);

  std::optional<ChannelFault> Send(std::span<const std::byte> frame,
                                   const process::WaitLimit& limit);
  std::variant<wire::Message, ChannelFault> Receive(const process::WaitLimit& limit);

 private:
  /// Reads available bytes into `inbox_`; 0 if there are none.
  std::variant<std::size_t, ChannelFault> ReadSome();
  ssize_t WriteSome(std::span<const std::byte> bytes) const;
  bool is_socket() const { return !write_end_; }
  int write_fd() const { return write_end_ ? write_end_.get() : read_end_.get(); }

  process::UniqueFd read_end_;
  process::UniqueFd write_end_;  ///< empty if the read end is a socket
  wire::Inbox inbox_;
};

}  // namespace smile::brain
