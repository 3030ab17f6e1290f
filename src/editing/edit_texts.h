#pragma once

#include <span>
#include <string>

#include "editing/edit.h"

namespace smile::editing {

/// Option of `smile edit` for one kind of edit.
struct EditOption {
  const char* name;
  const char* form;     ///< of its value
  const char* meaning;  ///< for the help
  /// @throws std::invalid_argument with what was found and expected.
  Edit (*parse)(const std::string& text);
};

std::span<const EditOption> AllEditOptions();

}  // namespace smile::editing
