#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/json.h"

namespace smile::robot::internal {

inline constexpr std::size_t kMaxShortText = 64;

/// A value of a side file together with its place in the file. What it complains of is an
/// InputError there. The value and the file's name must outlive it.
class SideNode {
 public:
  SideNode(const Json& value, const std::string& file, std::string place)
      : value_(value), file_(file), place_(std::move(place)) {}

  [[noreturn]] void Fail(const std::string& message) const;

  void ExpectObject() const;
  /// Refuses members nobody reads: a typing mistake must not pass in silence.
  void ExpectMembers(std::span<const std::string_view> names) const;
  bool Has(const std::string& name) const { return value_.contains(name); }
  SideNode Member(const std::string& name) const;
  /// Names and values of an object.
  std::vector<std::pair<std::string, SideNode>> Members() const;
  std::vector<SideNode> Items() const;
  /// A list of exactly `count` items.
  std::vector<SideNode> Items(std::size_t count) const;
  bool IsString() const { return value_.is_string(); }
  std::string String() const;
  /// A text of at most kMaxShortText letters: for what is put into many others.
  std::string ShortString() const;
  double Number() const;
  const Json& value() const { return value_; }
  const std::string& place() const { return place_; }

 private:
  std::string Kind() const { return value_.type_name(); }

  const Json& value_;
  const std::string& file_;
  std::string place_;
};

}  // namespace smile::robot::internal
