#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "page/request_fields.h"

// Fields of requests about the pictures of datasets and films, as arguments of programs.

namespace smile::datasets {

/// Cameras of a robot, and views for people.
inline constexpr std::array<std::string_view, 8> kCameras{"eye",   "head", "close", "nice",
                                                          "front", "left", "right", "top"};
/// Frames per second that divide the ticks of a second.
inline constexpr std::array<std::uint64_t, 12> kRates{1, 2, 3, 4, 5, 6, 10, 12, 15, 20, 30, 60};

/// Returns a whole number of a field.
/// @throws page::RequestError if it is not from `low` to `high`.
std::uint64_t WholeFrom(const page::RequestFields& fields, const char* name, std::uint64_t low,
                        std::uint64_t high);
/// Returns `width` and `height` as `320x240` [pixels].
/// @throws page::RequestError if one is missing or not from 16 to 1920.
std::string SizeArgument(const page::RequestFields& fields);
/// Returns `rate`, in frames per second.
/// @throws page::RequestError if it is missing or none of kRates.
std::string RateArgument(const page::RequestFields& fields);

}  // namespace smile::datasets
