#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// Binary protocol between the simulator and a brain, used by both sides, see
/// docs/brain-protocol.md: a frame is a 16-byte header and a body of named arrays. Received bytes
/// are untrusted until decoded.
namespace smile::wire {

inline constexpr std::uint32_t kMagic = 0x31424d53;  ///< the letters SMB1
inline constexpr int kProtocolVersion = 1;
inline constexpr std::size_t kHeaderBytes = 16;
inline constexpr std::size_t kMaxBodyBytes = std::size_t{64} << 20;
inline constexpr std::size_t kMaxArrays = 64;
inline constexpr std::size_t kMaxDimensions = 8;
inline constexpr std::size_t kMaxNameLetters = 63;

enum class MessageType : std::uint32_t {
  kHello = 1,       ///< brain to simulator: identification of the brain
  kInit = 2,        ///< to the brain: the fields of `aux`
  kInitDone = 3,    ///< to the simulator: what init left in `aux`
  kStep = 4,        ///< to the brain: the fields of `sensor`
  kMotor = 5,       ///< to the simulator: the fields of `motor`
  kFinalMotor = 6,  ///< the same, from a brain that wants to end here
  kError = 7,       ///< to the simulator: message, file, line
  kBye = 8,         ///< to the brain: please end
};

enum class ElementType : std::uint8_t { kDouble = 0, kByte = 1, kLogical = 2, kText = 3 };

/// Returns a shape as text, such as `2x7`.
std::string ShapeText(std::span<const std::uint32_t> dims);

std::size_t ElementBytes(ElementType type);

/// Copies elements from column-major to row-major order; `to` has the size of `from`.
void CopyToRowMajor(std::span<const std::uint32_t> dims, std::size_t element_bytes,
                    std::span<const std::byte> from, std::span<std::byte> to);

/// Array with a name.
struct NamedArray {
  std::string name;  ///< a letter or _, then letters, digits, _; at most kMaxNameLetters
  ElementType type = ElementType::kDouble;
  bool is_fraction = false;         ///< bytes 0 to 255 that stand for 0 to 1
  bool is_row_major = false;        ///< the last dimension varies fastest, otherwise the first
  std::vector<std::uint32_t> dims;  ///< 2 to kMaxDimensions of them
  std::vector<std::byte> data;      ///< 8 bytes for each double, otherwise 1 byte for each element

  /// Returns the elements as numbers, in the order of `data`; nullopt for text. Fractions are
  /// divided by 255.
  std::optional<std::vector<double>> Numbers() const;
  /// Returns the letters; nullopt if this is not text.
  std::optional<std::string> Text() const;

  bool operator==(const NamedArray&) const = default;
};

/// Array of a message, in memory that is owned elsewhere.
struct ArrayView {
  std::string_view name;
  ElementType type = ElementType::kDouble;
  bool is_fraction = false;
  bool is_row_major = false;
  std::array<std::uint32_t, kMaxDimensions> all_dims = {};  ///< only the first `dim_count` count
  std::size_t dim_count = 0;
  std::span<const std::byte> data;

  std::span<const std::uint32_t> dims() const { return std::span(all_dims).first(dim_count); }
};

/// Message whose arrays are in memory that is owned elsewhere.
struct MessageView {
  MessageType type = MessageType::kHello;
  std::uint32_t sequence = 0;
  std::vector<ArrayView> arrays;  ///< each name once
};

struct Message {
  MessageType type = MessageType::kHello;
  std::uint32_t sequence = 0;  ///< an answer carries the number of its question
  std::vector<NamedArray> arrays;

  /// Returns the array of this name; nullptr if it is missing.
  const NamedArray* Find(std::string_view name) const;
  /// Returns the text of an array; empty if it is missing or not text.
  std::string TextOf(std::string_view name) const;

  bool operator==(const Message&) const = default;
};

Message Copied(const MessageView& view);

/// Writer of one frame, array by array.
///
/// Invalid names, shapes that do not fit their data, and exceeded limits are errors of the caller
/// and throw std::invalid_argument.
class MessageWriter {
 public:
  /// @param expected_bytes  of the body: reserved in advance, for messages with large arrays.
  MessageWriter(MessageType type, std::uint32_t sequence, std::size_t expected_bytes = 1000);

  /// Adds an array in column-major order.
  void AddDoubles(std::string_view name, std::span<const std::uint32_t> dims,
                  std::span<const double> values);
  void AddScalar(std::string_view name, double value);
  void AddLogical(std::string_view name, bool value);
  /// Adds a text: one row of letters.
  void AddText(std::string_view name, std::string_view text);
  void AddArray(const NamedArray& array);
  /// Adds an array and returns the memory of its elements, to be filled before the next call.
  std::span<std::byte> AddSpace(std::string_view name, ElementType type, bool is_fraction,
                                std::span<const std::uint32_t> dims, bool is_row_major = false);

  /// Returns the whole frame; the writer cannot be used again.
  std::vector<std::byte> Finish();

 private:
  /// Position of a name in the frame.
  struct NameSpan {
    std::uint32_t begin, letters;
  };

  bool HasArray(std::string_view name) const;
  template <class Value>
  void Put(Value value);
  void PutPadding();

  std::vector<std::byte> frame_;
  std::uint32_t array_count_ = 0;
  std::array<NameSpan, kMaxArrays> names_ = {};  ///< array_count_ of them
};

/// Fault in received bytes.
struct WireError {
  std::string message;

  bool operator==(const WireError&) const = default;
};

struct FrameHeader {
  MessageType type = MessageType::kHello;
  std::uint32_t sequence = 0;
  std::uint32_t body_bytes = 0;  ///< at most kMaxBodyBytes
};

/// Decodes and checks magic, type and length. Never throws.
std::variant<FrameHeader, WireError> DecodeHeader(std::span<const std::byte, kHeaderBytes> bytes);

/// Decodes a body with all bounds checked; the arrays lie in `body`. Never throws on any bytes.
std::variant<MessageView, WireError> DecodeBody(const FrameHeader& header,
                                                std::span<const std::byte> body);

/// Decodes header and body of exactly one frame.
std::variant<Message, WireError> DecodeFrame(std::span<const std::byte> frame);

}  // namespace smile::wire
