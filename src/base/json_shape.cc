#include "base/json_shape.h"

#include <algorithm>
#include <utility>

namespace smile {
namespace {

/// Longer lists of one length are no tuples.
constexpr std::size_t kMaxTuple = 8;

Json CountsFrom(const char* min_key, std::size_t min, const char* max_key, std::size_t max) {
  Json counts = Json::object();
  if (min > 0) counts[min_key] = min;
  counts[max_key] = max;
  return counts;
}

}  // namespace

JsonShape::JsonShape(Type type) : type_(type) {}

JsonShape JsonShape::Number(double min, double max) {
  JsonShape shape(Type::kNumber);
  shape.min_ = min;
  shape.max_ = max;
  return shape;
}

JsonShape JsonShape::Text(std::size_t max_length) {
  JsonShape shape(Type::kText);
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

bool JsonShape::Fits(const Json& json) const {
  switch (type_) {
    case Type::kNumber:
      return json.is_number() && min_ <= json.get<double>() && json.get<double>() <= max_;
    case Type::kText:
      return json.is_string() && IsCountRight(json.get_ref<const std::string&>().size());
    case Type::kFlag:
      return json.is_boolean();
    case Type::kWord:
      return json.is_string() &&
             std::ranges::find(words_, json.get_ref<const std::string&>()) != words_.end();
    case Type::kList:
      return FitsList(json);
    case Type::kObject:
      return FitsObject(json);
  }
  return false;
}

bool JsonShape::FitsList(const Json& json) const {
  return json.is_array() && IsCountRight(json.size()) &&
         std::ranges::all_of(json, [this](const Json& item) { return items_[0].Fits(item); });
}

bool JsonShape::FitsObject(const Json& json) const {
  if (!json.is_object()) return false;
  std::size_t num_known = 0;
  for (const JsonMember& member : members_) {
    const auto found = json.find(member.name);
    if (found == json.end() ? member.is_required : !member.shape.Fits(*found)) return false;
    if (found != json.end()) ++num_known;
  }
  return num_known == json.size();
}

Json JsonShape::Schema() const {
  switch (type_) {
    case Type::kNumber:
      return {{"type", "number"}, {"minimum", min_}, {"maximum", max_}};
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

Json JsonShape::ListSchema() const {
  Json schema = {{"type", "array"}, {"items", items_[0].Schema()}};
  schema.update(CountsFrom("minItems", min_count_, "maxItems", max_count_));
  return schema;
}

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
  switch (type_) {
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
  if (min_count_ != max_count_ || max_count_ > kMaxTuple) {
    return items_[0].type_ == Type::kWord ? "(" + item + ")[]" : item + "[]";
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
