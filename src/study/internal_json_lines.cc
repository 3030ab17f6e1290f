#include "study/internal_json_lines.h"

#include <algorithm>

namespace smile::study {
namespace {

/// Walks through valid JSON and compares the path of each element with a wanted one.
class Walk {
 public:
  Walk(std::string_view text, std::string_view place) : text_(text), place_(place) {}

  int Line() {
    Value("");
    return 1 + static_cast<int>(std::count(text_.begin(), text_.begin() + best_at_, '\n'));
  }

 private:
  char Peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }

  void SkipBlanks() { at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size()); }

  std::string String() {
    std::string read;
    for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_) {
      // Names of members with escapes are unknown ones, whose place is that of their object.
      if (text_[at_] == '\\') ++at_;
      read += Peek();
    }
    ++at_;
    return read;
  }

  /// Notes where the wanted element, or one around it, begins.
  void Compare(const std::string& path, std::size_t begin) {
    const bool is_around = path.empty() || path == place_ || place_.starts_with(path + "/");
    if (is_around && path.size() >= best_size_) {
      best_size_ = path.size();
      best_at_ = static_cast<std::ptrdiff_t>(begin);
    }
  }

  void Value(const std::string& path) {
    SkipBlanks();
    Compare(path, at_);
    if (Peek() == '{' || Peek() == '[') return Members(path);
    if (Peek() == '"') {
      String();
    } else {
      at_ = std::min(text_.find_first_of(",]} \t\r\n", at_), text_.size());
    }
  }

  void Members(const std::string& path) {
    const bool is_object = text_[at_++] == '{';
    const std::string prefix = path.empty() ? "" : path + "/";
    for (int index = 0; at_ < text_.size(); ++index) {
      SkipBlanks();
      if (Peek() == '}' || Peek() == ']') break;
      std::string name = std::to_string(index);
      if (is_object) {
        const std::size_t begin = at_;
        name = String();
        Compare(prefix + name, begin);
        at_ = std::min(text_.find(':', at_), text_.size()) + 1;
      }
      Value(prefix + name);
      SkipBlanks();
      if (Peek() == ',') ++at_;
    }
    ++at_;
  }

  std::string_view text_, place_;
  std::size_t at_ = 0, best_size_ = 0;
  std::ptrdiff_t best_at_ = 0;
};

}  // namespace

int LineOf(std::string_view text, std::string_view place) { return Walk(text, place).Line(); }

}  // namespace smile::study
