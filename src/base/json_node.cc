#include "base/json_node.h"

#include <algorithm>

#include "base/diagnostic.h"
#include "base/wording.h"

namespace smile {

void JsonNode::Fail(const std::string& message) const {
  throw InputError(Diagnostic{.file = file_, .element = place_, .message = message});
}

void JsonNode::ExpectMembers(std::span<const std::string_view> names) const {
  ExpectObject();
  for (const auto& [key, value] : value_.items()) {
    if (std::ranges::find(names, key) != names.end()) continue;
    // Unknown members are refused, since a misspelled optional one would otherwise have no effect.
    Fail("unknown member " + Quoted(key) + ", expected " + OneOf(names) + DidYouMean(key, names));
  }
}

JsonNode JsonNode::Member(const std::string& name) const {
  ExpectObject();
  if (!Has(name)) Fail("has no member " + Quoted(name));
  // Places are paths such as `arms/0/joints`, as messages display them.
  return {value_[name], file_, place_.empty() ? name : place_ + "/" + name};
}

std::vector<std::pair<std::string, JsonNode>> JsonNode::Members() const {
  ExpectObject();
  std::vector<std::pair<std::string, JsonNode>> members;
  for (const auto& [key, value] : value_.items()) members.emplace_back(key, Member(key));
  return members;
}

std::vector<std::pair<std::string, JsonNode>> JsonNode::MembersUpTo(std::size_t count) const {
  ExpectObject();
  ExpectSizeUpTo(count);
  return Members();
}

std::vector<JsonNode> JsonNode::Items() const {
  if (!value_.is_array()) Fail("found " + Kind() + ", expected a list");
  std::vector<JsonNode> items;
  for (std::size_t i = 0; i < value_.size(); ++i) {
    items.emplace_back(value_[i], file_, place_ + "/" + std::to_string(i));
  }
  return items;
}

std::vector<JsonNode> JsonNode::Items(std::size_t count) const {
  std::vector<JsonNode> items = Items();
  if (items.size() == count) return items;
  Fail("length is " + std::to_string(items.size()) + ", expected " + std::to_string(count));
}

std::vector<JsonNode> JsonNode::ItemsUpTo(std::size_t count) const {
  if (value_.is_array()) ExpectSizeUpTo(count);
  return Items();
}

std::string JsonNode::String() const {
  if (!value_.is_string()) Fail("found " + Kind() + ", expected a string");
  return value_.get<std::string>();
}

std::string JsonNode::ShortString(std::size_t max_bytes) const {
  std::string text = String();
  if (text.size() <= max_bytes) return text;
  Fail("found " + Quoted(text) + ", expected at most " + std::to_string(max_bytes) + " characters");
}

bool JsonNode::Flag() const {
  if (!value_.is_boolean()) Fail("found " + Kind() + ", expected true or false");
  return value_.get<bool>();
}

double JsonNode::Number() const {
  if (!value_.is_number()) Fail("found " + Kind() + ", expected a number");
  return value_.get<double>();
}

double JsonNode::Number(double low, double high) const {
  const double number = Number();
  if (number >= low && number <= high) return number;
  Fail("found " + NumberText(number) + ", expected " + NumberText(low) + " to " + NumberText(high));
}

std::uint64_t JsonNode::Whole(std::uint64_t low, std::uint64_t high) const {
  const std::string expected =
      ", expected a whole number from " + std::to_string(low) + " to " + std::to_string(high);
  if (!value_.is_number()) Fail("found " + Kind() + expected);
  // Negative numbers and fractions have types of their own in the library; 3.0 is a fraction, too.
  if (!value_.is_number_unsigned()) Fail("found " + NumberText(value_.get<double>()) + expected);
  const auto number = value_.get<std::uint64_t>();
  if (number >= low && number <= high) return number;
  Fail("found " + std::to_string(number) + expected);
}

void JsonNode::ExpectSizeUpTo(std::size_t count) const {
  if (value_.size() <= count) return;
  Fail("found " + std::to_string(value_.size()) + ", expected at most " + std::to_string(count));
}

void JsonNode::ExpectObject() const {
  if (!value_.is_object()) Fail("found " + Kind() + ", expected an object");
}

}  // namespace smile
