#include "studio/internal_frames.h"

#include <limits>
#include <utility>

namespace smile::studio {
namespace {

constexpr std::uint8_t kLastPieceBit = 0x80, kReservedFrameBits = 0x70, kMaskedBit = 0x80;
constexpr std::size_t kMaxControlBytes = 125;

bool IsControl(Opcode opcode) { return static_cast<std::uint8_t>(opcode) >= 8; }

bool IsKnown(Opcode opcode) {
  const auto number = static_cast<std::uint8_t>(opcode);
  return number <= 2 || (number >= 8 && number <= 10);
}

[[noreturn]] void FailProtocol(const std::string& message) {
  throw FrameError(CloseCode::kProtocolError, message);
}

void AppendBigEndian(std::uint64_t number, int num_bytes, std::string* bytes) {
  for (int k = num_bytes - 1; k >= 0; --k) {
    bytes->push_back(static_cast<char>((number >> (8 * k)) & 0xFF));
  }
}

}  // namespace

std::string FrameHead(Opcode opcode, std::size_t payload_bytes) {
  std::string head(1, static_cast<char>(kLastPieceBit | static_cast<std::uint8_t>(opcode)));
  if (payload_bytes <= kMaxControlBytes) {
    head.push_back(static_cast<char>(payload_bytes));
  } else if (payload_bytes <= std::numeric_limits<std::uint16_t>::max()) {
    head.push_back(126);
    AppendBigEndian(payload_bytes, 2, &head);
  } else {
    head.push_back(127);
    AppendBigEndian(payload_bytes, 8, &head);
  }
  return head;
}

std::string ClosePayload(CloseCode code, std::string_view reason) {
  std::string payload;
  AppendBigEndian(static_cast<std::uint16_t>(code), 2, &payload);
  return payload.append(reason.substr(0, kMaxControlBytes - 2));
}

void MessageReader::Feed(std::string_view bytes) {
  bytes_.erase(0, begin_);
  begin_ = 0;
  bytes_.append(bytes);
}

std::optional<MessageReader::Head> MessageReader::ReadHead() const {
  const std::size_t available = bytes_.size() - begin_;
  const auto byte = [this](std::size_t k) { return static_cast<std::uint8_t>(bytes_[begin_ + k]); };
  if (available < 2) return std::nullopt;
  if ((byte(0) & kReservedFrameBits) != 0) FailProtocol("a frame has reserved bits set");
  if ((byte(1) & kMaskedBit) == 0) FailProtocol("a frame is not masked");
  Head head;
  head.is_last = (byte(0) & kLastPieceBit) != 0;
  head.opcode = static_cast<Opcode>(byte(0) & 0x0F);

  const std::uint8_t short_size = byte(1) & 0x7F;
  const std::size_t size_bytes = short_size < 126 ? 0 : short_size == 126 ? 2 : 8;
  if (available < 2 + size_bytes + sizeof head.mask) return std::nullopt;
  std::uint64_t payload_bytes = size_bytes == 0 ? short_size : 0;
  for (std::size_t k = 0; k < size_bytes; ++k) payload_bytes = payload_bytes << 8 | byte(2 + k);
  head.payload_bytes = payload_bytes;
  for (std::size_t k = 0; k < sizeof head.mask; ++k) head.mask[k] = byte(2 + size_bytes + k);
  head.head_bytes = 2 + size_bytes + sizeof head.mask;
  return head;
}

void MessageReader::Check(const Head& head) const {
  if (!IsKnown(head.opcode)) FailProtocol("a frame is of an unknown kind");
  if (IsControl(head.opcode)) {
    if (!head.is_last) FailProtocol("a control frame comes in pieces");
    if (head.payload_bytes > kMaxControlBytes) FailProtocol("a control frame is too long");
    return;
  }
  const bool goes_on = head.opcode == Opcode::kContinuation;
  if (goes_on && !unfinished_) FailProtocol("a message goes on that never began");
  if (!goes_on && unfinished_) FailProtocol("a message begins within another one");
  const std::size_t before = unfinished_ ? unfinished_->payload.size() : 0;
  if (head.payload_bytes > max_bytes_ - before) {
    throw FrameError(CloseCode::kTooBig, "a message is longer than " + std::to_string(max_bytes_) +
                                             " bytes, which is the most");
  }
}

std::string MessageReader::TakePayload(const Head& head) {
  std::string payload = bytes_.substr(begin_ + head.head_bytes, head.payload_bytes);
  for (std::size_t k = 0; k < payload.size(); ++k) {
    payload[k] = static_cast<char>(static_cast<std::uint8_t>(payload[k]) ^ head.mask[k % 4]);
  }
  begin_ += head.head_bytes + head.payload_bytes;
  ++num_frames_;
  return payload;
}

std::optional<MessageReader::Message> MessageReader::Next() {
  while (const std::optional<Head> head = ReadHead()) {
    Check(*head);
    if (bytes_.size() - begin_ - head->head_bytes < head->payload_bytes) break;
    std::string payload = TakePayload(*head);
    if (IsControl(head->opcode)) return Message{head->opcode, std::move(payload)};
    if (head->opcode == Opcode::kContinuation) {
      unfinished_->payload += payload;
    } else {
      unfinished_ = Message{head->opcode, std::move(payload)};
    }
    if (head->is_last) return std::exchange(unfinished_, std::nullopt);
  }
  return std::nullopt;
}

}  // namespace smile::studio
