#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace smile::xml {

/// Writer of indented elements, as one appends them. Names are written as they are given; values
/// may be any text.
class Writer {
 public:
  Writer() : text_("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n") {}

  void Open(std::string_view name);
  void Close();
  /// Writes text as the only content of the present element.
  void Text(std::string_view text);
  /// Writes an element that contains only text.
  void TextElement(std::string_view name, std::string_view text);
  /// Writes a comment. Two hyphens, which would end the comment or break it, are separated.
  void Comment(std::string_view text);

  // Attributes of the element opened last, before it gets content.
  void Attribute(std::string_view name, std::string_view value);
  void Boolean(std::string_view name, bool value);
  void Count(std::string_view name, int value);
  void Number(std::string_view name, double value);

  std::string Take() { return std::move(text_); }

 private:
  void Indent();
  /// Ends the tag opened last, before content is written into its element.
  void EndTag();

  std::vector<std::string> open_;
  bool is_tag_open_ = false;
  bool has_text_ = false;  ///< the present element is text, and ends on the same line
  std::string text_;
};

}  // namespace smile::xml
