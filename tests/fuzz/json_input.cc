#include "json_input.h"

#include <stdexcept>

#include "base/json.h"

namespace smile::fuzz {

std::string FaultWithJson(std::string_view text) {
  Json json;
  try {
    json = ParseJson(text);
  } catch (const std::invalid_argument& error) {
    return *error.what() == '\0' ? "refused without a reason" : "";
  }
  for (int indent : {-1, 2}) {
    const std::string written = ToText(json, indent);
    try {
      if (ParseJson(written) != json) return "a written value reads differently: " + written;
    } catch (const std::invalid_argument& error) {
      return "a written value is refused: " + std::string(error.what()) + ": " + written;
    }
  }
  return {};
}

}  // namespace smile::fuzz
