#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "wire/wire.h"

namespace smile::wire {

/// Gathers the bytes of a stream until they make a message.
///
/// Has room for more than one small message, so that a single read brings header and body. The body
/// of a large one, which is nearly all picture, goes where it is to stay.
class Inbox {
 public:
  /// Returns so many bytes of memory, for the body of one message. They must stay until the message
  /// that lies in them is not looked at any more.
  using MakeRoom = std::function<std::span<std::byte>(std::size_t)>;

  /// @param make_room  for each large body; without it they share memory of the inbox.
  explicit Inbox(MakeRoom make_room = {}) : make_room_(std::move(make_room)) {}
  Inbox(Inbox&&) = default;
  Inbox& operator=(Inbox&&) = default;

  /// Where the next bytes of the stream go: never empty after TakeMessage() gave nothing.
  std::span<std::byte> Room();
  /// So many bytes have been put there.
  void Fill(std::size_t count) { filled_ += count; }

  /// Whether more has come than the messages that were taken.
  bool HasBytes() const { return large_ || filled_ > taken_; }

  /// The first message, when all of it is there: it lies in the inbox, or in what `make_room` gave,
  /// and is gone with the next call. After an error, what follows means nothing.
  std::optional<std::variant<MessageView, WireError>> TakeMessage();

 private:
  void RemoveTaken();
  void BeginLargeBody(const FrameHeader& header);

  MakeRoom make_room_;
  std::vector<std::byte> bytes_;      ///< header and body of what is small; filled_ of them hold
  std::size_t filled_ = 0;            ///< of bytes_, or of a large body
  std::size_t taken_ = 0;             ///< at the start of bytes_: of the message given last
  std::optional<FrameHeader> large_;  ///< while a large body is gathered
  std::span<std::byte> large_body_;   ///< all of it
  std::vector<std::byte> own_room_;
};

}  // namespace smile::wire
