#pragma once

#include <string>
#include <string_view>

namespace smile::mesh {

/// Reads a text word by word and counts its lines.
class Words {
 public:
  explicit Words(std::string_view text) : rest_(text) {}

  /// Returns the next word of the text; empty at its end.
  std::string_view Next();
  /// Returns the next word of this line; empty at its end.
  std::string_view NextInLine();
  /// Moves to the next line; returns false at the end of the text.
  bool NextLine();

  /// Returns the number that a word spells.
  /// @throws BadMesh unless it is one.
  float Number(std::string_view word) const;
  /// Throws BadMesh with the line.
  [[noreturn]] void Fail(const std::string& found, const std::string& expected) const;

 private:
  std::string_view rest_;
  int line_ = 1;
};

/// Returns true if two words are equal except for the case of ASCII letters.
bool IsSameWord(std::string_view a, std::string_view b);

}  // namespace smile::mesh
