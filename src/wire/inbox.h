#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "wire/wire.h"

namespace smile::wire {

/// Gathers the bytes of a stream until they make a message.
///
/// Keeps its memory from message to message, and has room for more than one small message, so that
/// a single read brings header and body.
class Inbox {
 public:
  /// Where the next bytes of the stream go: never empty after TakeMessage() gave nothing.
  std::span<std::byte> Room() { return std::span(bytes_).subspan(filled_); }
  /// So many bytes have been put there.
  void Fill(std::size_t count) { filled_ += count; }

  /// The first message, when all of it is there. After an error, what follows means nothing.
  std::optional<std::variant<Message, WireError>> TakeMessage();

 private:
  std::vector<std::byte> bytes_;
  std::size_t filled_ = 0;
};

}  // namespace smile::wire
