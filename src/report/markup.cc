#include "report/markup.h"

#include <algorithm>
#include <array>

#include "report/internal_style.h"

// The only way to make HTML in this room: text is escaped when it becomes Markup, and Markup cannot
// be made of a plain string otherwise. Names and messages come from files of strangers.

namespace smile::report {
namespace {

/// Void elements of HTML, which have no end tag.
constexpr std::array<std::string_view, 2> kWithoutEnd{"meta", "img"};

/// Escapes a text for HTML content and attribute values.
std::string Escaped(std::string_view text) {
  std::string html;
  for (char letter : text) {
    switch (letter) {
      case '&':
        html += "&amp;";
        break;
      case '<':
        html += "&lt;";
        break;
      case '>':
        html += "&gt;";
        break;
      case '"':
        html += "&quot;";
        break;
      case '\'':
        html += "&#39;";
        break;
      case '\n':
        html += '\n';
        break;
      default: {
        const auto code = static_cast<unsigned char>(letter);
        // Control characters are not allowed in HTML, even as references.
        html += code < 0x20 || code == 0x7f ? '?' : letter;
      }
    }
  }
  return html;
}

/// Returns a path as part of a URL (RFC 3986): all bytes but unreserved ones and `/` are encoded.
std::string PercentEncoded(std::string_view path) {
  constexpr std::string_view kPlain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~/";
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string url;
  for (char letter : path) {
    if (kPlain.find(letter) != std::string_view::npos) {
      url += letter;
    } else {
      const auto code = static_cast<unsigned char>(letter);
      (url += '%') += kDigits[code >> 4];
      url += kDigits[code & 15];
    }
  }
  return url;
}

/// Returns bytes in base64 (RFC 4648), with padding.
std::string Base64Of(std::string_view bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    // Three bytes are four digits of six bits; missing bytes count as zero and become padding.
    unsigned group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += k <= count ? kDigits[group >> (18 - 6 * k) & 63] : '=';
    }
  }
  return text;
}

}  // namespace

Markup Text(std::string_view text) {
  Markup markup;
  markup.html_ = Escaped(text);
  return markup;
}

Markup Element(std::string_view tag, Attributes attributes, const Markup& content) {
  Markup markup;
  (markup.html_ += '<') += tag;
  for (const auto& [name, value] : attributes) {
    ((markup.html_ += ' ') += name) += "=\"";
    (markup.html_ += Escaped(value)) += '"';
  }
  markup.html_ += '>';
  // An end tag for these would be an error of the page.
  if (std::ranges::find(kWithoutEnd, tag) != kWithoutEnd.end()) return markup;
  markup += content;
  ((markup.html_ += "</") += tag) += '>';
  return markup;
}

Markup Element(std::string_view tag, Attributes attributes, std::string_view text) {
  return Element(tag, attributes, Text(text));
}

Markup Section(std::string_view headline, const Markup& content) {
  Markup inside = Element("h2", {}, headline);
  inside += content;
  return Element("section", {}, inside);
}

Markup LinkTo(std::string_view relative_path, std::string_view words) {
  // `./` prevents a first folder with a colon from being taken for a protocol.
  return Element("a", {{"href", "./" + PercentEncoded(relative_path)}}, words);
}

Markup Picture(std::string_view png, std::string_view words) {
  return Element("img", {{"src", "data:image/png;base64," + Base64Of(png)}, {"alt", words}});
}

std::string Page(std::string_view title, const Markup& body) {
  Markup head = Element("meta", {{"charset", "utf-8"}});
  head +=
      Element("meta", {{"name", "viewport"}, {"content", "width=device-width, initial-scale=1"}});
  head += Element("meta", {{"name", "color-scheme"}, {"content", "light dark"}});
  // Defense in depth, whatever a name or message contains: the page runs no scripts and fetches
  // nothing.
  head += Element("meta",
                  {{"http-equiv", "Content-Security-Policy"},
                   {"content", "default-src 'none'; img-src data:; style-src 'unsafe-inline'"}});
  head += Element("title", {}, title);
  head += Element("style", {}, kStyle);
  Markup page = Element("head", {}, head);
  page += Element("body", {}, Element("main", {}, body));
  return "<!DOCTYPE html>\n" + Element("html", {{"lang", "en"}}, page).html() + "\n";
}

}  // namespace smile::report
