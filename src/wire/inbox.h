#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "wire/wire.h"

namespace smile::wire {

/// Collects the bytes of a stream until a message is complete.
///
/// Has room for several small messages, so that a single read brings header and body. The body of a
/// large one, mostly a picture, is read directly into its final memory.
class Inbox {
 public:
  /// Returns memory of a size [bytes] for the body of one message. It must remain valid while the
  /// message in it is used.
  using MakeRoom = std::function<std::span<std::byte>(std::size_t)>;

  /// @param make_room  for each large body; without it they share memory of the inbox.
  explicit Inbox(MakeRoom make_room = {}) : make_room_(std::move(make_room)) {}
  Inbox(Inbox&&) = default;
  Inbox& operator=(Inbox&&) = default;

  /// Returns the memory for the next bytes of the stream: never empty after TakeMessage() returned
  /// nothing.
  std::span<std::byte> Room();
  /// Records that a number of bytes was written there.
  void Fill(std::size_t count) { filled_ += count; }

  /// Returns true if there are bytes beyond the messages that were taken.
  bool HasBytes() const { return large_ || filled_ > taken_; }

  /// Returns the first message if it is complete; it lies in the inbox, or in memory of
  /// `make_room`, and is invalid after the next call. After an error, the rest of the stream is
  /// meaningless.
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
