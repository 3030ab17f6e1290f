#include "robot/internal_side_node.h"

#include <algorithm>

#include "base/diagnostic.h"
#include "base/wording.h"

namespace smile::robot::internal {

void SideNode::Fail(const std::string& message) const {
  throw InputError(Diagnostic{.file = file_, .element = place_, .message = message});
}

void SideNode::ExpectMembers(std::span<const std::string_view> names) const {
  ExpectObject();
  for (const auto& [key, value] : value_.items()) {
    if (std::ranges::find(names, key) != names.end()) continue;
    Fail("unknown member " + Quoted(key) + ", expected " + OneOf(names) + DidYouMean(key, names));
  }
}

SideNode SideNode::Member(const std::string& name) const {
  ExpectObject();
  if (!Has(name)) Fail("has no member " + Quoted(name));
  return {value_[name], file_, place_.empty() ? name : place_ + "/" + name};
}

std::vector<std::pair<std::string, SideNode>> SideNode::Members() const {
  ExpectObject();
  std::vector<std::pair<std::string, SideNode>> members;
  for (const auto& [key, value] : value_.items()) members.emplace_back(key, Member(key));
  return members;
}

std::vector<SideNode> SideNode::Items() const {
  if (!value_.is_array()) Fail("found " + Kind() + ", expected a list");
  std::vector<SideNode> items;
  for (std::size_t i = 0; i < value_.size(); ++i) {
    items.emplace_back(value_[i], file_, place_ + "/" + std::to_string(i));
  }
  return items;
}

std::vector<SideNode> SideNode::Items(std::size_t count) const {
  std::vector<SideNode> items = Items();
  if (items.size() == count) return items;
  Fail("length is " + std::to_string(items.size()) + ", expected " + std::to_string(count));
}

std::string SideNode::String() const {
  if (!value_.is_string()) Fail("found " + Kind() + ", expected a text");
  return value_.get<std::string>();
}

std::string SideNode::ShortString() const {
  std::string text = String();
  if (text.size() <= kMaxShortText) return text;
  Fail("found " + Quoted(text) + ", expected at most " + std::to_string(kMaxShortText) +
       " letters");
}

double SideNode::Number() const {
  if (!value_.is_number()) Fail("found " + Kind() + ", expected a number");
  return value_.get<double>();
}

void SideNode::ExpectObject() const {
  if (!value_.is_object()) Fail("found " + Kind() + ", expected an object");
}

}  // namespace smile::robot::internal
