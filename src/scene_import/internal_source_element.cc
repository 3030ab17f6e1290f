#include "scene_import/internal_source_element.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/wording.h"
#include "xml/parse.h"

namespace smile::scene_import {
namespace {

// Numbers of models that exist are far below; sums and squares of these do not overflow.
constexpr double kMaxNumber = 1e9;

bool IsBlank(char letter) {
  return letter == ' ' || letter == '\t' || letter == '\n' || letter == '\r';
}

/// Returns the next number of a text from `at` on, and moves `at` behind it.
std::optional<double> NextNumber(const std::string& text, std::size_t* at) {
  const char* begin = text.data() + *at;
  const char* end = text.data() + text.size();
  if (begin != end && *begin == '+') ++begin;
  double number = 0;
  const auto [stop, error] = std::from_chars(begin, end, number);
  if (error != std::errc() || (stop != end && !IsBlank(*stop))) return std::nullopt;
  *at = static_cast<std::size_t>(stop - text.data());
  if (!(std::abs(number) <= kMaxNumber)) return std::nullopt;
  return number;
}

std::string CountText(std::size_t least, std::size_t most) {
  if (most == 1) return "a number";
  if (least == most) return std::to_string(least) + " numbers";
  return std::to_string(least) + " to " + std::to_string(most) + " numbers";
}

}  // namespace

const std::string* SourceElement::FindAttribute(std::string_view attribute_name) const {
  const auto found = std::ranges::find(attributes, attribute_name, &xml::Attribute::name);
  return found == attributes.end() ? nullptr : &found->value;
}

const SourceElement* SourceElement::FindChild(std::string_view child_name) const {
  const auto found = std::ranges::find(children, child_name, &SourceElement::name);
  return found == children.end() ? nullptr : &*found;
}

Place SourceElement::place() const {
  const std::string* id = FindAttribute("name");
  return {*file, line, xml::AddressOf(name, "name", id)};
}

SourceElement SourceElementOf(const xml::Element& element,
                              const std::shared_ptr<const std::string>& file) {
  SourceElement source{.name = element.name,
                       .file = file,
                       .line = element.line,
                       .attributes = element.attributes,
                       .text = element.text};
  for (const xml::Element& child : element.children) {
    source.children.push_back(SourceElementOf(child, file));
  }
  return source;
}

std::optional<SourceElement> ParseSource(std::string_view text, const std::string& file,
                                         std::string_view root, ImportFindings* findings) {
  xml::ParseOptions options{.root = root, .strictness = xml::Strictness::kTolerant};
  options.limits.max_depth = 128;
  const xml::Parsed parsed = xml::Parse(text, file, options);
  for (const Diagnostic& fault : parsed.diagnostics) {
    findings->Refuse({fault.file, fault.line, fault.element}, fault.message);
  }
  if (!parsed.root || !parsed.diagnostics.empty()) return std::nullopt;
  SourceElement source = SourceElementOf(*parsed.root, std::make_shared<const std::string>(file));
  if (source.name == root) return source;
  findings->Refuse(source.place(), "found the root element " + Quoted(source.name) + ", expected " +
                                       std::string(root));
  return std::nullopt;
}

std::optional<std::vector<double>> NumbersOf(const std::string& text, std::size_t least,
                                             std::size_t most, const Place& place,
                                             const std::string& what, ImportFindings* findings) {
  std::vector<double> numbers;
  bool is_valid = true;
  for (std::size_t at = 0; is_valid;) {
    while (at < text.size() && IsBlank(text[at])) ++at;
    if (at == text.size()) break;
    const std::optional<double> number = NextNumber(text, &at);
    is_valid = number.has_value() && numbers.size() < most;
    if (is_valid) numbers.push_back(*number);
  }
  if (is_valid && numbers.size() >= least) return numbers;
  findings->Refuse(place, "found " + what + "=" + Quoted(text) + ", expected " +
                              CountText(least, most) + " within 1e9 of 0");
  return std::nullopt;
}

std::string ElementReader::Text(std::string_view name, std::string_view usual) {
  read_.emplace(name);
  const std::string* value = element_.FindAttribute(name);
  return value ? *value : std::string(usual);
}

std::vector<double> ElementReader::Numbers(std::string_view name, std::size_t least,
                                           std::size_t most) {
  read_.emplace(name);
  const std::string* value = element_.FindAttribute(name);
  if (!value) return {};
  return NumbersOf(*value, least, most, place_, std::string(name), &findings_)
      .value_or(std::vector<double>());
}

double ElementReader::Number(std::string_view name, double usual) {
  const std::vector<double> numbers = Numbers(name, 1, 1);
  return numbers.empty() ? usual : numbers[0];
}

Vector3 ElementReader::Vector(std::string_view name, const Vector3& usual) {
  const std::vector<double> numbers = Numbers(name, 3, 3);
  return numbers.empty() ? usual : Vector3(numbers[0], numbers[1], numbers[2]);
}

void ElementReader::RemarkRest(std::initializer_list<std::string_view> harmless) {
  for (const auto& [name, value] : element_.attributes) {
    if (name == "name" || read_.contains(name) ||
        std::ranges::find(harmless, name) != harmless.end())
      continue;
    Remark("left out: " + Printable(name.substr(0, 60)) + ", which has no counterpart");
  }
}

}  // namespace smile::scene_import
