#include "xml/writer.h"

#include "base/wording.h"

namespace smile::xml {
namespace {

std::string Escaped(std::string_view text) {
  std::string escaped;
  for (char letter : text) {
    switch (letter) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      // Parsers normalize these to blanks inside attributes.
      case '\t':
        escaped += "&#9;";
        break;
      case '\n':
        escaped += "&#10;";
        break;
      case '\r':
        escaped += "&#13;";
        break;
      default:
        escaped += letter;
    }
  }
  return escaped;
}

}  // namespace

void Writer::Open(std::string_view name) {
  EndTag();
  Indent();
  text_ += "<" + std::string(name);
  open_.emplace_back(name);
  is_tag_open_ = true;
}

void Writer::Close() {
  const std::string name = std::move(open_.back());
  open_.pop_back();
  if (is_tag_open_) {
    text_ += "/>\n";
  } else {
    if (!has_text_) Indent();
    text_ += "</" + name + ">\n";
  }
  is_tag_open_ = has_text_ = false;
}

void Writer::Text(std::string_view text) {
  text_ += ">" + Escaped(text);
  is_tag_open_ = false;
  has_text_ = true;
}

void Writer::TextElement(std::string_view name, std::string_view text) {
  Open(name);
  Text(text);
  Close();
}

void Writer::Comment(std::string_view text) {
  EndTag();
  Indent();
  text_ += "<!-- ";
  for (char letter : text) {
    // Two hyphens must not stand together inside an XML comment.
    if (letter == '-' && text_.back() == '-') text_ += ' ';
    text_ += static_cast<unsigned char>(letter) < 0x20 ? '?' : letter;
  }
  text_ += " -->\n";
}

void Writer::Attribute(std::string_view name, std::string_view value) {
  text_ += " " + std::string(name) + "=\"" + Escaped(value) + "\"";
}

void Writer::Boolean(std::string_view name, bool value) {
  Attribute(name, value ? "true" : "false");
}

void Writer::Count(std::string_view name, int value) { Attribute(name, std::to_string(value)); }
void Writer::Number(std::string_view name, double value) { Attribute(name, NumberText(value)); }
void Writer::Indent() { text_.append(2 * open_.size(), ' '); }

void Writer::EndTag() {
  // The tag stays open until it is known whether the element has content.
  if (is_tag_open_) text_ += ">\n";
  is_tag_open_ = false;
}

}  // namespace smile::xml
