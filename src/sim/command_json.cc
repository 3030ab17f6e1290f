#include "sim/command_json.h"

#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>

#include "base/overloaded.h"
#include "scene/units.h"

namespace smile::sim {

using scene::FromFileUnits;
using scene::ToFileUnits;

namespace {

/// Longer names and arrays than these are nobody's.
constexpr std::size_t kMaxText = 256;
constexpr std::size_t kMaxJoints = 64;
/// No length, angle or speed is larger, and no speed limit smaller [units, degrees, rad, per s].
constexpr double kMaxNumber = 1e6, kMinSpeed = 1e-6;

enum class Kind { kHand, kText, kPoint, kAngles, kSpeed, kJoints, kGrippers, kNumber, kFlag };

struct Field {
  const char* name;
  Kind kind;
  bool is_required;
  const char* meaning;
};

/// One kind of command: what it is called, what it takes. The reader and the schema both follow
/// this.
struct Form {
  const char* name;
  const char* meaning;
  std::vector<Field> fields;
  std::function<Command(const Json&, double)> build;
};

constexpr const char* kGripperMeaning = "rate of change of each opening, left and right [units/s]";

Vector3 VectorOf(const Json& json) {
  return {json[0].get<double>(), json[1].get<double>(), json[2].get<double>()};
}
HandName HandOf(const Json& json) {
  return *demonstrator::ParseHandName(json.at("hand").get<std::string>());
}
template <class T>
std::optional<T> OptionalOf(const Json& json, const char* key) {
  return json.contains(key) ? std::optional<T>(json.at(key).get<T>()) : std::nullopt;
}

const std::vector<Form>& Forms() {
  static const Field kHandField{"hand", Kind::kHand, true, "which of the demonstrator's hands"};
  static const std::vector<Form> kForms = {
      {"grasp",
       "takes hold of an object",
       {kHandField,
        {"object", Kind::kText, true, "id of a whole object"},
        {"point", Kind::kPoint, false,
         "where to take hold of it; its origin if not given [units]"}},
       [](const Json& json, double unit) -> Command {
         Grasp grasp{.hand = HandOf(json), .object = json.at("object")};
         if (json.contains("point")) grasp.p_WQ = FromFileUnits(VectorOf(json.at("point")), unit);
         return grasp;
       }},
      {"move_to",
       "carries the held object",
       {kHandField,
        {"position", Kind::kPoint, true, "where the grasped point shall go [units]"},
        {"speed", Kind::kSpeed, false, "at most this fast; 10 if not given [units/s]"}},
       [](const Json& json, double unit) -> Command {
         MoveTo move{.hand = HandOf(json),
                     .p_WH = FromFileUnits(VectorOf(json.at("position")), unit)};
         if (json.contains("speed"))
           move.speed = FromFileUnits(json.at("speed").get<double>(), unit);
         return move;
       }},
      {"rotate",
       "turns the held object about its origin",
       {kHandField,
        {"angles", Kind::kAngles, true, "about the world's x, then y, then z axis [degrees]"}},
       [](const Json& json, double) -> Command {
         return Rotate{.hand = HandOf(json), .angles_deg = VectorOf(json.at("angles"))};
       }},
      {"release",
       "lets go of the held object",
       {kHandField},
       [](const Json& json, double) -> Command { return Release{.hand = HandOf(json)}; }},
      {"joint_velocities",
       "sets the robot's speeds until the next such command",
       {{"left", Kind::kJoints, false, "left arm, s0 s1 e0 e1 w0 w1 w2 [rad/s]"},
        {"right", Kind::kJoints, false, "right arm [rad/s]"},
        {"grippers", Kind::kGrippers, false, kGripperMeaning},
        {"head", Kind::kNumber, false, "pan [rad/s]"}},
       [](const Json& json, double unit) -> Command {
         JointVelocities command{.left = OptionalOf<std::vector<double>>(json, "left"),
                                 .right = OptionalOf<std::vector<double>>(json, "right"),
                                 .head = OptionalOf<double>(json, "head")};
         if (json.contains("grippers")) {
           const Json& rates = json.at("grippers");
           command.grippers = {FromFileUnits(rates[0].get<double>(), unit),
                               FromFileUnits(rates[1].get<double>(), unit)};
         }
         return command;
       }},
      {"joint_angles",
       "puts the robot's joints there at once",
       {{"left", Kind::kJoints, false, "left arm, s0 s1 e0 e1 w0 w1 w2 [rad]"},
        {"right", Kind::kJoints, false, "right arm [rad]"},
        {"head", Kind::kNumber, false, "pan [rad]"}},
       [](const Json& json, double) -> Command {
         return JointAngles{.left = OptionalOf<std::vector<double>>(json, "left"),
                            .right = OptionalOf<std::vector<double>>(json, "right"),
                            .head = OptionalOf<double>(json, "head")};
       }},
      {"robot",
       "shows or hides the robot; physics is not changed",
       {{"shown", Kind::kFlag, true, "true or false"}},
       [](const Json& json, double) -> Command {
         return ShowRobot{.is_shown = json.at("shown").get<bool>()};
       }},
  };
  return kForms;
}

[[noreturn]] void Expected(const std::string& key, const Json& found, const std::string& expected) {
  // A container may be deep and long: its kind says enough.
  std::string text = found.is_structured() && found.size() > 4 ? found.type_name() : ToText(found);
  if (text.size() > 60) text = text.substr(0, 57) + "...";
  throw std::invalid_argument("\"" + key + "\" is " + text + ", expected " + expected);
}

/// A number of a size that can mean something on a table.
bool IsNumber(const Json& json) {
  return json.is_number() && std::abs(json.get<double>()) <= kMaxNumber;
}

bool IsNumbers(const Json& json, std::size_t min_count, std::size_t max_count) {
  if (!json.is_array() || json.size() < min_count || json.size() > max_count) return false;
  for (const Json& number : json) {
    if (!IsNumber(number)) return false;
  }
  return true;
}

void CheckField(const Field& field, const Json& value) {
  const std::string key = field.name;
  switch (field.kind) {
    case Kind::kHand:
      if (!value.is_string() || !demonstrator::ParseHandName(value.get<std::string>())) {
        Expected(key, value, "left, right, both or any");
      }
      return;
    case Kind::kText:
      if (!value.is_string() || value.get<std::string>().size() > kMaxText) {
        Expected(key, value, "a text of at most 256 letters");
      }
      return;
    case Kind::kPoint:
    case Kind::kAngles:
      if (!IsNumbers(value, 3, 3)) Expected(key, value, "three numbers [x, y, z] of at most 1e6");
      return;
    case Kind::kSpeed:
      if (!IsNumber(value) || !(value.get<double>() >= kMinSpeed)) {
        Expected(key, value, "a number above 0, from 1e-6 to 1e6");
      }
      return;
    case Kind::kJoints:
      if (!IsNumbers(value, 1, kMaxJoints)) Expected(key, value, "one number per joint of the arm");
      return;
    case Kind::kGrippers:
      if (!IsNumbers(value, 2, 2)) Expected(key, value, "two numbers [left, right]");
      return;
    case Kind::kNumber:
      if (!IsNumber(value)) Expected(key, value, "a number");
      return;
    case Kind::kFlag:
      if (!value.is_boolean()) Expected(key, value, "true or false");
      return;
  }
}

std::string FormNames() {
  std::string names;
  for (const Form& form : Forms()) names += (names.empty() ? "" : ", ") + std::string(form.name);
  return names;
}

const Form& FormOf(const Json& json) {
  if (!json.is_object()) {
    throw std::invalid_argument("found " + std::string(json.type_name()) +
                                ", expected an object like {\"hand\": \"left\", \"do\": …}");
  }
  if (!json.contains("do")) {
    throw std::invalid_argument("\"do\" is missing, expected one of " + FormNames());
  }
  for (const Form& form : Forms()) {
    if (json.at("do") == form.name) return form;
  }
  Expected("do", json.at("do"), "one of " + FormNames());
}

Json ToArray(const Vector3& v) { return {v.x(), v.y(), v.z()}; }

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
      schema = array(3, 3);
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
  }
  schema["description"] = field.meaning;
  return schema;
}

}  // namespace

Json ToJson(const Command& command, double unit) {
  const auto hand = [](HandName name, const char* what) -> Json {
    return {{"hand", ToString(name)}, {"do", what}};
  };
  const auto put = [](Json* json, const char* key, const auto& value) {
    if (value) (*json)[key] = *value;
  };
  return std::visit(
      Overloaded{[&](const Grasp& grasp) {
                   Json json = hand(grasp.hand, "grasp");
                   json["object"] = grasp.object;
                   if (grasp.p_WQ) json["point"] = ToArray(ToFileUnits(*grasp.p_WQ, unit));
                   return json;
                 },
                 [&](const MoveTo& move) {
                   Json json = hand(move.hand, "move_to");
                   json["position"] = ToArray(ToFileUnits(move.p_WH, unit));
                   if (move.speed) json["speed"] = ToFileUnits(*move.speed, unit);
                   return json;
                 },
                 [&](const Rotate& rotate) {
                   Json json = hand(rotate.hand, "rotate");
                   json["angles"] = ToArray(rotate.angles_deg);
                   return json;
                 },
                 [&](const Release& release) { return hand(release.hand, "release"); },
                 [&](const JointVelocities& velocities) {
                   Json json = {{"do", "joint_velocities"}};
                   put(&json, "left", velocities.left);
                   put(&json, "right", velocities.right);
                   if (velocities.grippers) {
                     json["grippers"] = {ToFileUnits((*velocities.grippers)[0], unit),
                                         ToFileUnits((*velocities.grippers)[1], unit)};
                   }
                   put(&json, "head", velocities.head);
                   return json;
                 },
                 [&](const JointAngles& angles) {
                   Json json = {{"do", "joint_angles"}};
                   put(&json, "left", angles.left);
                   put(&json, "right", angles.right);
                   put(&json, "head", angles.head);
                   return json;
                 },
                 [&](const ShowRobot& show) {
                   return Json{{"do", "robot"}, {"shown", show.is_shown}};
                 }},
      command);
}

Command ParseCommand(const Json& json, double meters_per_unit) {
  const Form& form = FormOf(json);
  for (const Field& field : form.fields) {
    if (json.contains(field.name)) {
      CheckField(field, json.at(field.name));
    } else if (field.is_required) {
      throw std::invalid_argument("\"" + std::string(form.name) + "\" lacks \"" + field.name +
                                  "\": " + field.meaning);
    }
  }
  for (const auto& [key, value] : json.items()) {
    bool is_known = key == "do" || key == "tick";
    for (const Field& field : form.fields) is_known = is_known || key == field.name;
    if (!is_known) {
      throw std::invalid_argument("\"" + std::string(form.name) + "\" has an unknown key \"" + key +
                                  "\"");
    }
  }
  return form.build(json, meters_per_unit);
}

Command OnFileGrid(Command command, double unit) {
  std::visit(Overloaded{[unit](Grasp& grasp) {
                          if (grasp.p_WQ) grasp.p_WQ = scene::OnFileGrid(*grasp.p_WQ, unit);
                        },
                        [unit](MoveTo& move) {
                          move.p_WH = scene::OnFileGrid(move.p_WH, unit);
                          if (move.speed) move.speed = scene::OnFileGrid(*move.speed, unit);
                        },
                        [unit](JointVelocities& velocities) {
                          if (!velocities.grippers) return;
                          for (double& rate : *velocities.grippers) {
                            rate = scene::OnFileGrid(rate, unit);
                          }
                        },
                        [](auto&) {}},
             command);
  return command;
}

std::optional<std::uint64_t> ParseTick(const Json& json) {
  if (!json.is_object() || !json.contains("tick")) return std::nullopt;
  const Json& tick = json.at("tick");
  if (!tick.is_number_unsigned()) Expected("tick", tick, "a whole number from 0");
  return tick.get<std::uint64_t>();
}

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
