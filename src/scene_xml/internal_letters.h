#pragma once

namespace smile::scene_xml {

inline bool IsDigit(char letter) { return letter >= '0' && letter <= '9'; }

/// True for letters allowed in ids: A-Z, a-z, digits and `_`.
inline bool IsIdLetter(char letter) {
  return IsDigit(letter) || (letter >= 'A' && letter <= 'Z') || (letter >= 'a' && letter <= 'z') ||
         letter == '_';
}

}  // namespace smile::scene_xml
