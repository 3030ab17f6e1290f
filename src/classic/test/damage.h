#pragma once

#include <algorithm>
#include <random>
#include <string>
#include <string_view>

namespace smile::classic {

/// What happens to texts: letters change, lines vanish, come twice or in another order.
inline void Damage(std::string* damaged, std::mt19937* random) {
  std::string& text = *damaged;
  if (text.empty()) return;
  const std::size_t at = (*random)() % text.size();
  const std::size_t line = text.rfind('\n', at) + 1;
  const std::size_t size = std::min(text.find('\n', at), text.size() - 1) + 1 - line;
  constexpr std::string_view kLetters = ",\\\n0919E-.aCup\xff";
  switch ((*random)() % 5) {
    case 0:
      text[at] = kLetters[(*random)() % kLetters.size()];
      return;
    case 1:
      text.insert(at, 1, kLetters[(*random)() % kLetters.size()]);
      return;
    case 2:
      text.erase(at, 1);
      return;
    case 3:
      text.erase(line, size);
      return;
    default:
      text += text.substr(line, size);
  }
}

}  // namespace smile::classic
