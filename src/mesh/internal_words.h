#pragma once

#include <string>
#include <string_view>

namespace smile::mesh {

/// Goes through a text word by word, knowing its line.
class Words {
 public:
  explicit Words(std::string_view text) : rest_(text) {}

  /// The next word of the text; empty at its end.
  std::string_view Next();
  /// The next word of this line; empty at its end.
  std::string_view NextInLine();
  /// Goes on to the next line; false at the end of the text.
  bool NextLine();

  /// @throws BadMesh unless `word` is a number.
  float Number(std::string_view word) const;
  /// @throws BadMesh with the line.
  [[noreturn]] void Fail(const std::string& found, const std::string& expected) const;

 private:
  std::string_view rest_;
  int line_ = 1;
};

/// As people compare words that computers wrote: `FACET` is `facet`.
bool IsSameWord(std::string_view a, std::string_view b);

}  // namespace smile::mesh
