#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

namespace smile::report {

/// A piece of HTML, or of SVG within it. Texts come in through Text() and Element() only, and are
/// escaped there: names of objects and messages of robot programs may be anything.
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

/// `A & B` as itself; control characters become `?`.
Markup Text(std::string_view text);

using Attributes = std::initializer_list<std::pair<std::string_view, std::string_view>>;

/// `<tag name="value">content</tag>`; names of tags and attributes are our own, values anybody's.
Markup Element(std::string_view tag, Attributes attributes, const Markup& content = {});
Markup Element(std::string_view tag, Attributes attributes, std::string_view text);

/// A piece of a page with a headline.
Markup Section(std::string_view headline, const Markup& content);

/// A link to a file beside the page or below it, by its path from there.
Markup LinkTo(std::string_view relative_path, std::string_view words);

/// A picture that travels within the page.
/// @param png  its bytes.
/// @param words  what it shows, for those who do not see it.
Markup Picture(std::string_view png, std::string_view words);

/// A whole page that stands for itself: nothing is fetched from anywhere, colors follow the
/// reader's choice of light or dark, and it is readable on a telephone.
std::string Page(std::string_view title, const Markup& body);

}  // namespace smile::report
