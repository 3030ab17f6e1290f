#include "task/structure_json.h"

#include <algorithm>

#include "math/angles.h"
#include "scene/units.h"
#include "texts/lists.h"

namespace smile::task {
namespace {

using texts::Say;

constexpr const char* kFellText = " fell to the floor";

/// Returns `{"object": "Red1", "on": "Plank"}`; `in` instead of `on` within a container.
Json ToJson(const Relation& relation) {
  const bool is_in = relation.kind == Relation::Kind::kIn;
  return {{"object", relation.object}, {is_in ? "in" : "on", relation.support}};
}

/// Joins words as in a sentence: `a, b and c`.
std::string Joined(const std::vector<std::string>& words) {
  return texts::AllOf({words.begin(), words.end()});
}

}  // namespace

texts::UserMessage PlaceWordsOf(const std::string& id, const std::vector<Relation>& relations) {
  std::vector<texts::UserMessage> around, beneath;
  for (const Relation& relation : relations) {
    if (relation.object != id) continue;
    const bool is_in = relation.kind == Relation::Kind::kIn;
    (is_in ? around : beneath)
        .push_back(relation.support.empty() ? Say("effects.theTable")
                                            : texts::UserMessage(relation.support));
  }
  const texts::UserMessage object(id), in = AllOf(around), on = AllOf(beneath);
  if (around.empty() && beneath.empty()) return object;
  if (beneath.empty()) return Say("effects.isIn", {{"object", object}, {"in", in}});
  if (around.empty()) return Say("effects.isOn", {{"object", object}, {"on", on}});
  return Say("effects.isInAndOn", {{"object", object}, {"in", in}, {"on", on}});
}

namespace {

bool Contains(const std::vector<std::string>& ids, const std::string& id) {
  return std::ranges::find(ids, id) != ids.end();
}

/// True if the demonstration placed the object.
bool IsPut(const Structure& structure, const std::string& id) {
  return Contains(structure.order, id);
}

/// True if the object was removed from the table on purpose.
bool IsRemoved(const Structure& structure, const std::string& id) {
  return std::ranges::find(structure.effects, Effect(DestroyedEffect{id})) !=
         structure.effects.end();
}

}  // namespace

/// Returns positions in units of the scene, and rotations as angles about fixed axes [degrees].
Json PosesJson(const ObjectPoses& poses, double meters_per_unit) {
  Json json = Json::object();
  for (const auto& [id, X_WB] : poses) {
    const Vector3 p = scene::ToFileUnits(X_WB.translation(), meters_per_unit);
    const Vector3 angles = FixedAxesAngles(X_WB.rotation());
    json[id] = {{"position", {p.x(), p.y(), p.z()}},
                {"rotation", {angles.x(), angles.y(), angles.z()}}};
  }
  return json;
}

namespace {

/// Returns the id of the landmark, `""` for the table, and null for no anchor.
Json AnchorJson(const Structure& structure) {
  if (structure.anchor == Anchor::kNone) return nullptr;
  return structure.landmark;
}

Json RulesJson(const Structure& structure) {
  Json rules = Json::array();
  for (const auto& [id, properties] : structure.attention) {
    if (Contains(properties, "order")) rules.push_back({{"rule", "order"}, {"object", id}});
  }
  for (const SupportRule& rule : structure.support_rules) {
    Json exceptions = Json::array();
    for (const scene::ObjectSpec& one : rule.exceptions) exceptions.push_back(one.id());
    rules.push_back({{"rule", "support"}, {"object", rule.object.id()}, {"except_on", exceptions}});
  }
  return rules;
}

}  // namespace

Json ToJson(const Structure& structure, double meters_per_unit) {
  ObjectPoses poses;
  for (const scene::ObjectSpec& object : structure.objects) {
    poses[object.id()] = object.pose_in_world();
  }
  Json relations = Json::array(), around = Json::array(), effects = Json::array();
  for (const Relation& relation : structure.relations) relations.push_back(ToJson(relation));
  for (const Surrounding& it : structure.around) {
    around.push_back({{"object", it.object}, {"inner", it.inner}});
  }
  for (const Effect& effect : structure.effects) effects.push_back(ToJson(effect, meters_per_unit));
  return {{"objects", PosesJson(poses, meters_per_unit)},
          {"relations", relations},
          {"around", around},
          {"order", structure.order},
          {"effects", effects},
          {"fallen", structure.fallen},
          {"attention", structure.attention},
          {"rules", RulesJson(structure)},
          {"anchor", AnchorJson(structure)},
          {"foundations", structure.foundations},
          {"fixed", structure.is_fixed()}};
}

namespace {

/// Appends what the demonstrator said about objects: their properties, then the rules.
void AppendAttention(const Structure& structure, std::vector<std::string>* lines) {
  for (const auto& [id, properties] : structure.attention) {
    std::vector<std::string> others = properties;
    std::erase_if(others, [](const auto& one) { return one == "order" || one == "support"; });
    if (!others.empty()) lines->push_back("of " + id + " matters its " + Joined(others));
    if (Contains(properties, "order")) {
      lines->push_back(id + " must be placed in the order of the demonstration");
    }
  }
  for (const SupportRule& rule : structure.support_rules) {
    std::vector<std::string> exceptions;
    for (const scene::ObjectSpec& one : rule.exceptions) exceptions.push_back(one.id());
    lines->push_back(rule.object.id() + " must never stand on a smaller object" +
                     (exceptions.empty() ? "" : ", except on " + Joined(exceptions)));
  }
}

}  // namespace

std::vector<std::string> WordsOf(const Structure& structure, double meters_per_unit) {
  std::vector<std::string> lines;
  // Numbered steps first, then objects that were never placed, falls, effects and attention.
  for (std::size_t i = 0; i < structure.order.size(); ++i) {
    const std::string& id = structure.order[i];
    lines.push_back(
        std::to_string(i + 1) + ". " +
        (Contains(structure.fallen, id) ? id + kFellText : PlaceWordsOf(id, structure.relations)));
  }
  for (const scene::ObjectSpec& object : structure.objects) {
    if (IsPut(structure, object.id()) || Contains(structure.fallen, object.id())) continue;
    lines.push_back("as it was: " + PlaceWordsOf(object.id(), structure.relations) +
                    (object.is_static() ? ", fixed" : ""));
  }
  for (const std::string& id : structure.fallen) {
    if (!IsPut(structure, id) && !IsRemoved(structure, id)) lines.push_back(id + kFellText);
  }
  for (const Effect& effect : structure.effects) {
    lines.push_back("achieved: " + WordsOf(effect, meters_per_unit));
  }
  for (const Surrounding& it : structure.around) {
    lines.push_back("what matters is that " + it.object + " is around " + it.inner);
  }
  if (PartsOf(structure).size() > 1) {
    for (const std::string& id : structure.foundations) {
      lines.push_back(id + " may stand anywhere, with what it carries");
    }
  }
  if (structure.anchor == Anchor::kLandmark) {
    lines.push_back("what matters is the place relative to " + structure.landmark);
  } else if (structure.anchor == Anchor::kTable) {
    lines.push_back("what matters is the place on the table");
  }
  AppendAttention(structure, &lines);
  return lines;
}

}  // namespace smile::task
