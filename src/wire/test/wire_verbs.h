#pragma once

#include <gtest/gtest.h>

#include <array>
#include <span>

#include "wire/wire.h"

namespace smile::wire {

/// The shape of anything that has a value for every joint of both arms.
inline constexpr std::array kTwoBySeven{2u, 7u};

/// A frame that must be right, decoded.
inline Message Decoded(std::span<const std::byte> frame) {
  auto decoded = DecodeFrame(frame);
  if (const auto* error = std::get_if<WireError>(&decoded)) ADD_FAILURE() << error->message;
  return std::get<Message>(decoded);
}

}  // namespace smile::wire
