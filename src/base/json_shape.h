#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/json.h"

namespace smile {

struct JsonMember;

/// Shape of JSON values. One definition checks values and describes them: as a JSON Schema and as a
/// TypeScript type. Copyable value type.
class JsonShape {
 public:
  static JsonShape Anything();
  /// Returns the shape of numbers; both limits included.
  static JsonShape Number(double min, double max);
  static JsonShape Number();
  /// Returns the shape of whole numbers from 0 on; both limits included.
  static JsonShape Whole(std::uint64_t min, std::uint64_t max);
  /// @param max_length  [bytes].
  static JsonShape Text(std::size_t max_length);
  static JsonShape Text();
  static JsonShape Flag();
  static JsonShape Word(std::vector<std::string> words);
  static JsonShape List(JsonShape item, std::size_t min_count, std::size_t max_count);
  static JsonShape List(JsonShape item);
  /// Returns the shape of objects with these members and no others.
  static JsonShape Object(std::vector<JsonMember> members);
  /// Returns the shape of objects with any members of this shape.
  /// @param max_name  length of the names of members [bytes].
  static JsonShape Map(JsonShape value, std::size_t max_count, std::size_t max_name);
  static JsonShape Map(JsonShape value);

  /// Returns the same shape, with null allowed.
  JsonShape OrNull() const;
  /// Returns the same shape, with true allowed.
  JsonShape OrTrue() const;
  /// Returns the shape of values that have this shape or the other one.
  JsonShape Or(JsonShape other) const;
  /// Returns the same shape, for TypeScript() of the given type: the page converts such values when
  /// they arrive.
  JsonShape ArrivesAs(std::string typescript) const;
  /// Returns the same shape with a name, which TypeScript() then uses.
  JsonShape Called(std::string name) const;

  /// @param misfit  receives the misfit with its place: `.hands.left.object is 3`.
  bool Fits(const Json& json, std::string* misfit = nullptr) const;
  /// Returns the members of an object.
  const std::vector<JsonMember>& members() const { return members_; }
  /// Returns a JSON Schema, draft 2020-12.
  Json Schema() const;
  /// Returns a TypeScript type; lists of fixed length are tuples.
  std::string TypeScript() const;
  /// Returns the exported definition of its named type.
  /// @param meaning  of the type, for a comment; empty: none.
  std::string TypeScriptDefinition(const std::string& meaning = "") const;

 private:
  enum class Type { kAnything, kMap, kNumber, kText, kFlag, kWord, kList, kObject };

  explicit JsonShape(Type type);
  bool IsCountRight(std::size_t count) const { return min_count_ <= count && count <= max_count_; }
  bool AreNamesRight(const Json& json) const;
  bool FitsAlone(const Json& json) const;
  bool FitsWithin(const Json& json, std::string* misfit) const;
  bool FitsMembers(const Json& json, std::string* misfit) const;
  Json MapSchema() const;
  Json ListSchema() const;
  Json ObjectSchema() const;
  std::string UnnamedTypeScript() const;
  std::string ListTypeScript() const;
  std::string ObjectTypeScript() const;

  Type type_;
  std::string name_;        ///< empty without one
  std::string arrives_as_;  ///< type in TypeScript; empty: that of the shape
  bool may_be_null_ = false, may_be_true_ = false;
  double min_ = 0, max_ = 0;                   ///< of a number
  bool is_whole_ = false;                      ///< of a number: without fraction
  std::size_t min_count_ = 0, max_count_ = 0;  ///< of the bytes of a text, the items of a list
  std::size_t max_name_ = 0;                   ///< of a map: bytes of a member's name
  std::vector<std::string> words_;             ///< allowed values
  std::vector<JsonShape> items_;               ///< one shape, for all items of a list or map
  std::vector<JsonMember> members_;            ///< of an object
  std::vector<JsonShape> others_;              ///< further shapes, each of which is allowed as well
};

/// Member of an object.
struct JsonMember {
  std::string name;
  JsonShape shape;
  bool is_required = true;
  std::string meaning = "";  ///< for people; empty if the name suffices
};

}  // namespace smile
