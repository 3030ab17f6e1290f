#include "wire/inbox.h"

#include <algorithm>
#include <cstring>

namespace smile::wire {
namespace {

constexpr std::size_t kUsualBytes = 64 << 10;  ///< all but pictures

}  // namespace

std::optional<std::variant<Message, WireError>> Inbox::TakeMessage() {
  std::size_t needed = kHeaderBytes;
  FrameHeader header;
  if (filled_ >= kHeaderBytes) {
    const auto decoded = DecodeHeader(std::span(bytes_).first<kHeaderBytes>());
    if (const auto* error = std::get_if<WireError>(&decoded)) return *error;
    header = std::get<FrameHeader>(decoded);
    needed += header.body_bytes;
  }
  if (filled_ < needed) {
    if (bytes_.size() < needed) bytes_.resize(std::max(needed, kUsualBytes));
    return std::nullopt;
  }
  auto message = DecodeBody(header, std::span(bytes_).subspan(kHeaderBytes, header.body_bytes));
  std::memmove(bytes_.data(), bytes_.data() + needed, filled_ - needed);
  filled_ -= needed;
  return message;
}

}  // namespace smile::wire
