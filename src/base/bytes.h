#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace smile {

static_assert(std::endian::native == std::endian::little,
              "files and messages are little-endian and written as they lie in memory");

/// Writer of plain values to a byte string, field by field, little-endian, without padding.
class ByteWriter {
 public:
  /// @param room  number of bytes that are expected: saves growing.
  explicit ByteWriter(std::size_t room = 0) : room_(room) {}

  template <class T>
  requires std::is_arithmetic_v<T> || std::is_enum_v<T>
  void Put(T value) { PutBytes({reinterpret_cast<const std::byte*>(&value), sizeof value}); }
  void PutBytes(std::span<const std::byte> bytes) {
    if (bytes.empty()) return;
    // Room for many values at once: a saved state is written eight bytes at a time.
    if (size_ + bytes.size() > room_.size()) {
      room_.resize(std::max({size_ + bytes.size(), 2 * room_.size(), kLeastRoom}));
    }
    std::memcpy(room_.data() + size_, bytes.data(), bytes.size());
    size_ += bytes.size();
  }
  /// Writes the length as u32, then the letters.
  void PutString(std::string_view text) {
    Put(static_cast<std::uint32_t>(text.size()));
    PutBytes(std::as_bytes(std::span(text.data(), text.size())));
  }

  std::size_t size() const { return size_; }
  /// Valid until the next Put.
  std::span<const std::byte> bytes() const { return std::span(room_).first(size_); }
  std::vector<std::byte> Take() {
    room_.resize(std::exchange(size_, 0));
    return std::exchange(room_, {});
  }

 private:
  static constexpr std::size_t kLeastRoom = 512;

  std::vector<std::byte> room_;
  std::size_t size_ = 0;  ///< number of bytes written; the rest of the room is for more
};

/// Reader of the bytes of ByteWriter. Never reads past the end: from the first read that would,
/// `ok()` is false and every read returns zeros, so a caller can check once, after reading.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::byte> bytes) : rest_(bytes) {}

  template <class T>
  requires std::is_arithmetic_v<T> || std::is_enum_v<T> T Get() {
    T value{};
    std::span<const std::byte> bytes = GetBytes(sizeof value);
    if (!bytes.empty()) std::memcpy(&value, bytes.data(), sizeof value);
    return value;
  }
  /// Returns true, and skips them, if these bytes come next.
  bool SkipIfNext(std::span<const std::byte> bytes) {
    if (bytes.empty()) return true;
    if (bytes.size() > rest_.size() || std::memcmp(rest_.data(), bytes.data(), bytes.size()) != 0) {
      return false;
    }
    rest_ = rest_.subspan(bytes.size());
    return true;
  }
  /// Returns the next `count` bytes; empty, and not `ok()`, if fewer are left.
  std::span<const std::byte> GetBytes(std::size_t count) {
    if (count > rest_.size()) {
      is_ok_ = false;
      rest_ = {};
      return {};
    }
    std::span<const std::byte> bytes = rest_.first(count);
    rest_ = rest_.subspan(count);
    return bytes;
  }
  std::string GetString() {
    std::span<const std::byte> bytes = GetBytes(Get<std::uint32_t>());
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }

  bool ok() const { return is_ok_; }
  std::size_t remaining() const { return rest_.size(); }

 private:
  std::span<const std::byte> rest_;
  bool is_ok_ = true;
};

}  // namespace smile
