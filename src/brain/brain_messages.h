#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "brain/brain_values.h"
#include "wire/wire.h"

/// The values of brain_values.h as messages, under the names used in scripts. Reading checks names,
/// shapes and numbers; a WireError names the variable, what was found and what was expected.
namespace smile::brain {

using wire::ElementType;
using wire::kMaxBodyBytes;
using wire::Message;
using wire::MessageType;
using wire::MessageWriter;
using wire::NamedArray;
using wire::ShapeText;
using wire::WireError;

/// Limit of all pictures in one message; the rest is for names and numbers.
inline constexpr std::size_t kMaxPictureBytes = kMaxBodyBytes - (std::size_t{12} << 20);

/// Encodes the fields of `aux`; `path` ends in `/`.
/// @throws std::invalid_argument if the camera is larger than a message.
std::vector<std::byte> EncodeAux(std::uint32_t sequence, const Aux& aux, std::string_view path,
                                 std::string_view robot = "");

/// Order of the pixels of a picture in a message. (Matlab's images are columns, cameras give rows.)
enum class PixelOrder { kColumns, kRows };

/// Encodes the fields of `sensor`.
/// @throws std::invalid_argument if a channel of a picture does not have its size, or a name
///         contains a line break.
std::vector<std::byte> EncodeSensor(std::uint32_t sequence, const Sensor& sensor,
                                    PixelOrder order = PixelOrder::kColumns);

/// Decodes the reply to init.
/// @param aux  as sent: the reply may request only what it offers.
std::variant<InitReply, WireError> DecodeInitReply(const Message& message, const Aux& aux);

/// Decodes kMotor or kFinalMotor.
/// @param arms     as sent in Aux.
/// @param cameras  as requested in the reply to init: the reply may choose among them.
std::variant<StepReply, WireError> DecodeStepReply(const Message& message,
                                                   std::span<const ArmDescription> arms,
                                                   std::span<const std::string> cameras = {});

/// Decodes kError; its file is as the brain named it.
BrainError DecodeError(const Message& message);

/// Limit of a text that a brain makes the simulator print or record, as in an error or a note.
inline constexpr std::size_t kMaxErrorLetters = 2'000;

/// Returns text from a brain, safe for a terminal: control characters replaced, cut after
/// `max_letters`.
std::string PrintableText(std::string_view text, std::size_t max_letters);

}  // namespace smile::brain
