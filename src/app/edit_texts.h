#pragma once

#include <span>
#include <string>

#include "editing/edit.h"

namespace smile::app {

/// An option of `smile edit` that stands for one edit.
struct EditOption {
  const char* name;
  const char* form;     ///< of its value
  const char* meaning;  ///< for the help
  /// @throws std::invalid_argument saying what was found and expected.
  editing::Edit (*parse)(const std::string& text);
};

std::span<const EditOption> AllEditOptions();

}  // namespace smile::app
