#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

namespace smile::report {

/// Piece of HTML or embedded SVG. Texts enter through Text() and Element() only, and are escaped
/// there, since names of objects and messages of brains are arbitrary.
class Markup {
 public:
  Markup() = default;

  Markup& operator+=(const Markup& other) {
    html_ += other.html_;
    return *this;
  }
  const std::string& html() const { return html_; }
  bool is_empty() const { return html_.empty(); }

 private:
  friend Markup Text(std::string_view text);
  friend Markup Element(
      std::string_view tag,
      std::initializer_list<std::pair<std::string_view, std::string_view>> attributes,
      const Markup& content);

  std::string html_;
};

/// Returns a text, escaped; control characters become `?`.
Markup Text(std::string_view text);

using Attributes = std::initializer_list<std::pair<std::string_view, std::string_view>>;

/// Returns `<tag name="value">content</tag>`. Names of tags and attributes are not escaped, values
/// are.
Markup Element(std::string_view tag, Attributes attributes, const Markup& content = {});
Markup Element(std::string_view tag, Attributes attributes, std::string_view text);

/// Returns a section of a page with a headline.
Markup Section(std::string_view headline, const Markup& content);

/// Returns a link to a file beside the page or below it, by its relative path.
Markup LinkTo(std::string_view relative_path, std::string_view words);

/// Returns a picture embedded in the page.
/// @param png  its bytes.
/// @param words  description for screen readers.
Markup Picture(std::string_view png, std::string_view words);

/// Returns a self-contained page: nothing is fetched, colors follow the reader's choice of light or
/// dark, and it is readable on a phone.
std::string Page(std::string_view title, const Markup& body);

}  // namespace smile::report
