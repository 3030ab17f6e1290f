#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace smile {

/// JSON that keeps the order of keys as written, so that logs and results are readable.
using Json = nlohmann::ordered_json;

inline constexpr int kMaxJsonKeys = 10'000;

/// Parses untrusted JSON: at most 32 levels deep, and 10,000 keys in any one object, each once.
/// @param max_keys  in all objects together.
/// @throws std::invalid_argument with the fault.
Json ParseJson(std::string_view text, int max_keys = kMaxJsonKeys);

/// Returns the text of a value; bytes that are not UTF-8 become replacement characters.
/// @param indent  spaces per level; -1 for one line.
std::string ToText(const Json& json, int indent = -1);

}  // namespace smile
