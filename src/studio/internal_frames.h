#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace smile::studio {

// The frames of a WebSocket: RFC 6455, section 5. In requests of clients nothing is believed: sizes
// are checked before anything is kept.

enum class Opcode : std::uint8_t {
  kContinuation = 0,
  kText = 1,
  kBinary = 2,
  kClose = 8,
  kPing = 9,
  kPong = 10,
};

/// Why a connection is closed (section 7.4.1).
enum class CloseCode : std::uint16_t {
  kNormal = 1000,
  kGoingAway = 1001,
  kProtocolError = 1002,
  kUnsupported = 1003,
  kAgainstRules = 1008,
  kTooBig = 1009,
};

/// A client that does not keep to the protocol; its connection is to be closed with this code.
class FrameError : public std::runtime_error {
 public:
  FrameError(CloseCode code, const std::string& message)
      : std::runtime_error(message), code_(code) {}
  CloseCode code() const { return code_; }

 private:
  CloseCode code_;
};

/// What stands before a payload of this size in a frame of ours: whole, not masked.
std::string FrameHead(Opcode opcode, std::size_t payload_bytes);

/// Code and reason of a close frame.
std::string ClosePayload(CloseCode code, std::string_view reason);

/// Puts messages together from the bytes of a client.
class MessageReader {
 public:
  struct Message {
    Opcode opcode = Opcode::kText;
    std::string payload;
  };

  /// @param max_bytes  of a message, also if it comes in pieces.
  explicit MessageReader(std::size_t max_bytes) : max_bytes_(max_bytes) {}

  /// Bytes as they came.
  void Feed(std::string_view bytes);
  /// The next whole message; nullopt when more bytes are needed. Messages in pieces may have those
  /// of the connection (close, ping, pong) between.
  /// @throws FrameError; then nothing more is to be read.
  std::optional<Message> Next();
  /// How many frames have come so far; a message has one or more.
  std::uint64_t num_frames() const { return num_frames_; }

 private:
  struct Head {
    bool is_last = true;
    Opcode opcode = Opcode::kText;
    std::size_t head_bytes = 0, payload_bytes = 0;
    std::uint8_t mask[4] = {};
  };
  std::optional<Head> ReadHead() const;
  void Check(const Head& head) const;
  std::string TakePayload(const Head& head);

  std::size_t max_bytes_;
  std::string bytes_;
  std::size_t begin_ = 0;  ///< of what is not yet read in `bytes_`
  std::optional<Message> unfinished_;
  std::uint64_t num_frames_ = 0;
};

}  // namespace smile::studio
