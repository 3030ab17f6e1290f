#include "demonstrator/demonstrator.h"
#include "motion/trajectory_shape.h"
#include "sim/command_json.h"
#include "sim/internal_command_forms.h"

namespace smile::sim {
namespace {

Json FieldSchema(const Field& field) {
  const Json number = {{"type", "number"}, {"minimum", -kMaxNumber}, {"maximum", kMaxNumber}};
  const auto array = [&number](std::size_t min_count, std::size_t max_count) -> Json {
    return {{"type", "array"}, {"items", number}, {"minItems", min_count}, {"maxItems", max_count}};
  };
  Json schema;
  switch (field.kind) {
    case Kind::kHand:
      schema = {{"enum", Json::array()}};
      for (HandName hand : demonstrator::kHandNames) schema["enum"].push_back(ToString(hand));
      break;
    case Kind::kText:
      schema = {{"type", "string"}, {"maxLength", kMaxText}};
      break;
    case Kind::kPoint:
    case Kind::kAngles:
    case Kind::kDirection:
      schema = array(3, 3);
      break;
    case Kind::kPoints:
      schema = {{"type", "array"}, {"items", array(3, 3)}, {"maxItems", kMaxMarkers}};
      break;
    case Kind::kSpeed:
      schema = {{"type", "number"}, {"minimum", kMinSpeed}, {"maximum", kMaxNumber}};
      break;
    case Kind::kJoints:
      schema = array(1, kMaxJoints);
      break;
    case Kind::kGrippers:
      schema = array(2, 2);
      break;
    case Kind::kNumber:
      schema = number;
      break;
    case Kind::kFlag:
      schema = {{"type", "boolean"}};
      break;
    case Kind::kMood:
      schema = {{"enum", robot::kMoodNames}};
      break;
    case Kind::kProperties:
      schema = {{"type", "array"},
                {"items", {{"type", "string"}, {"maxLength", demonstrator::kMaxPropertyLength}}},
                {"maxItems", demonstrator::kMaxProperties}};
      break;
    case Kind::kArm:
      schema = {{"enum", kArmNames}};
      break;
    case Kind::kShare:
      schema = {{"type", "number"}, {"minimum", kMinSpeed}, {"maximum", 1}};
      break;
    case Kind::kJointNames:
      schema = {{"type", "array"},
                {"items", {{"type", "string"}, {"maxLength", kMaxText}}},
                {"minItems", 1},
                {"maxItems", kMaxJoints}};
      break;
    case Kind::kTrajectoryPoints:
      schema = {
          {"type", "array"},
          {"items",
           {{"type", "object"},
            {"properties",
             {{"seconds",
               {{"type", "number"}, {"minimum", 0}, {"maximum", motion::kMaxTrajectorySeconds}}},
              {"positions", array(1, kMaxJoints)},
              {"velocities", array(1, kMaxJoints)}}},
            {"required", {"seconds", "positions"}},
            {"additionalProperties", false}}},
          {"minItems", 1},
          {"maxItems", motion::kMaxTrajectoryPoints}};
      break;
  }
  schema["description"] = field.meaning;
  return schema;
}

}  // namespace

Json CommandSchema() {
  Json forms = Json::array();
  for (const Form& form : Forms()) {
    Json properties = {{"do", {{"const", form.name}}},
                       {"tick",
                        {{"type", "integer"},
                         {"minimum", 0},
                         {"description",
                          "when it is applied, in ticks of 1/60 s; scripts "
                          "may leave it out"}}}};
    Json required = {"do"};
    for (const Field& field : form.fields) {
      properties[field.name] = FieldSchema(field);
      if (field.is_required) required.push_back(field.name);
    }
    forms.push_back({{"title", form.name},
                     {"description", form.meaning},
                     {"type", "object"},
                     {"properties", properties},
                     {"required", required},
                     {"additionalProperties", false}});
  }
  return {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
          {"title", "SMILE command"},
          {"oneOf", forms}};
}

}  // namespace smile::sim
