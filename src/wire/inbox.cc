#include "wire/inbox.h"

#include <algorithm>
#include <cstring>

// Collects bytes of a socket and returns whole messages. Most messages fit into one small buffer
// and are decoded in place; a larger body, such as a picture, is received directly into memory of
// its own, without a copy. A view that was returned is valid until the next call.

namespace smile::wire {
namespace {

constexpr std::size_t kSmallBytes = 64 << 10;  ///< enough for all messages without pictures

}  // namespace

std::span<std::byte> Inbox::Room() {
  RemoveTaken();
  return (large_ ? large_body_ : std::span(bytes_)).subspan(filled_);
}

std::optional<std::variant<MessageView, WireError>> Inbox::TakeMessage() {
  RemoveTaken();
  // Allocated on first use.
  if (bytes_.empty()) bytes_.resize(kSmallBytes);
  if (!large_) {
    if (filled_ < kHeaderBytes) return std::nullopt;
    const auto decoded = DecodeHeader(std::span(bytes_).first<kHeaderBytes>());
    if (const auto* error = std::get_if<WireError>(&decoded)) return *error;
    const FrameHeader header = std::get<FrameHeader>(decoded);
    const std::size_t size = kHeaderBytes + header.body_bytes;
    // A small message is decoded in place; it is removed with the next call.
    if (size <= bytes_.size()) {
      if (filled_ < size) return std::nullopt;
      taken_ = size;
      return DecodeBody(header, std::span(bytes_).subspan(kHeaderBytes, header.body_bytes));
    }
    BeginLargeBody(header);
  }
  if (filled_ < large_body_.size()) return std::nullopt;
  const FrameHeader header = *large_;
  large_.reset();
  filled_ = 0;
  return DecodeBody(header, large_body_);
}

/// Moves the bytes after the last message to the front.
void Inbox::RemoveTaken() {
  if (taken_ == 0) return;
  std::memmove(bytes_.data(), bytes_.data() + taken_, filled_ - taken_);
  filled_ -= taken_;
  taken_ = 0;
}

/// Starts a body that exceeds the buffer. All bytes so far belong to this message, as it has more
/// than fit; they move to the body's own memory, and the rest is read there directly.
void Inbox::BeginLargeBody(const FrameHeader& header) {
  if (make_room_) {
    large_body_ = make_room_(header.body_bytes);
  } else {
    // Grows only: the next picture has the same size.
    own_room_.resize(std::max<std::size_t>(own_room_.size(), header.body_bytes));
    large_body_ = std::span(own_room_).first(header.body_bytes);
  }
  filled_ -= kHeaderBytes;
  std::memcpy(large_body_.data(), bytes_.data() + kHeaderBytes, filled_);
  large_ = header;
}

}  // namespace smile::wire
