#include "xml_input.h"

#include <algorithm>

#include "base/diagnostic.h"

namespace smile::fuzz {
namespace {

constexpr const char* kXmlFileName = "fuzzed.xml";
constexpr xml::Limits kXmlLimits{.max_bytes = 1u << 16,
                                 .max_depth = 20,
                                 .max_elements = 200,
                                 .max_attributes = 16,
                                 .max_namespaces = 4,
                                 .max_diagnostics = 20,
                                 .max_comment_bytes = 100};

std::string EscapedXml(std::string_view text) {
  std::string escaped;
  for (const char letter : text) {
    if (std::string_view("<>&\"\t\n\r").find(letter) == std::string_view::npos) {
      escaped += letter;
    } else {
      escaped += "&#" + std::to_string(static_cast<int>(letter)) + ";";
    }
  }
  return escaped;
}

/// The tree as a text: tolerant parsing makes the same tree of it, but for lines.
void WriteXml(const xml::Element& element, std::string* text) {
  *text += "<" + element.name;
  for (const xml::Attribute& attribute : element.attributes) {
    *text += " " + attribute.name + "=\"" + EscapedXml(attribute.value) + "\"";
  }
  *text += ">" + EscapedXml(element.text);
  for (const xml::Element& child : element.children) WriteXml(child, text);
  *text += "</" + element.name + ">";
}

void ForgetLines(xml::Element* element) {
  element->line = 1;
  for (xml::Element& child : element->children) ForgetLines(&child);
}

std::string FaultOf(const xml::Element& element, int depth, int max_line, int* num_elements) {
  ++*num_elements;
  if (depth > kXmlLimits.max_depth) return "elements deeper than the limit";
  if (element.name.empty()) return "an element without a name";
  if (element.line < 1 || element.line > max_line) return "a line that the text does not have";
  if (static_cast<int>(element.attributes.size()) > kXmlLimits.max_attributes) {
    return "more attributes than the limit";
  }
  for (const xml::Element& child : element.children) {
    if (child.line < element.line) return "a child that begins before its parent";
    if (std::string fault = FaultOf(child, depth + 1, max_line, num_elements); !fault.empty()) {
      return fault;
    }
  }
  return {};
}

std::string RoundTripFaultOf(xml::Element root) {
  std::string text;
  WriteXml(root, &text);
  xml::Parsed again = xml::Parse(text, kXmlFileName, {.strictness = xml::Strictness::kTolerant});
  if (!again.root) return "its own text is refused: " + ToString(again.diagnostics.front());
  ForgetLines(&root);
  ForgetLines(&*again.root);
  return *again.root == root ? "" : "its own text reads differently:\n" + text;
}

std::string FaultOf(xml::Parsed parsed, std::string_view text) {
  for (const Diagnostic& diagnostic : parsed.diagnostics) {
    if (diagnostic.file != kXmlFileName || diagnostic.line < 1 || diagnostic.message.empty()) {
      return "a diagnostic without an address: " + ToString(diagnostic);
    }
  }
  if (static_cast<int>(parsed.diagnostics.size()) > kXmlLimits.max_diagnostics + 1) {
    return "more diagnostics than the limit";
  }
  if (parsed.comment.size() > kXmlLimits.max_comment_bytes) return "a comment beyond the limit";
  if (!parsed.root) return parsed.diagnostics.empty() ? "refused without a reason" : "";
  int num_elements = 0;
  const int max_line = 1 + static_cast<int>(std::ranges::count(text, '\n'));
  std::string fault = FaultOf(*parsed.root, 1, max_line, &num_elements);
  if (!fault.empty()) return fault;
  if (num_elements != parsed.num_elements || num_elements > kXmlLimits.max_elements) {
    return std::to_string(num_elements) + " elements";
  }
  return {};
}

}  // namespace

xml::Parsed ParseHostileXml(std::string_view text, xml::Strictness strictness) {
  const bool is_strict = strictness == xml::Strictness::kStrict;
  return xml::Parse(text, kXmlFileName,
                    {.limits = kXmlLimits,
                     .text = is_strict ? xml::TextPolicy::kRefuse : xml::TextPolicy::kKeep,
                     .strictness = strictness});
}

std::string FaultWithXml(std::string_view text) {
  std::string fault = FaultOf(ParseHostileXml(text, xml::Strictness::kStrict), text);
  if (!fault.empty()) return fault;
  xml::Parsed tolerant = ParseHostileXml(text, xml::Strictness::kTolerant);
  if (tolerant.root) fault = RoundTripFaultOf(*tolerant.root);
  return fault.empty() ? FaultOf(std::move(tolerant), text) : fault;
}

}  // namespace smile::fuzz
