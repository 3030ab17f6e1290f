#include "value_schema.h"

#include <span>
#include <string_view>
#include <vector>

#include "base/wording.h"
#include "math/color.h"
#include "scene/tool.h"
#include "scene/trigger_rule.h"
#include "scene_xml/value_ranges.h"

namespace smile::scene_xml {
namespace {

/// A kind of value: a restriction of a type of XML Schema.
struct ValueType {
  std::string name;
  std::string base;
  std::vector<std::string> facets;
  std::string or_type = "";  ///< another kind of value that may stand there as well
};

std::string Facet(std::string_view name, std::string_view value) {
  return "<xs:" + std::string(name) + " value=\"" + std::string(value) + "\"/>";
}

template <class Number>
ValueType RealType(const std::string& name, const Range<Number>& range) {
  return {name,
          "xs:double",
          {Facet("pattern", "[^INa]*"),  // neither INF nor NaN
           Facet("minInclusive", NumberText(static_cast<double>(range.least))),
           Facet("maxInclusive", NumberText(static_cast<double>(range.most)))}};
}

ValueType WholeType(const std::string& name, const Range<int>& range) {
  return {name,
          "xs:int",
          {Facet("minInclusive", std::to_string(range.least)),
           Facet("maxInclusive", std::to_string(range.most))}};
}

ValueType WordType(const std::string& name, const std::string& pattern) {
  return {name, "xs:token", {Facet("pattern", pattern)}};
}

std::string IdPattern(int min_bytes) {
  return "[A-Za-z0-9_]{" + std::to_string(min_bytes) + "," + std::to_string(kMaxIdBytes) +
         "}(#[0-9]{1," + std::to_string(kMaxRenameDigits) + "})?";
}

std::string ColorPattern() {
  std::string pattern = "#[0-9A-Fa-f]{6}";
  for (const std::string_view name : ColorNames()) pattern += "|" + std::string(name);
  return pattern;
}

std::string WordsPattern(std::span<const std::string_view> words) {
  std::string pattern;
  for (const std::string_view word : words)
    pattern += (pattern.empty() ? "" : "|") + std::string(word);
  return pattern;
}

/// `(a,b,…)`.
std::string NumbersPattern(int count) {
  const std::string number = R"([+\-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+\-]?[0-9]+)?)";
  return R"(\( ?()" + number + " ?, ?){" + std::to_string(count - 1) + "}" + number + R"( ?\))";
}

/// The names are those that language.xsd uses.
std::vector<ValueType> ValueTypes() {
  return {WordType("id", IdPattern(0)),
          WordType("name", IdPattern(1)),
          WordType("bondType", R"([A-Za-z0-9_.:\-]{1,)" + std::to_string(kMaxBondTypeBytes) + "}"),
          RealType("distance", kLocationUnits),
          RealType("span", kSpanUnits),
          {"spanOrZero", "xs:double", {Facet("enumeration", "0")}, "span"},
          RealType("mass", kMassKilograms),
          RealType("linkMass", kLinkMassKilograms),
          RealType("friction", kFriction),
          RealType("proportion", kProportion),
          RealType("angle", kAngleDegrees),
          RealType("buttonAngle", kButtonDegrees),
          RealType("pressForce", kPressNewtons),
          RealType("pressAngle", kPressDegrees),
          RealType("turnAngle", kTurnDegrees),
          RealType("toolAngle", kToolDegrees),
          RealType("fieldOfView", kFieldOfViewDegrees),
          RealType("viewScale", kViewScale),
          RealType("brightness", kBrightness),
          WordType("tablePattern", WordsPattern(kTablePatterns)),
          RealType("unit", kMetersPerUnitRange),
          WholeType("numStates", kNumStates),
          WholeType("stateNumber", kStates),
          WholeType("nextState", kNextStates),
          WholeType("numLights", kNumLights),
          WholeType("lightNumber", kLights),
          WholeType("tightnessNumber", kTightness),
          WholeType("linkCount", kNumLinks),
          WholeType("cylinderSides", kCylinderSides),
          WholeType("polygonSides", kPolygonSides),
          WordType("boolean", "true|false|1|0"),
          WordType("triggerCause", WordsPattern(scene::kTriggerCauses)),
          WordType("toolAction", WordsPattern(scene::kToolActions)),
          WordType("noYes", WordsPattern(kNoYes)),
          WordType("handTool", WordsPattern(kHandTool)),
          WordType("color", ColorPattern()),
          WordType("vector", NumbersPattern(3)),
          WordType("matrix", NumbersPattern(9))};
}

std::string RestrictionText(const ValueType& type, const std::string& indent) {
  std::string text = indent + "<xs:restriction base=\"" + type.base + "\">\n";
  for (const std::string& facet : type.facets) text += indent + "  " + facet + "\n";
  return text + indent + "</xs:restriction>\n";
}

std::string TypeText(const ValueType& type, bool allows_expressions) {
  std::string text = "  <xs:simpleType name=\"" + type.name + "\">\n";
  const std::string other =
      type.or_type.empty() && allows_expressions ? "expression" : type.or_type;
  if (other.empty()) {
    text += RestrictionText(type, "    ");
  } else {
    text += "    <xs:union memberTypes=\"" + other + "\">\n      <xs:simpleType>\n" +
            RestrictionText(type, "        ") + "      </xs:simpleType>\n    </xs:union>\n";
  }
  return text + "  </xs:simpleType>\n";
}

}  // namespace

std::string ValueSchema(bool allows_expressions) {
  std::string text = R"(<?xml version="1.0" encoding="UTF-8"?>
<!-- Generated from src/scene_xml/value_ranges.h; `SMILE_APPROVE=1 smile_schema_test` does it.
     The values of attributes)";
  text += allows_expressions ? ", or an expression in their place. -->" : ". -->";
  text += R"(
<xs:schema xmlns:xs="http://www.w3.org/2001/XMLSchema" xmlns="http://synapse.cs.umd.edu/tabletop-xml"
           targetNamespace="http://synapse.cs.umd.edu/tabletop-xml" elementFormDefault="qualified">
)";
  if (allows_expressions) {
    const ValueType expression{"expression", "xs:string", {Facet("pattern", "[^$]*[$][^$]+[$].*")}};
    text += TypeText(expression, /*allows_expressions=*/false);
  }
  for (const ValueType& type : ValueTypes()) text += TypeText(type, allows_expressions);
  return text + "</xs:schema>\n";
}

}  // namespace smile::scene_xml
