#include "demonstrator/hand.h"

namespace smile::demonstrator {

std::string_view ToString(HandName hand) {
  switch (hand) {
    case HandName::kLeft:
      return "left";
    case HandName::kRight:
      return "right";
    case HandName::kBoth:
      return "both";
    case HandName::kAny:
      return "any";
  }
  return "";
}

std::optional<HandName> ParseHandName(std::string_view text) {
  // One list of words serves both directions.
  for (HandName hand : kHandNames) {
    if (ToString(hand) == text) return hand;
  }
  return std::nullopt;
}

}  // namespace smile::demonstrator
