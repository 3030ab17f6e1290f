#include "brain/brain_values.h"

namespace smile::brain {

std::string ToString(const BrainError& error) {
  // The form `file:line: message` is that of compilers; editors and terminals make it a link.
  std::string place = error.file;
  if (!place.empty() && error.line > 0) place += ":" + std::to_string(error.line);
  return place.empty() ? error.message : place + ": " + error.message;
}

}  // namespace smile::brain
