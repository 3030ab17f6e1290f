#include "xml/internal_precheck.h"

#include <algorithm>
#include <cstddef>

// Checks that must be made before libxml2 sees a file: it collects all attributes of a tag before
// it reports the tag, with a duplicate search that is quadratic in their number, and guesses
// encodings. This scanner is no parser; it only finds tags, in the same way as every parser would.

namespace smile::xml {
namespace {

struct Tag {
  std::size_t begin = 0, end = 0;
  int num_attributes = 0;
};

int LineAt(std::string_view text, std::size_t offset) {
  return 1 + static_cast<int>(std::count(text.begin(), text.begin() + offset, '\n'));
}

/// Returns the offset after the next `mark`, or the end.
std::size_t SkipPast(std::string_view text, std::size_t offset, std::string_view mark) {
  const std::size_t found = text.find(mark, offset);
  return found == std::string_view::npos ? text.size() : found + mark.size();
}

/// Returns the tag at `begin`. Attributes are counted by their `=` outside quotes; `>` inside
/// quotes does not end the tag.
Tag TagAt(std::string_view text, std::size_t begin) {
  Tag tag{.begin = begin, .end = text.size()};
  char quote = 0;
  for (std::size_t offset = begin; offset < text.size(); ++offset) {
    const char letter = text[offset];
    if (quote != 0) {
      if (letter == quote) quote = 0;
    } else if (letter == '"' || letter == '\'') {
      quote = letter;
      // Also counts `=` in faulty tags, which is harmless: it can only refuse more.
    } else if (letter == '=') {
      ++tag.num_attributes;
    } else if (letter == '>') {
      tag.end = offset + 1;
      break;
    }
  }
  return tag;
}

/// Returns the first tag with too many attributes. Comments, CDATA and processing instructions are
/// skipped, as their content is no markup.
std::optional<Tag> FindOverloadedTag(std::string_view text, int max_attributes) {
  std::size_t offset = 0;
  while ((offset = text.find('<', offset)) != std::string_view::npos) {
    const std::string_view rest = text.substr(offset);
    if (rest.starts_with("<!--")) {
      offset = SkipPast(text, offset + 4, "-->");
    } else if (rest.starts_with("<![CDATA[")) {
      offset = SkipPast(text, offset, "]]>");
    } else if (rest.starts_with("<?")) {
      offset = SkipPast(text, offset, "?>");
    } else {
      const Tag tag = TagAt(text, offset);
      if (tag.num_attributes > max_attributes) return tag;
      offset = tag.end;
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<Diagnostic> PrecheckFaultOf(std::string_view text, const std::string& file_name,
                                          const ParseOptions& options) {
  const auto fault = [&](std::size_t offset, const std::string& message) {
    return Diagnostic{file_name, LineAt(text, offset), "", message};
  };
  const Limits& limits = options.limits;
  const std::string expected_root = "expected a <" + std::string(options.root) + "> element";
  if (text.size() > limits.max_bytes) {
    return fault(0, "found " + std::to_string(text.size()) + " bytes, expected at most " +
                        std::to_string(limits.max_bytes));
  }
  if (const std::size_t nul = text.find('\0'); nul != std::string_view::npos) {
    return fault(nul, "found a NUL byte, expected XML text in UTF-8");
  }
  // UTF-16 and other wide encodings fail one of these checks: ASCII text has NUL bytes in them.
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return fault(0, "found an empty file, " + expected_root);
  if (text[first] != '<') {
    return fault(first, "found something that is not XML, " + expected_root);
  }
  if (const std::optional<Tag> tag = FindOverloadedTag(text, limits.max_attributes)) {
    return fault(tag->begin, "found a tag with " + std::to_string(tag->num_attributes) +
                                 " attributes, expected at most " +
                                 std::to_string(limits.max_attributes));
  }
  return std::nullopt;
}

}  // namespace smile::xml
