#pragma once

#include <optional>
#include <string_view>

namespace smile::texts {

/// texts/en.json, compiled into the program: the build writes its definition.
extern const std::string_view kEnglishJson;

/// Returns the English message of an id within `program`; nullopt if there is none.
std::optional<std::string_view> FindEnglish(std::string_view id);

}  // namespace smile::texts
