#pragma once

#include <cstddef>
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
  /// Both limits included.
  static JsonShape Number(double min, double max);
  /// @param max_length  [bytes].
  static JsonShape Text(std::size_t max_length);
  static JsonShape Flag();
  static JsonShape Word(std::vector<std::string> words);
  static JsonShape List(JsonShape item, std::size_t min_count, std::size_t max_count);
  /// With these members and no others.
  static JsonShape Object(std::vector<JsonMember> members);

  bool Fits(const Json& json) const;
  /// JSON Schema, draft 2020-12.
  Json Schema() const;
  /// A TypeScript type; lists of one length are tuples.
  std::string TypeScript() const;

 private:
  enum class Type { kNumber, kText, kFlag, kWord, kList, kObject };

  explicit JsonShape(Type type);
  bool IsCountRight(std::size_t count) const { return min_count_ <= count && count <= max_count_; }
  bool FitsList(const Json& json) const;
  bool FitsObject(const Json& json) const;
  Json ListSchema() const;
  Json ObjectSchema() const;
  std::string ListTypeScript() const;
  std::string ObjectTypeScript() const;

  Type type_;
  double min_ = 0, max_ = 0;                   ///< of a number
  std::size_t min_count_ = 0, max_count_ = 0;  ///< of the bytes of a text, the items of a list
  std::vector<std::string> words_;             ///< one of which it is
  std::vector<JsonShape> items_;               ///< of a list: one shape, that of all
  std::vector<JsonMember> members_;            ///< of an object
};

/// One member of an object.
struct JsonMember {
  std::string name;
  JsonShape shape;
  bool is_required = true;
};

}  // namespace smile
