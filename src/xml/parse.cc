#include "xml/parse.h"

#include <libxml/parser.h>
#include <libxml/parserInternals.h>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <memory>
#include <utility>

#include "base/wording.h"
#include "xml/internal_precheck.h"

// XML files to bounded trees, for scenes and robot descriptions. libxml2 does the syntax; its
// events are counted against our limits while they arrive, so a hostile file costs neither memory
// nor time beyond them. After the first fault that makes the tree useless, parsing stops.

namespace smile::xml {
namespace {

// Namespaces of attributes that tools add to any file and that do not concern its content.
constexpr std::string_view kXsiNamespace = "http://www.w3.org/2001/XMLSchema-instance";
constexpr std::string_view kXmlNamespace = "http://www.w3.org/XML/1998/namespace";

std::string_view View(const xmlChar* text) {
  return text ? std::string_view(reinterpret_cast<const char*>(text)) : std::string_view();
}

/// Returns a namespace, cut to the bytes that a message shows: every element inside inherits it, so
/// a huge one would be copied many times.
std::string_view NamespaceView(const xmlChar* uri) {
  constexpr std::size_t kMaxBytes = 100;
  if (!uri) return {};
  const auto* text = reinterpret_cast<const char*>(uri);
  return {text, strnlen(text, kMaxBytes)};
}

std::string WithPrefix(const xmlChar* prefix, const xmlChar* name) {
  std::string qualified(View(name));
  return prefix ? std::string(View(prefix)) + ":" + qualified : qualified;
}

bool IsBlank(char letter) { return std::strchr(" \t\r\n", letter) != nullptr; }

/// True for encodings in which each byte below 0x80 is the ASCII letter, so that the pre-check and
/// the parser see the same tags.
bool IsReadableEncoding(std::string_view declared, Strictness strictness) {
  std::string name(declared);
  std::ranges::transform(name, name.begin(),
                         [](unsigned char letter) { return std::toupper(letter); });
  if (name.empty() || name == "UTF-8" || name == "UTF8" || name == "US-ASCII" || name == "ASCII") {
    return true;
  }
  return strictness == Strictness::kTolerant &&
         (name.starts_with("ISO-8859-") || name.starts_with("WINDOWS-125"));
}

/// True for faults that tolerant reading accepts, see Strictness::kTolerant.
bool IsTolerable(const xmlError& error) {
  return error.domain == XML_FROM_NAMESPACE || error.code == XML_ERR_HYPHEN_IN_COMMENT;
}

/// Builds the tree from libxml2's SAX events, which bound memory by our own limits while parsing. A
/// fault that makes the tree useless stops the parser.
class TreeBuilder {
 public:
  TreeBuilder(const std::string& file_name, const ParseOptions& options)
      : file_name_(file_name), options_(options), limits_(options.limits) {}

  Parsed Parse(std::string_view text) {
    struct FreeContext {
      void operator()(xmlParserCtxt* context) const { xmlFreeParserCtxt(context); }
    };
    std::unique_ptr<xmlParserCtxt, FreeContext> context(
        xmlCreateMemoryParserCtxt(text.data(), static_cast<int>(text.size())));
    if (context) {
      context_ = context.get();
      *context_->sax = Handler();
      context_->userData = this;
      // XML_PARSE_NOENT makes libxml2 replace entities by their text. Without a DOCTYPE, only the
      // five of XML itself exist, such as &amp;. XML_PARSE_HUGE lifts the parser's own limits,
      // which a valid file of ten megabytes exceeds; ours are tighter where it matters.
      // XML_PARSE_RECOVER leaves the decision to us which faults end parsing.
      xmlCtxtUseOptions(context_, XML_PARSE_NONET | XML_PARSE_NOENT | XML_PARSE_HUGE |
                                      (is_tolerant() ? XML_PARSE_RECOVER : 0));
      xmlParseDocument(context_);
      context_ = nullptr;
    }
    if (!has_failed_ && !parsed_.root) {
      Add(1, "",
          "found something that is not XML, expected a <" + std::string(options_.root) +
              "> element");
    }
    if (has_failed_) parsed_.root.reset();
    return std::move(parsed_);
  }

 private:
  static TreeBuilder& Self(void* self) { return *static_cast<TreeBuilder*>(self); }

  static xmlSAXHandler Handler() {
    xmlSAXHandler handler = {};
    // Marks the handler as SAX2: otherwise startElementNs would not be called.
    handler.initialized = XML_SAX2_MAGIC;
    handler.startDocument = [](void* self) { Self(self).CheckEncoding(); };
    // A DOCTYPE could define entities that refer to files or expand to gigabytes.
    handler.internalSubset = [](void* self, const xmlChar*, const xmlChar*, const xmlChar*) {
      Self(self).Fail("", "found a DOCTYPE, expected none: files must be self-contained");
    };
    handler.processingInstruction = [](void* self, const xmlChar* target, const xmlChar* data) {
      Self(self).CheckInstruction(View(target), View(data));
    };
    handler.startElementNs = [](void* self, const xmlChar* name, const xmlChar* prefix,
                                const xmlChar* uri, int num_namespaces, const xmlChar**,
                                int num_attributes, int, const xmlChar** attributes) {
      TreeBuilder& builder = Self(self);
      Element element{
          .name = builder.is_tolerant() ? WithPrefix(prefix, name) : std::string(View(name)),
          .line = builder.LineOfOpenTag()};
      if (!builder.is_tolerant()) element.namespace_name = NamespaceView(uri);
      TakeAttributes(num_attributes, attributes, &element);
      builder.StartElement(std::move(element), num_namespaces);
    };
    handler.endElementNs = [](void* self, const xmlChar*, const xmlChar*, const xmlChar*) {
      Self(self).EndElement();
    };
    handler.characters = [](void* self, const xmlChar* text, int size) {
      Self(self).TakeText({reinterpret_cast<const char*>(text), static_cast<std::size_t>(size)});
    };
    handler.cdataBlock = handler.characters;
    handler.comment = [](void* self, const xmlChar* text) { Self(self).TakeComment(View(text)); };
    handler.serror = [](void* self, xmlErrorPtr error) { Self(self).TakeSyntaxError(*error); };
    return handler;
  }

  bool is_tolerant() const { return options_.strictness == Strictness::kTolerant; }
  int current_line() const { return context_->input ? context_->input->line : 1; }

  void Add(int line, std::string element, std::string message) {
    parsed_.diagnostics.push_back({file_name_, line, std::move(element), std::move(message)});
  }

  void Fail(std::string element, std::string message) {
    if (has_failed_) return;
    has_failed_ = true;
    Add(current_line(), std::move(element), std::move(message));
    xmlStopParser(context_);
  }

  void CheckEncoding() {
    // libxml2 stores an encoding that it converts from with the input, and one that it supports
    // natively with the parser.
    const std::string_view declared =
        View(context_->input->encoding ? context_->input->encoding : context_->encoding);
    if (IsReadableEncoding(declared, options_.strictness)) return;
    Fail("", "found encoding=" + Quoted(declared) + ", expected UTF-8");
  }

  void CheckInstruction(std::string_view target, std::string_view data) {
    // Other parsers might read a tag in there.
    if (data.find_first_of("<>") == std::string_view::npos) return;
    Fail("", "found the processing instruction " + Quoted(target) +
                 " with < or > inside, expected none");
  }

  /// Returns the line where the current tag begins. The parser reports a tag at its end; it begins
  /// at the previous `<`, since none can stand inside.
  int LineOfOpenTag() const {
    int line = current_line();
    const xmlChar* const begin = context_->input->base;
    for (const xmlChar* letter = context_->input->cur; letter > begin;) {
      --letter;
      if (*letter == '<') return line;
      if (*letter == '\n') --line;
    }
    return current_line();
  }

  std::string AddressOf(const Element& element) const {
    const std::string_view key = options_.key_of ? options_.key_of(element.name) : "";
    return xml::AddressOf(element.name, key, element.FindAttribute(key));
  }

  void StartElement(Element element, int num_namespaces) {
    if (num_namespaces > limits_.max_namespaces) {
      return Fail(AddressOf(element), "found " + std::to_string(num_namespaces) +
                                          " xmlns attributes, expected at most " +
                                          std::to_string(limits_.max_namespaces));
    }
    if (static_cast<int>(open_.size()) >= limits_.max_depth) {
      return Fail(AddressOf(element), "found more than " + std::to_string(limits_.max_depth) +
                                          " elements inside one another, expected fewer");
    }
    if (++parsed_.num_elements + options_.num_elements_before > limits_.max_elements) {
      return Fail(AddressOf(element), "found more than " + std::to_string(limits_.max_elements) +
                                          " elements, expected fewer");
    }
    Open(std::move(element));
  }

  /// Copies attributes. libxml2 passes each as five pointers: name, prefix, namespace, and begin
  /// and end of its value.
  static void TakeAttributes(int count, const xmlChar** fields, Element* element) {
    for (int i = 0; i < count; ++i, fields += 5) {
      const std::string_view uri = NamespaceView(fields[2]);
      if (uri == kXsiNamespace || uri == kXmlNamespace) continue;
      const auto* begin = reinterpret_cast<const char*>(fields[3]);
      const auto* end = reinterpret_cast<const char*>(fields[4]);
      element->attributes.push_back({WithPrefix(fields[1], fields[0]), std::string(begin, end)});
    }
  }

  /// Appends an element and opens it. Pointers to open elements stay valid, since only the
  /// innermost one's list of children grows.
  void Open(Element element) {
    has_refused_text_ = false;
    if (open_.empty()) {
      parsed_.root = std::move(element);
      open_.push_back(&*parsed_.root);
    } else {
      open_.back()->children.push_back(std::move(element));
      open_.push_back(&open_.back()->children.back());
    }
  }

  void EndElement() {
    has_refused_text_ = false;
    if (!open_.empty()) open_.pop_back();
  }

  void TakeText(std::string_view text) {
    if (open_.empty()) return;
    if (options_.text == TextPolicy::kKeep) open_.back()->text += text;
    if (options_.text == TextPolicy::kRefuse) RefuseText(text);
  }

  void TakeComment(std::string_view text) {
    const bool is_first_before_root = !parsed_.root && !has_comment_;
    if (!is_first_before_root) return;
    has_comment_ = true;
    parsed_.comment = text.substr(0, limits_.max_comment_bytes);
  }

  /// Adds one diagnostic per text, although a long text arrives in pieces.
  void RefuseText(std::string_view text) {
    const auto first = std::ranges::find_if_not(text, IsBlank);
    if (first == text.end() || has_refused_text_) return;
    has_refused_text_ = true;
    if (static_cast<int>(parsed_.diagnostics.size()) >= limits_.max_diagnostics) return;
    // The parser has passed the text already, so its line breaks are subtracted. After an error the
    // parser stops counting lines, hence the minimum.
    const int line =
        std::max(1, current_line() - static_cast<int>(std::count(first, text.end(), '\n')));
    std::string_view shown = text.substr(first - text.begin());
    shown = shown.substr(0, shown.find_first_of("\r\n"));
    Add(line, AddressOf(*open_.back()), "found text " + Quoted(shown) + ", expected only elements");
  }

  /// Records the first syntax error; later ones are its consequences.
  void TakeSyntaxError(const xmlError& error) {
    constexpr std::size_t kMaxReasonBytes = 200;
    if (has_failed_ || error.level < XML_ERR_ERROR) return;
    if (is_tolerant() && IsTolerable(error)) return;
    has_failed_ = true;
    std::string reason = error.message ? error.message : "unknown error";
    while (!reason.empty() && IsBlank(reason.back())) reason.pop_back();
    std::ranges::replace(reason, '\n', ' ');
    if (reason.size() > kMaxReasonBytes) reason = reason.substr(0, kMaxReasonBytes) + "…";
    Add(std::max(1, error.line), "",
        "found an error in the XML (" + reason + "), expected well-formed XML");
    xmlStopParser(context_);
  }

  const std::string& file_name_;
  const ParseOptions& options_;
  const Limits& limits_;
  xmlParserCtxt* context_ = nullptr;
  Parsed parsed_;
  std::vector<Element*> open_;     // from the root inwards
  bool has_refused_text_ = false;  // since the last tag
  bool has_failed_ = false;
  bool has_comment_ = false;
};

}  // namespace

Parsed Parse(std::string_view text, const std::string& file_name, const ParseOptions& options) {
  if (std::optional<Diagnostic> fault = PrecheckFaultOf(text, file_name, options)) {
    return {.diagnostics = {*std::move(fault)}};
  }
  return TreeBuilder(file_name, options).Parse(text);
}

}  // namespace smile::xml
