#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "math/color.h"
#include "math/rigid_transform.h"
#include "scene_xml/internal_reading_context.h"
#include "scene_xml/internal_scene_element.h"
#include "scene_xml/value_ranges.h"

namespace smile::scene_xml {

/// Reader of the attributes of one element: text to values, with defaults, ranges and units.
///
/// Each fault becomes a finding and is replaced by the default, so that the rest of the file is
/// still read. Asking for an attribute makes it known; RefuseUnknown() reports all others.
class AttributeReader {
 public:
  AttributeReader(const SceneElement& element, ReadingContext* reading)
      : element_(element), reading_(*reading) {}

  /// Returns the text as written; nullptr if the attribute is missing.
  const std::string* Text(std::string_view name);
  /// Returns the text of a required attribute.
  std::string RequiredText(std::string_view name);
  /// Returns the text of a required attribute that must be a name: letters, digits and `_`.
  std::string RequiredName(std::string_view name);
  /// Returns the text of an optional attribute that must be a name; empty if it is missing.
  std::string OptionalName(std::string_view name);
  /// Returns the id: letters, digits and `_`, or an id that the program assigned (`obj#3`).
  std::string Id();
  /// Returns a unique id for an element that needs one: the registry's answer to Id().
  std::string ClaimedId();
  /// Returns the id of another element, in the form of Id(); may be empty.
  std::string Reference(std::string_view name);

  bool Boolean(std::string_view name, bool fallback);
  /// Returns the number of one of these words.
  int Choice(std::string_view name, std::span<const std::string_view> words, int fallback);
  int Count(std::string_view name, int fallback, Range<int> range);
  double Number(std::string_view name, double fallback, Range<double> range);
  smile::Color Color(std::string_view fallback = "gray", std::string_view name = "color");

  /// Returns a positive length [m]; the file has units.
  double Span(std::string_view name, double fallback_units);
  Vector3 Spans(double fallback_units);  ///< `xspan`, `yspan`, `zspan`
  /// Returns a length that is positive or 0 [m].
  double SpanOrZero(std::string_view name, double fallback_units);
  /// Returns a length that may be negative [m].
  double Distance(std::string_view name, double fallback_units);
  /// Returns a required point `(x,y,z)` [m].
  Vector3 Point(std::string_view name);
  /// Returns a direction `(x,y,z)` of any length but 0, without unit.
  Vector3 Direction(std::string_view name, const Vector3& fallback);
  /// Returns the mesh of `file`, which is required, scaled by `scale`; its extent must be in the
  /// range of lengths.
  scene::Custom Custom();
  /// Returns X_PE from `location` and `rotation`: the pose of this element E in its parent P [m].
  RigidTransform Pose();
  /// Returns the same pose; without a `location`, the element is at the parent's origin.
  RigidTransform PoseOrOrigin();

  /// Refuses an attribute that belongs elsewhere, with a more specific message than
  /// RefuseUnknown().
  void Forbid(std::string_view name, const std::string& expected);
  void RefuseUnknown();
  /// Adds `found name="value", expected …`, or `found the default of name, …`; nothing for a value
  /// whose expression has been reported.
  void Refuse(std::string_view name, const std::string& expected);
  /// Adds a finding about the whole element.
  void AddFinding(const std::string& message);
  /// True if there was any fault: then values are defaults and need not be consistent.
  bool has_findings() const { return has_findings_; }

 private:
  Matrix3 Rotation();
  Matrix3 RotationMatrix();

  const SceneElement& element_;
  ReadingContext& reading_;
  std::vector<std::string_view> known_, forbidden_;  // literals of the callers
  bool has_findings_ = false;
};

}  // namespace smile::scene_xml
