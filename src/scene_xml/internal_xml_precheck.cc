#include "scene_xml/internal_xml_precheck.h"

#include <algorithm>
#include <cstddef>
#include <string>

namespace smile::scene_xml {
namespace {

int LineAt(std::string_view text, std::size_t offset) {
  return 1 + static_cast<int>(std::count(text.begin(), text.begin() + offset, '\n'));
}

/// The offset behind the next `mark`, or the end.
std::size_t SkipPast(std::string_view text, std::size_t offset, std::string_view mark) {
  const std::size_t found = text.find(mark, offset);
  return found == std::string_view::npos ? text.size() : found + mark.size();
}

/// Steps over the tag at `offset` and counts its attributes by their `=` outside quotes.
std::size_t SkipTag(std::string_view text, std::size_t offset, int* num_attributes) {
  *num_attributes = 0;
  char quote = 0;
  for (; offset < text.size(); ++offset) {
    const char letter = text[offset];
    if (quote != 0) {
      if (letter == quote) quote = 0;
    } else if (letter == '"' || letter == '\'') {
      quote = letter;
    } else if (letter == '=') {
      ++*num_attributes;
    } else if (letter == '>') {
      return offset + 1;
    }
  }
  return text.size();
}

bool HasOverloadedTag(std::string_view text, int file, const SceneLimits& limits,
                      Findings* findings) {
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
      int num_attributes = 0;
      const std::size_t end = SkipTag(text, offset, &num_attributes);
      if (num_attributes > limits.max_attributes) {
        findings->Add({file, LineAt(text, offset)}, "",
                      "found a tag with " + std::to_string(num_attributes) +
                          " attributes, expected at most " + std::to_string(limits.max_attributes));
        return true;
      }
      offset = end;
    }
  }
  return false;
}

}  // namespace

bool PassesPrecheck(std::string_view text, int file, const SceneLimits& limits,
                    Findings* findings) {
  if (text.size() > limits.max_file_bytes) {
    findings->Add({file, 1}, "",
                  "found " + std::to_string(text.size()) + " bytes, expected at most " +
                      std::to_string(limits.max_file_bytes));
    return false;
  }
  if (const std::size_t nul = text.find('\0'); nul != std::string_view::npos) {
    findings->Add({file, LineAt(text, nul)}, "", "found a NUL byte, expected XML text in UTF-8");
    return false;
  }
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) {
    findings->Add({file, 1}, "", "found an empty file, expected a <tabletop> element");
    return false;
  }
  if (text[first] != '<') {
    findings->Add({file, LineAt(text, first)}, "",
                  "found something that is not XML, expected a <tabletop> element");
    return false;
  }
  return !HasOverloadedTag(text, file, limits, findings);
}

}  // namespace smile::scene_xml
