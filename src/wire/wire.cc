#include "wire/wire.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "base/bytes.h"

// Layout of a message, little-endian: header of 16 bytes (magic, type, sequence number, length of
// the body, each u32); body: number of arrays u32, padding u32, then the arrays. An array: letters
// of its name u8, type u8, number of dimensions u8, flags u8, dimensions u32, name, padding,
// elements, padding. Padding leads to multiples of 8 bytes. Encoder and decoder are both here and
// share their checks.

namespace smile::wire {
namespace {

constexpr std::size_t kAlignment = 8;
/// Flags of an array: its bytes stand for 0 to 1; its elements are in row-major order.
constexpr std::uint8_t kFractionFlag = 1;
constexpr std::uint8_t kRowMajorFlag = 2;

/// Returns the number of bytes up to the next multiple of the alignment.
std::size_t Padding(std::size_t size) { return (kAlignment - size % kAlignment) % kAlignment; }

/// Returns the size of the elements [bytes]; nullopt if it exceeds that of a body.
std::optional<std::size_t> DataBytes(ElementType type, std::span<const std::uint32_t> dims) {
  // A zero anywhere means no elements, however large the other dimensions are.
  if (std::ranges::find(dims, 0u) != dims.end()) return 0;
  std::size_t bytes = ElementBytes(type);
  for (const std::uint32_t dim : dims) {
    // Divides before multiplying, so that nothing overflows.
    if (dim > kMaxBodyBytes / bytes) return std::nullopt;
    bytes *= dim;
  }
  return bytes;
}

/// Returns true for identifiers: letters, digits and `_`, no digit first, of limited length.
bool IsIdentifier(std::string_view name) {
  const auto is_letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  };
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  return !name.empty() && name.size() <= kMaxNameLetters && is_letter(name[0]) &&
         std::ranges::all_of(name, [&](char c) { return is_letter(c) || is_digit(c); });
}

/// Returns the reason why an array cannot be sent; empty if it can. Shared by both directions, so
/// that they agree.
std::string WhyUnfit(std::string_view name, ElementType type, std::uint8_t flags,
                     std::span<const std::uint32_t> dims) {
  if (!IsIdentifier(name)) return "an array's name is not an identifier";
  const auto array_that = [name](const std::string& what) {
    return "array '" + std::string(name) + "' " + what;
  };
  if (type > ElementType::kText) return array_that("has an unknown element type");
  const int known_flags = kRowMajorFlag | (type == ElementType::kByte ? kFractionFlag : 0);
  // Only bytes can stand for fractions.
  if (flags & ~known_flags) return array_that("has unknown flags");
  // At least two, as all arrays of Octave have.
  if (dims.size() < 2 || dims.size() > kMaxDimensions) {
    return array_that("has " + std::to_string(dims.size()) + " dimensions, expected 2 to " +
                      std::to_string(kMaxDimensions));
  }
  if (!DataBytes(type, dims)) return array_that("is too large: " + ShapeText(dims));
  return {};
}

/// Skips the padding; alignment counts from the begin of the body.
void SkipPadding(ByteReader& reader, std::size_t body_bytes) {
  reader.GetBytes(Padding(body_bytes - reader.remaining()));
}

/// Decodes the next array. Its elements stay in the body.
std::variant<ArrayView, WireError> DecodeArray(ByteReader& reader, std::size_t body_bytes) {
  ArrayView array;
  const auto name_letters = reader.Get<std::uint8_t>();
  array.type = reader.Get<ElementType>();
  const auto dim_count = reader.Get<std::uint8_t>();
  const auto flags = reader.Get<std::uint8_t>();
  std::array<std::uint32_t, 255> room;  // maximum of an 8-bit count
  const std::span<std::uint32_t> dims = std::span(room).first(dim_count);
  for (std::uint32_t& dim : dims) dim = reader.Get<std::uint32_t>();
  const std::span<const std::byte> letters = reader.GetBytes(name_letters);
  array.name = {reinterpret_cast<const char*>(letters.data()), letters.size()};
  // Elements begin at multiples of 8 bytes, so that doubles can be read in place.
  SkipPadding(reader, body_bytes);
  // Reading beyond the end returns zeros, so one check suffices for the whole head.
  if (!reader.ok()) return WireError{"the body ends inside an array's head"};

  const std::string unfit = WhyUnfit(array.name, array.type, flags, dims);
  if (!unfit.empty()) return WireError{unfit};
  array.is_fraction = (flags & kFractionFlag) != 0;
  array.is_row_major = (flags & kRowMajorFlag) != 0;
  std::ranges::copy(dims, array.all_dims.begin());
  array.dim_count = dim_count;

  array.data = reader.GetBytes(*DataBytes(array.type, dims));
  SkipPadding(reader, body_bytes);
  if (!reader.ok())
    return WireError{"the body ends inside array '" + std::string(array.name) + "'"};
  return array;
}

}  // namespace

std::size_t ElementBytes(ElementType type) { return type == ElementType::kDouble ? 8 : 1; }

void CopyToRowMajor(std::span<const std::uint32_t> dims, std::size_t element_bytes,
                    std::span<const std::byte> from, std::span<std::byte> to) {
  std::array<std::size_t, kMaxDimensions> index = {};
  // Source offset of the element with this index; the source is in column-major order.
  std::size_t at = 0;
  for (std::size_t k = 0; k < to.size(); k += element_bytes) {
    std::memcpy(&to[k], &from[at], element_bytes);
    // Advances the last dimension; at its end returns to 0 there and advances the one before.
    // The stride of the last dimension is the largest in column-major order.
    std::size_t stride = from.size();
    for (std::size_t d = dims.size(); d-- > 0;) {
      stride /= dims[d];
      at += stride;
      if (++index[d] < dims[d]) break;
      at -= stride * dims[d];
      index[d] = 0;
    }
  }
}

std::string ShapeText(std::span<const std::uint32_t> dims) {
  std::string text;
  for (const std::uint32_t dim : dims) text += (text.empty() ? "" : "x") + std::to_string(dim);
  return text;
}

std::optional<std::vector<double>> NamedArray::Numbers() const {
  if (type == ElementType::kText) return std::nullopt;
  std::vector<double> numbers(data.size() / ElementBytes(type));
  if (type == ElementType::kDouble) {
    if (!numbers.empty()) std::memcpy(numbers.data(), data.data(), data.size());
    return numbers;
  }
  // A fraction is a byte divided by 255.
  const double scale = is_fraction ? 255.0 : 1.0;
  std::ranges::transform(data, numbers.begin(),
                         [scale](std::byte value) { return std::to_integer<int>(value) / scale; });
  return numbers;
}

std::optional<std::string> NamedArray::Text() const {
  if (type != ElementType::kText) return std::nullopt;
  return std::string(reinterpret_cast<const char*>(data.data()), data.size());
}

Message Copied(const MessageView& view) {
  Message message{.type = view.type, .sequence = view.sequence, .arrays = {}};
  message.arrays.reserve(view.arrays.size());
  for (const ArrayView& array : view.arrays) {
    message.arrays.push_back({.name = std::string(array.name),
                              .type = array.type,
                              .is_fraction = array.is_fraction,
                              .is_row_major = array.is_row_major,
                              .dims = {array.dims().begin(), array.dims().end()},
                              .data = {array.data.begin(), array.data.end()}});
  }
  return message;
}

std::string Message::TextOf(std::string_view name) const {
  const NamedArray* array = Find(name);
  return array ? array->Text().value_or("") : "";
}

const NamedArray* Message::Find(std::string_view name) const {
  const auto found = std::ranges::find(arrays, name, &NamedArray::name);
  return found == arrays.end() ? nullptr : &*found;
}

MessageWriter::MessageWriter(MessageType type, std::uint32_t sequence, std::size_t expected_bytes) {
  frame_.reserve(kHeaderBytes + std::min(expected_bytes, kMaxBodyBytes));
  Put(kMagic);
  Put(type);
  Put(sequence);
  Put(std::uint32_t{0});  // length of the body, known at the end
  Put(std::uint32_t{0});  // number of arrays, known at the end
  Put(std::uint32_t{0});
}

template <class Value>
void MessageWriter::Put(Value value) {
  const auto* bytes = reinterpret_cast<const std::byte*>(&value);
  frame_.insert(frame_.end(), bytes, bytes + sizeof value);
}

// The header's size is a multiple of the alignment, so this aligns elements in the body, too.
void MessageWriter::PutPadding() { frame_.resize(frame_.size() + Padding(frame_.size())); }

bool MessageWriter::HasArray(std::string_view name) const {
  return std::any_of(names_.begin(), names_.begin() + array_count_, [&](const NameSpan& place) {
    return place.letters == name.size() &&
           std::memcmp(&frame_[place.begin], name.data(), name.size()) == 0;
  });
}

void MessageWriter::AddDoubles(std::string_view name, std::span<const std::uint32_t> dims,
                               std::span<const double> values) {
  if (DataBytes(ElementType::kDouble, dims) != values.size_bytes()) {
    throw std::invalid_argument("message array '" + std::string(name) +
                                "': " + std::to_string(values.size()) + " values do not make a " +
                                ShapeText(dims));
  }
  const std::span<std::byte> space = AddSpace(name, ElementType::kDouble, false, dims);
  if (!space.empty()) std::memcpy(space.data(), values.data(), space.size());
}

void MessageWriter::AddScalar(std::string_view name, double value) {
  AddDoubles(name, std::array{1u, 1u}, {&value, 1});
}

void MessageWriter::AddLogical(std::string_view name, bool value) {
  AddSpace(name, ElementType::kLogical, false, std::array{1u, 1u})[0] = std::byte{value};
}

void MessageWriter::AddText(std::string_view name, std::string_view text) {
  if (text.size() > kMaxBodyBytes) throw std::invalid_argument("message text is too long");
  const std::array dims{1u, static_cast<std::uint32_t>(text.size())};
  std::ranges::copy(std::as_bytes(std::span(text)),
                    AddSpace(name, ElementType::kText, false, dims).begin());
}

void MessageWriter::AddArray(const NamedArray& array) {
  const auto space =
      AddSpace(array.name, array.type, array.is_fraction, array.dims, array.is_row_major);
  if (space.size() != array.data.size()) {
    throw std::invalid_argument("message array '" + array.name + "': data does not make a " +
                                ShapeText(array.dims));
  }
  std::ranges::copy(array.data, space.begin());
}

std::span<std::byte> MessageWriter::AddSpace(std::string_view name, ElementType type,
                                             bool is_fraction, std::span<const std::uint32_t> dims,
                                             bool is_row_major) {
  const auto flags = static_cast<std::uint8_t>((is_fraction ? kFractionFlag : 0) |
                                               (is_row_major ? kRowMajorFlag : 0));
  std::string unfit = WhyUnfit(name, type, flags, dims);
  if (HasArray(name)) unfit = "is there twice";
  if (array_count_ == kMaxArrays) unfit = "exceeds the maximum number of arrays";
  if (!unfit.empty()) {
    throw std::invalid_argument("message array '" + std::string(name) + "': " + unfit);
  }

  Put(static_cast<std::uint8_t>(name.size()));
  Put(type);
  Put(static_cast<std::uint8_t>(dims.size()));
  Put(flags);
  for (const std::uint32_t dim : dims) Put(dim);
  names_[array_count_++] = {.begin = static_cast<std::uint32_t>(frame_.size()),
                            .letters = static_cast<std::uint32_t>(name.size())};
  const auto letters = std::as_bytes(std::span(name));
  frame_.insert(frame_.end(), letters.begin(), letters.end());
  PutPadding();

  // The caller writes the elements into this space, without a copy in between.
  const std::size_t begin = frame_.size();
  const std::size_t size = *DataBytes(type, dims);
  frame_.resize(begin + size + Padding(size));
  if (frame_.size() - kHeaderBytes > kMaxBodyBytes) {
    throw std::invalid_argument("message array '" + std::string(name) + "': body is too large");
  }
  return std::span(frame_).subspan(begin, size);
}

std::vector<std::byte> MessageWriter::Finish() {
  const auto body_bytes = static_cast<std::uint32_t>(frame_.size() - kHeaderBytes);
  // Offset 12 is the length field of the header; the number of arrays is the first field of the
  // body.
  std::memcpy(&frame_[12], &body_bytes, sizeof body_bytes);
  std::memcpy(&frame_[kHeaderBytes], &array_count_, sizeof array_count_);
  return std::move(frame_);
}

std::variant<FrameHeader, WireError> DecodeHeader(std::span<const std::byte, kHeaderBytes> bytes) {
  ByteReader reader(bytes);
  if (reader.Get<std::uint32_t>() != kMagic)
    return WireError{"the received bytes are not a message"};
  FrameHeader header;
  header.type = reader.Get<MessageType>();
  header.sequence = reader.Get<std::uint32_t>();
  header.body_bytes = reader.Get<std::uint32_t>();
  if (header.type < MessageType::kHello || header.type > MessageType::kBye) {
    return WireError{"unknown message type " +
                     std::to_string(static_cast<std::uint32_t>(header.type))};
  }
  // Checked before the body is received, as no memory must be reserved for a faulty length.
  if (header.body_bytes > kMaxBodyBytes) {
    return WireError{"a message of " + std::to_string(header.body_bytes) +
                     " bytes, expected at most " + std::to_string(kMaxBodyBytes)};
  }
  return header;
}

std::variant<MessageView, WireError> DecodeBody(const FrameHeader& header,
                                                std::span<const std::byte> body) {
  if (body.size() != header.body_bytes) return WireError{"the body length differs from the header"};
  ByteReader reader(body);
  const auto count = reader.Get<std::uint32_t>();
  reader.Get<std::uint32_t>();
  if (!reader.ok()) return WireError{"the body ends before its first array"};
  if (count > kMaxArrays) return WireError{std::to_string(count) + " arrays in one message"};

  MessageView message{.type = header.type, .sequence = header.sequence, .arrays = {}};
  message.arrays.reserve(count);
  for (std::uint32_t k = 0; k < count; ++k) {
    auto decoded = DecodeArray(reader, body.size());
    if (auto* error = std::get_if<WireError>(&decoded)) return std::move(*error);
    const auto& array = std::get<ArrayView>(decoded);
    // Names must be unique, as receivers look arrays up by name.
    const bool is_double = std::any_of(message.arrays.begin(), message.arrays.end(),
                                       [&](const ArrayView& it) { return it.name == array.name; });
    if (is_double) return WireError{"array '" + std::string(array.name) + "' appears twice"};
    message.arrays.push_back(array);
  }
  // A strict check: both sides must agree on the length to the last byte.
  if (reader.remaining() > 0) return WireError{"bytes are left over after the last array"};
  return message;
}

std::variant<Message, WireError> DecodeFrame(std::span<const std::byte> frame) {
  if (frame.size() < kHeaderBytes) return WireError{"the frame ends inside its header"};
  const auto header = DecodeHeader(frame.first<kHeaderBytes>());
  if (const auto* error = std::get_if<WireError>(&header)) return *error;
  auto body = DecodeBody(std::get<FrameHeader>(header), frame.subspan(kHeaderBytes));
  if (auto* error = std::get_if<WireError>(&body)) return std::move(*error);
  return Copied(std::get<MessageView>(body));
}

}  // namespace smile::wire
