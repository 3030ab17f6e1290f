#include "robot/internal_tag_scan.h"

#include <algorithm>

#include "base/diagnostic.h"
#include "base/wording.h"

namespace smile::robot::internal {
namespace {

constexpr std::size_t kMaxDepth = 32;
constexpr std::size_t kMaxTags = 50'000;
// The parser compares each attribute with all others of its element.
constexpr std::size_t kMaxAttributes = 32;
constexpr std::string_view kBlanks = " \t\r\n";

class TagScanner {
 public:
  TagScanner(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  std::vector<XmlTag> Scan() {
    if (const auto nul = text_.find('\0'); nul != std::string_view::npos) {
      MoveTo(nul);
      Fail("found a zero byte, expected XML text");
    }
    for (auto next = text_.find('<'); next != std::string_view::npos; next = text_.find('<', at_)) {
      MoveTo(next);
      ReadMarkup();
    }
    if (!open_.empty()) Fail("the file ends before " + Quoted(open_.back()) + " does");
    return std::move(tags_);
  }

 private:
  void ReadMarkup() {
    if (StartsWith("<!--")) {
      MoveTo(at_ + 4);
      return SkipPast("-->", "comment");
    }
    if (StartsWith("<!")) Fail("found a document type or CDATA, expected elements and comments");
    if (StartsWith("<?")) {
      if (!tags_.empty()) Fail("found a declaration, expected it before the first element");
      return SkipPast("?>", "declaration");
    }
    if (StartsWith("</")) return ReadEndTag();
    ReadStartTag();
  }

  void ReadEndTag() {
    MoveTo(at_ + 2);
    const std::string element = ReadName("element");
    if (open_.empty() || open_.back() != element) {
      Fail("found the end of " + Quoted(element) + ", expected that of " +
           (open_.empty() ? "nothing" : Quoted(open_.back())));
    }
    open_.pop_back();
    SkipBlanks();
    if (!StartsWith(">")) Fail("the end tag of " + Quoted(element) + " does not end");
    MoveTo(at_ + 1);
  }

  void ReadStartTag() {
    XmlTag tag{.line = line_, .depth = static_cast<int>(open_.size())};
    MoveTo(at_ + 1);
    tag.element = ReadName("element");
    while (true) {
      SkipBlanks();
      if (StartsWith("/>")) {
        MoveTo(at_ + 2);
        break;
      }
      if (StartsWith(">")) {
        MoveTo(at_ + 1);
        open_.push_back(tag.element);
        break;
      }
      tag.attributes.push_back(ReadAttribute());
      if (tag.attributes.size() > kMaxAttributes) {
        Fail("found more than " + std::to_string(kMaxAttributes) + " attributes");
      }
    }
    tags_.push_back(std::move(tag));
    if (tags_.size() > kMaxTags) {
      Fail("found more than " + std::to_string(kMaxTags) + " elements");
    }
    if (open_.size() > kMaxDepth) {
      Fail("elements are nested deeper than " + std::to_string(kMaxDepth) + " levels");
    }
  }

  std::pair<std::string, std::string> ReadAttribute() {
    std::string name = ReadName("attribute");
    SkipBlanks();
    if (!StartsWith("=")) Fail("attribute " + Quoted(name) + " has no value");
    MoveTo(at_ + 1);
    SkipBlanks();
    if (!StartsWith("\"") && !StartsWith("'"))
      Fail("the value of " + Quoted(name) + " is not in quotes");
    const auto end = text_.find(text_[at_], at_ + 1);
    const std::string_view value = text_.substr(at_ + 1, end - at_ - 1);
    if (end == std::string_view::npos || value.find('<') != std::string_view::npos) {
      Fail("the value of " + Quoted(name) + " does not end");
    }
    MoveTo(end + 1);
    return {std::move(name), std::string(value)};
  }

  std::string ReadName(const char* what) {
    const auto end = std::min(text_.find_first_of(" \t\r\n=/<>\"'", at_), text_.size());
    if (end == at_) Fail(std::string("expected the name of an ") + what);
    std::string name(text_.substr(at_, end - at_));
    MoveTo(end);
    return name;
  }

  void SkipBlanks() { MoveTo(std::min(text_.find_first_not_of(kBlanks, at_), text_.size())); }

  void SkipPast(std::string_view mark, const std::string& what) {
    const auto found = text_.find(mark, at_);
    if (found == std::string_view::npos) Fail("the " + what + " does not end");
    MoveTo(found + mark.size());
  }

  bool StartsWith(std::string_view mark) const { return text_.substr(at_).starts_with(mark); }

  /// Goes forward and counts lines on the way.
  void MoveTo(std::size_t at) {
    line_ += static_cast<int>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(at_),
                                         text_.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
    at_ = at;
  }

  [[noreturn]] void Fail(const std::string& message) const {
    throw InputError(Diagnostic{.file = file_, .line = line_, .message = message});
  }

  std::string_view text_;
  const std::string& file_;
  std::size_t at_ = 0;
  int line_ = 1;
  std::vector<std::string> open_;  ///< elements that have not ended
  std::vector<XmlTag> tags_;
};

}  // namespace

std::string_view XmlTag::Attribute(std::string_view name) const {
  const auto found =
      std::ranges::find(attributes, name, &std::pair<std::string, std::string>::first);
  return found == attributes.end() ? std::string_view() : std::string_view(found->second);
}

std::vector<XmlTag> ScanTags(std::string_view text, const std::string& file) {
  return TagScanner(text, file).Scan();
}

}  // namespace smile::robot::internal
