#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/json.h"

namespace smile {

struct JsonMember;

/// What a JSON value may be. Told once, it checks values and describes them: as a JSON Schema and
/// as a TypeScript type. A value that can be copied.
class JsonShape {
 public:
  static JsonShape Anything();
  /// Both limits included.
  static JsonShape Number(double min, double max);
  static JsonShape Number();
  /// A whole number; both limits included, from 0 on.
  static JsonShape Whole(std::uint64_t min, std::uint64_t max);
  /// @param max_length  [bytes].
  static JsonShape Text(std::size_t max_length);
  static JsonShape Text();
  static JsonShape Flag();
  static JsonShape Word(std::vector<std::string> words);
  static JsonShape List(JsonShape item, std::size_t min_count, std::size_t max_count);
  static JsonShape List(JsonShape item);
  /// With these members and no others.
  static JsonShape Object(std::vector<JsonMember> members);
  /// An object with any members, all like this.
  static JsonShape Map(JsonShape value);

  /// The same, or null.
  JsonShape OrNull() const;
  /// The same, or true.
  JsonShape OrTrue() const;
  /// The same under a name, which TypeScript() then tells instead.
  JsonShape Called(std::string name) const;

  /// @param misfit  told what does not fit, and where: `.hands.left.object is 3`.
  bool Fits(const Json& json, std::string* misfit = nullptr) const;
  /// Of an object.
  const std::vector<JsonMember>& members() const { return members_; }
  /// JSON Schema, draft 2020-12.
  Json Schema() const;
  /// A TypeScript type; lists of one length are tuples.
  std::string TypeScript() const;
  /// The type that its name stands for, exported.
  /// @param meaning  of it all, for a comment; empty: none.
  std::string TypeScriptDefinition(const std::string& meaning = "") const;

 private:
  enum class Type { kAnything, kMap, kNumber, kText, kFlag, kWord, kList, kObject };

  explicit JsonShape(Type type);
  bool IsCountRight(std::size_t count) const { return min_count_ <= count && count <= max_count_; }
  bool FitsAlone(const Json& json) const;
  bool FitsWithin(const Json& json, std::string* misfit) const;
  bool FitsMembers(const Json& json, std::string* misfit) const;
  Json ListSchema() const;
  Json ObjectSchema() const;
  std::string UnnamedTypeScript() const;
  std::string ListTypeScript() const;
  std::string ObjectTypeScript() const;

  Type type_;
  std::string name_;  ///< empty without one
  bool may_be_null_ = false, may_be_true_ = false;
  double min_ = 0, max_ = 0;                   ///< of a number
  bool is_whole_ = false;                      ///< of a number: it has no fraction
  std::size_t min_count_ = 0, max_count_ = 0;  ///< of the bytes of a text, the items of a list
  std::vector<std::string> words_;             ///< one of which it is
  std::vector<JsonShape> items_;               ///< one shape: of all in a list or map
  std::vector<JsonMember> members_;            ///< of an object
};

/// One member of an object.
struct JsonMember {
  std::string name;
  JsonShape shape;
  bool is_required = true;
  std::string meaning = "";  ///< for people; empty where the name says it
};

}  // namespace smile
