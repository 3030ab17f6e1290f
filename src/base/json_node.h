#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/json.h"

namespace smile {

/// Value of a JSON file together with its place in the file, as `arms/left/joints`. Faults are
/// reported as an InputError with that place. The value and the file's name must outlive it.
class JsonNode {
 public:
  JsonNode(const Json& value, const std::string& file, std::string place)
      : value_(value), file_(file), place_(std::move(place)) {}

  [[noreturn]] void Fail(const std::string& message) const;

  void ExpectObject() const;
  /// Refuses unknown members, so that typing errors are noticed.
  void ExpectMembers(std::span<const std::string_view> names) const;
  bool Has(const std::string& name) const { return value_.contains(name); }
  JsonNode Member(const std::string& name) const;
  /// Returns names and values of an object.
  std::vector<std::pair<std::string, JsonNode>> Members() const;
  /// Returns names and values of an object of at most `count` members.
  std::vector<std::pair<std::string, JsonNode>> MembersUpTo(std::size_t count) const;
  std::vector<JsonNode> Items() const;
  /// Returns a list of exactly `count` items.
  std::vector<JsonNode> Items(std::size_t count) const;
  /// Returns a list of at most `count` items.
  std::vector<JsonNode> ItemsUpTo(std::size_t count) const;
  bool IsNull() const { return value_.is_null(); }
  bool IsString() const { return value_.is_string(); }
  std::string String() const;
  /// Returns a text of at most `max_bytes`: for texts that are copied into many others.
  std::string ShortString(std::size_t max_bytes) const;
  bool Flag() const;
  double Number() const;
  /// Returns a number from `low` to `high`.
  double Number(double low, double high) const;
  std::uint64_t Whole(std::uint64_t low, std::uint64_t high) const;
  const Json& value() const { return value_; }
  const std::string& place() const { return place_; }

 private:
  void ExpectSizeUpTo(std::size_t count) const;
  std::string Kind() const { return value_.type_name(); }

  const Json& value_;
  const std::string& file_;
  std::string place_;
};

}  // namespace smile
