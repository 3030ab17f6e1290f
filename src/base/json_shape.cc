// One tree of shapes with three readers: Fits() checks a value, Schema() and TypeScript() describe
// it. What one of them accepts the others must accept, so a new type is added to all three.

#include "base/json_shape.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace smile {
namespace {

/// Longest list of fixed length that is written as a tuple.
constexpr std::size_t kMaxTuple = 8;
/// Length of a misfit in a message [bytes].
constexpr std::size_t kMaxFound = 80;
/// Count that no JSON reaches.
constexpr std::size_t kNoLimit = std::numeric_limits<std::size_t>::max();

/// Returns the limits of a count as keywords of JSON Schema. A minimum of 0 is its default.
Json CountsFrom(const char* min_key, std::size_t min, const char* max_key, std::size_t max) {
  Json counts = Json::object();
  if (min > 0) counts[min_key] = min;
  counts[max_key] = max;
  return counts;
}

}  // namespace

JsonShape::JsonShape(Type type) : type_(type) {}

JsonShape JsonShape::Anything() { return JsonShape(Type::kAnything); }

JsonShape JsonShape::Number() {
  return Number(std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max());
}

JsonShape JsonShape::Text() { return Text(kNoLimit); }

JsonShape JsonShape::List(JsonShape item) { return List(std::move(item), 0, kNoLimit); }

JsonShape JsonShape::Map(JsonShape value, std::size_t max_count, std::size_t max_name) {
  JsonShape shape(Type::kMap);
  shape.items_.push_back(std::move(value));
  shape.max_count_ = max_count;
  shape.max_name_ = max_name;
  return shape;
}

JsonShape JsonShape::Map(JsonShape value) { return Map(std::move(value), kNoLimit, kNoLimit); }

JsonShape JsonShape::OrNull() const {
  JsonShape shape = *this;
  shape.may_be_null_ = true;
  return shape;
}

JsonShape JsonShape::OrTrue() const {
  JsonShape shape = *this;
  shape.may_be_true_ = true;
  return shape;
}

JsonShape JsonShape::Or(JsonShape other) const {
  JsonShape shape = *this;
  shape.others_.push_back(std::move(other));
  return shape;
}

JsonShape JsonShape::ArrivesAs(std::string typescript) const {
  JsonShape shape = *this;
  shape.arrives_as_ = std::move(typescript);
  return shape;
}

JsonShape JsonShape::Called(std::string name) const {
  JsonShape shape = *this;
  shape.name_ = std::move(name);
  return shape;
}

JsonShape JsonShape::Number(double min, double max) {
  JsonShape shape(Type::kNumber);
  shape.min_ = min;
  shape.max_ = max;
  return shape;
}

JsonShape JsonShape::Whole(std::uint64_t min, std::uint64_t max) {
  JsonShape shape = Number(static_cast<double>(min), static_cast<double>(max));
  shape.is_whole_ = true;
  return shape;
}

JsonShape JsonShape::Text(std::size_t max_length) {
  JsonShape shape(Type::kText);
  // JSON Schema counts characters and this class bytes: for texts beyond ASCII the check is
  // stricter.
  shape.max_count_ = max_length;
  return shape;
}

JsonShape JsonShape::Flag() { return JsonShape(Type::kFlag); }

JsonShape JsonShape::Word(std::vector<std::string> words) {
  JsonShape shape(Type::kWord);
  shape.words_ = std::move(words);
  return shape;
}

JsonShape JsonShape::List(JsonShape item, std::size_t min_count, std::size_t max_count) {
  JsonShape shape(Type::kList);
  shape.items_.push_back(std::move(item));
  shape.min_count_ = min_count;
  shape.max_count_ = max_count;
  return shape;
}

JsonShape JsonShape::Object(std::vector<JsonMember> members) {
  JsonShape shape(Type::kObject);
  shape.members_ = std::move(members);
  return shape;
}

bool JsonShape::Fits(const Json& json, std::string* misfit) const {
  // The alternatives come first, since they are allowed whatever the type.
  if (may_be_null_ && json.is_null()) return true;
  if (may_be_true_ && json == true) return true;
  if (std::ranges::any_of(others_, [&](const auto& other) { return other.Fits(json); }))
    return true;
  if (!FitsAlone(json)) {
    // A misfit is shown as found, cut: it may be megabytes from a client.
    if (misfit != nullptr) *misfit = " is " + ToText(json).substr(0, kMaxFound);
    return false;
  }
  return FitsWithin(json, misfit);
}

bool JsonShape::FitsAlone(const Json& json) const {
  switch (type_) {
    case Type::kAnything:
      return true;
    case Type::kNumber:
      // The text of a whole number has no fraction: 1.0 is refused, too.
      if (is_whole_ && !json.is_number_unsigned()) return false;
      return json.is_number() && min_ <= json.get<double>() && json.get<double>() <= max_;
    case Type::kText:
      return json.is_string() && IsCountRight(json.get_ref<const std::string&>().size());
    case Type::kFlag:
      return json.is_boolean();
    case Type::kWord:
      return json.is_string() &&
             std::ranges::find(words_, json.get_ref<const std::string&>()) != words_.end();
    case Type::kList:
      return json.is_array() && IsCountRight(json.size());
    case Type::kMap:
      return json.is_object() && json.size() <= max_count_ && AreNamesRight(json);
    case Type::kObject:
      return json.is_object();
  }
  return false;
}

bool JsonShape::AreNamesRight(const Json& json) const {
  for (const auto& [name, value] : json.items()) {
    if (name.size() > max_name_) return false;
  }
  return true;
}

bool JsonShape::FitsWithin(const Json& json, std::string* misfit) const {
  if (type_ == Type::kObject) return FitsMembers(json, misfit);
  if (type_ != Type::kList && type_ != Type::kMap) return true;
  // The keys of an array's items are their indices. The path to the misfit grows from the inside
  // out: `.list.3 is …`.
  for (const auto& [key, item] : json.items()) {
    if (items_[0].Fits(item, misfit)) continue;
    if (misfit != nullptr) *misfit = "." + key + *misfit;
    return false;
  }
  return true;
}

bool JsonShape::FitsMembers(const Json& json, std::string* misfit) const {
  // Texts are made only if the caller wants them: most callers need only yes or no.
  const auto fails = [misfit](const std::string& name, const std::string& why) {
    if (misfit != nullptr) *misfit = "." + name + why;
    return false;
  };
  std::size_t num_known = 0;
  for (const JsonMember& member : members_) {
    const auto found = json.find(member.name);
    if (found != json.end()) {
      ++num_known;
      std::string within;
      if (!member.shape.Fits(*found, misfit != nullptr ? &within : nullptr)) {
        return fails(member.name, within);
      }
    } else if (member.is_required) {
      return fails(member.name, " is missing");
    }
  }
  // As many members as known ones: no unknown member exists. Only a misfit needs the search.
  if (num_known == json.size()) return true;
  for (const auto& [key, value] : json.items()) {
    const auto is_it = [&key = key](const JsonMember& member) { return member.name == key; };
    if (std::ranges::none_of(members_, is_it)) return fails(key, " is unknown");
  }
  return false;
}

Json JsonShape::Schema() const {
  if (may_be_null_ || may_be_true_ || !others_.empty()) {
    // The schema without the alternatives is one of them.
    JsonShape itself = *this;
    itself.may_be_null_ = itself.may_be_true_ = false;
    itself.others_.clear();
    // `anyOf` instead of a list of types, since the alternatives also apply to words and objects.
    Json any = Json::array({itself.Schema()});
    for (const JsonShape& other : others_) any.push_back(other.Schema());
    if (may_be_true_) any.push_back({{"const", true}});
    if (may_be_null_) any.push_back({{"type", "null"}});
    return {{"anyOf", std::move(any)}};
  }
  switch (type_) {
    case Type::kAnything:
      return Json::object();
    case Type::kMap:
      return MapSchema();
    case Type::kNumber:
      return {{"type", is_whole_ ? "integer" : "number"}, {"minimum", min_}, {"maximum", max_}};
    case Type::kText:
      return {{"type", "string"}, {"maxLength", max_count_}};
    case Type::kFlag:
      return {{"type", "boolean"}};
    case Type::kWord:
      return {{"enum", words_}};
    case Type::kList:
      return ListSchema();
    case Type::kObject:
      return ObjectSchema();
  }
  return Json();
}

Json JsonShape::MapSchema() const {
  Json schema = {{"type", "object"}, {"additionalProperties", items_[0].Schema()}};
  if (max_count_ != kNoLimit) schema["maxProperties"] = max_count_;
  if (max_name_ != kNoLimit) schema["propertyNames"] = {{"maxLength", max_name_}};
  return schema;
}

Json JsonShape::ListSchema() const {
  Json schema = {{"type", "array"}, {"items", items_[0].Schema()}};
  schema.update(CountsFrom("minItems", min_count_, "maxItems", max_count_));
  return schema;
}

// Unknown members are refused, as by Fits().
Json JsonShape::ObjectSchema() const {
  Json properties = Json::object();
  Json required = Json::array();
  for (const JsonMember& member : members_) {
    properties[member.name] = member.shape.Schema();
    if (member.is_required) required.push_back(member.name);
  }
  return {{"type", "object"},
          {"properties", std::move(properties)},
          {"required", std::move(required)},
          {"additionalProperties", false}};
}

std::string JsonShape::TypeScript() const {
  // A named type is defined once and referred to by its name.
  return (name_.empty() ? UnnamedTypeScript() : name_) + (may_be_null_ ? " | null" : "");
}

std::string JsonShape::TypeScriptDefinition(const std::string& meaning) const {
  const std::string comment = meaning.empty() ? "" : "/** " + meaning + " */\n";
  if (type_ != Type::kObject) {
    return comment + "export type " + name_ + " = " + UnnamedTypeScript() + ";\n";
  }
  // Interfaces for objects, since their members can have comments.
  std::string text = comment + "export interface " + name_ + " {\n";
  for (const JsonMember& member : members_) {
    if (!member.meaning.empty()) text += "  /** " + member.meaning + " */\n";
    text += "  " + member.name + (member.is_required ? ": " : "?: ") + member.shape.TypeScript() +
            ";\n";
  }
  return text + "}\n";
}

std::string JsonShape::UnnamedTypeScript() const {
  if (may_be_true_) {
    JsonShape itself = *this;
    itself.may_be_true_ = false;
    return itself.UnnamedTypeScript() + " | true";
  }
  if (!arrives_as_.empty()) return arrives_as_;
  if (!others_.empty()) {
    JsonShape itself = *this;
    itself.others_.clear();
    std::string text = itself.UnnamedTypeScript();
    for (const JsonShape& other : others_) text += " | " + other.TypeScript();
    return text;
  }
  switch (type_) {
    case Type::kAnything:
      return "unknown";
    case Type::kMap:
      return "Record<string, " + items_[0].TypeScript() + ">";
    case Type::kNumber:
      return "number";
    case Type::kText:
      return "string";
    case Type::kFlag:
      return "boolean";
    case Type::kWord: {
      std::string text;
      for (const std::string& word : words_) text += (text.empty() ? "\"" : " | \"") + word + "\"";
      return text;
    }
    case Type::kList:
      return ListTypeScript();
    case Type::kObject:
      return ObjectTypeScript();
  }
  return "";
}

std::string JsonShape::ListTypeScript() const {
  const std::string item = items_[0].TypeScript();
  // A tuple lets TypeScript check the number of items, as of a vector.
  if (min_count_ != max_count_ || max_count_ > kMaxTuple) {
    // A union needs parentheses in front of `[]`.
    return item.find(" | ") == std::string::npos ? item + "[]" : "(" + item + ")[]";
  }
  std::string text = "[";
  for (std::size_t i = 0; i < max_count_; ++i) text += (i > 0 ? ", " : "") + item;
  return text + "]";
}

std::string JsonShape::ObjectTypeScript() const {
  std::string text;
  for (const JsonMember& member : members_) {
    text += (text.empty() ? "{ " : "; ") + member.name + (member.is_required ? ": " : "?: ") +
            member.shape.TypeScript();
  }
  return text + " }";
}

}  // namespace smile
