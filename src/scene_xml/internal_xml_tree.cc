#include "scene_xml/internal_xml_tree.h"

#include <libxml/parser.h>
#include <libxml/parserInternals.h>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <memory>

#include "base/wording.h"
#include "scene_xml/internal_xml_precheck.h"

namespace smile::scene_xml {
namespace {

// Tools put these on any file; they say nothing about the scene.
constexpr std::string_view kXsiNamespace = "http://www.w3.org/2001/XMLSchema-instance";
constexpr std::string_view kXmlNamespace = "http://www.w3.org/XML/1998/namespace";
// Looking up a prefix walks all that are in scope; real files declare one or two.
constexpr int kMaxNamespacesPerTag = 8;

std::string_view View(const xmlChar* text) {
  return text ? std::string_view(reinterpret_cast<const char*>(text)) : std::string_view();
}

/// A namespace is inherited by every element inside: of a huge one, no more than a message shows.
std::string_view NamespaceView(const xmlChar* uri) {
  constexpr std::size_t kMaxBytes = 100;
  if (!uri) return {};
  const auto* text = reinterpret_cast<const char*>(uri);
  return {text, strnlen(text, kMaxBytes)};
}

/// The attribute by which a person knows an element.
std::string_view NameOfKey(const XmlElement& element) {
  if (element.name == "def" || element.name == "var") return "name";
  if (element.name == "instance") return "def";
  return "id";
}

bool IsBlank(char letter) { return std::strchr(" \t\r\n", letter) != nullptr; }

/// Builds the tree from the parser's events. A finding that makes the tree useless stops it.
class TreeBuilder {
 public:
  TreeBuilder(int file, const SceneLimits& limits, int* num_elements, Findings* findings)
      : file_(file), limits_(limits), num_elements_(*num_elements), findings_(findings) {}

  std::optional<XmlElement> Parse(std::string_view text) {
    struct FreeContext {
      void operator()(xmlParserCtxt* context) const { xmlFreeParserCtxt(context); }
    };
    std::unique_ptr<xmlParserCtxt, FreeContext> context(
        xmlCreateMemoryParserCtxt(text.data(), static_cast<int>(text.size())));
    if (!context) {
      findings_->Add({file_, 1}, "",
                     "found something that is not XML, expected a <tabletop> element");
      return std::nullopt;
    }
    context_ = context.get();
    *context_->sax = Handler();
    context_->userData = this;
    // "No entities" to libxml2 means: give text in their place. Without a DOCTYPE there are only
    // the five of XML itself, &amp; and so on.
    // "Huge" lifts the parser's own limits, which a good file of ten megabytes meets; SceneLimits
    // are tighter where it matters.
    xmlCtxtUseOptions(context_, XML_PARSE_NONET | XML_PARSE_NOENT | XML_PARSE_HUGE);
    xmlParseDocument(context_);
    context_ = nullptr;
    return has_failed_ ? std::nullopt : std::move(root_);
  }

 private:
  static TreeBuilder& Self(void* self) { return *static_cast<TreeBuilder*>(self); }

  static xmlSAXHandler Handler() {
    xmlSAXHandler handler = {};
    handler.initialized = XML_SAX2_MAGIC;
    handler.startDocument = [](void* self) { Self(self).CheckEncoding(); };
    handler.internalSubset = [](void* self, const xmlChar*, const xmlChar*, const xmlChar*) {
      Self(self).Fail("", "found a DOCTYPE, expected none: a scene file stands for itself");
    };
    handler.startElementNs = [](void* self, const xmlChar* name, const xmlChar*, const xmlChar* uri,
                                int num_namespaces, const xmlChar**, int num_attributes, int,
                                const xmlChar** attributes) {
      Self(self).StartElement(name, uri, num_namespaces, num_attributes, attributes);
    };
    handler.endElementNs = [](void* self, const xmlChar*, const xmlChar*, const xmlChar*) {
      Self(self).EndElement();
    };
    handler.characters = [](void* self, const xmlChar* text, int size) {
      Self(self).RefuseText({reinterpret_cast<const char*>(text), static_cast<std::size_t>(size)});
    };
    handler.cdataBlock = handler.characters;
    handler.serror = [](void* self, xmlErrorPtr error) { Self(self).TakeSyntaxError(*error); };
    return handler;
  }

  int current_line() const { return context_->input ? context_->input->line : 1; }

  void Fail(const std::string& element, const std::string& message) {
    if (has_failed_) return;
    has_failed_ = true;
    findings_->Add({file_, current_line()}, element, message);
    xmlStopParser(context_);
  }

  /// Only UTF-8: what the pre-check read is then what the parser reads.
  void CheckEncoding() {
    // One it has to convert from stands with the input, one it knows by itself with the parser.
    const std::string_view declared =
        View(context_->input->encoding ? context_->input->encoding : context_->encoding);
    std::string name(declared);
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char letter) { return std::toupper(letter); });
    if (name.empty() || name == "UTF-8" || name == "UTF8" || name == "US-ASCII" ||
        name == "ASCII") {
      return;
    }
    Fail("", "found encoding=" + Quoted(declared) + ", expected UTF-8");
  }

  /// The parser reports a tag at its end; its beginning is the `<` before (none can stand inside).
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

  void StartElement(const xmlChar* name, const xmlChar* uri, int num_namespaces, int num_attributes,
                    const xmlChar** attributes) {
    XmlElement element;
    element.name = View(name);
    element.place = {file_, LineOfOpenTag()};
    element.is_in_scene_namespace = NamespaceView(uri) == kSceneNamespace;
    if (uri && !element.is_in_scene_namespace) element.found_namespace = Quoted(NamespaceView(uri));
    TakeAttributes(num_attributes, attributes, &element);

    const std::string address = AddressOf(element);
    if (num_namespaces > kMaxNamespacesPerTag) {
      return Fail(address, "found " + std::to_string(num_namespaces) +
                               " xmlns attributes, expected at most " +
                               std::to_string(kMaxNamespacesPerTag));
    }
    if (static_cast<int>(open_.size()) >= limits_.max_depth) {
      return Fail(address, "found more than " + std::to_string(limits_.max_depth) +
                               " elements inside one another, expected fewer");
    }
    if (++num_elements_ > limits_.max_elements) {
      return Fail(address, "found more than " + std::to_string(limits_.max_elements) +
                               " elements, expected fewer");
    }
    Open(std::move(element));
  }

  /// Each attribute comes as name, prefix, namespace, and the two ends of its value.
  static void TakeAttributes(int count, const xmlChar** fields, XmlElement* element) {
    for (int i = 0; i < count; ++i, fields += 5) {
      const std::string_view uri = NamespaceView(fields[2]);
      if (uri == kXsiNamespace || uri == kXmlNamespace) continue;
      std::string name(View(fields[0]));
      if (fields[1]) name = std::string(View(fields[1])) + ":" + name;
      const auto* begin = reinterpret_cast<const char*>(fields[3]);
      const auto* end = reinterpret_cast<const char*>(fields[4]);
      element->attributes.push_back({std::move(name), std::string(begin, end)});
    }
  }

  /// Pointers to the open elements stay good: only the innermost one's list of children grows.
  void Open(XmlElement element) {
    has_refused_text_ = false;
    if (open_.empty()) {
      root_ = std::move(element);
      open_.push_back(&*root_);
    } else {
      open_.back()->children.push_back(std::move(element));
      open_.push_back(&open_.back()->children.back());
    }
  }

  void EndElement() {
    has_refused_text_ = false;
    if (!open_.empty()) open_.pop_back();
  }

  /// A long text arrives in pieces; it is one finding.
  void RefuseText(std::string_view text) {
    const auto first = std::find_if_not(text.begin(), text.end(), IsBlank);
    if (first == text.end() || open_.empty() || has_refused_text_) return;
    has_refused_text_ = true;
    // The parser stands behind the text.
    // The parser counts no further once it has met an error.
    const int line =
        std::max(1, current_line() - static_cast<int>(std::count(first, text.end(), '\n')));
    std::string_view shown = text.substr(first - text.begin());
    shown = shown.substr(0, shown.find_first_of("\r\n"));
    findings_->Add({file_, line}, AddressOf(*open_.back()),
                   "found text " + Quoted(shown) + ", expected only elements");
  }

  /// The first one counts; those after it are its consequences.
  void TakeSyntaxError(const xmlError& error) {
    if (has_failed_ || error.level < XML_ERR_ERROR) return;
    has_failed_ = true;
    std::string reason = error.message ? error.message : "unknown fault";
    while (!reason.empty() && IsBlank(reason.back())) reason.pop_back();
    std::replace(reason.begin(), reason.end(), '\n', ' ');
    if (reason.size() > kMaxReasonBytes) reason = reason.substr(0, kMaxReasonBytes) + "…";
    findings_->Add({file_, std::max(1, error.line)}, "",
                   "found a fault in the XML (" + reason + "), expected well-formed XML");
    xmlStopParser(context_);
  }

  static constexpr std::size_t kMaxReasonBytes = 200;

  int file_;
  const SceneLimits& limits_;
  int& num_elements_;
  Findings* findings_;
  xmlParserCtxt* context_ = nullptr;
  std::optional<XmlElement> root_;
  std::vector<XmlElement*> open_;  // from the root inwards
  bool has_refused_text_ = false;  // since the last tag
  bool has_failed_ = false;
};

}  // namespace

const std::string* XmlElement::FindAttribute(std::string_view attribute_name) const {
  for (const XmlAttribute& attribute : attributes) {
    if (attribute.name == attribute_name) return &attribute.value;
  }
  return nullptr;
}

std::string AddressOf(const XmlElement& element) {
  constexpr std::size_t kMaxNameBytes = 60;
  std::string address = element.name.substr(0, kMaxNameBytes);
  const std::string_view key = NameOfKey(element);
  if (const std::string* value = element.FindAttribute(key)) {
    address += " " + std::string(key) + "=" + Quoted(*value);
  }
  return address;
}

std::optional<XmlElement> ParseXml(std::string_view text, int file, const SceneLimits& limits,
                                   int* num_elements, Findings* findings) {
  if (!PassesPrecheck(text, file, limits, findings)) return std::nullopt;
  return TreeBuilder(file, limits, num_elements, findings).Parse(text);
}

}  // namespace smile::scene_xml
