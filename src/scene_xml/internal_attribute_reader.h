#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "math/color.h"
#include "math/rigid_transform.h"
#include "scene_xml/internal_reading.h"
#include "scene_xml/internal_scene_element.h"
#include "scene_xml/value_ranges.h"

namespace smile::scene_xml {

/// Reads the attributes of one element: text to values, with defaults, ranges and units.
///
/// Each fault becomes a finding and the default is used on, so that the rest of the file is still
/// looked at. Asking for an attribute makes it known; RefuseUnknown() then reports those nobody
/// asked for.
class AttributeReader {
 public:
  AttributeReader(const SceneElement& element, Reading* reading)
      : element_(element), reading_(*reading) {}

  /// As written; nullptr when it is not there.
  const std::string* Text(std::string_view name);
  /// As written, for one that must be there.
  std::string RequiredText(std::string_view name);
  /// As written, for one that must be there and must be a name: letters, digits and `_`.
  std::string RequiredName(std::string_view name);
  /// As written, and a name, if it is there.
  std::string OptionalName(std::string_view name);
  /// Letters, digits and `_`, or a name the program gave (`obj#3`).
  std::string Id();
  /// The id of an element that must have one of its own: what the registry makes of Id().
  std::string ClaimedId();
  /// The id of another element, as Id() has them; may be empty.
  std::string Reference(std::string_view name);

  bool Boolean(std::string_view name, bool fallback);
  int Count(std::string_view name, int fallback, Range<int> range);
  double Number(std::string_view name, double fallback, Range<double> range);
  smile::Color Color(std::string_view fallback = "gray");

  /// A positive length; units in the file, metres here.
  double Span(std::string_view name, double fallback_units);
  Vector3 Spans(double fallback_units);  ///< `xspan`, `yspan`, `zspan`
  /// A length that may be 0 as well.
  double SpanOrZero(std::string_view name, double fallback_units);
  /// A length that may be negative.
  double Distance(std::string_view name, double fallback_units);
  /// `(x,y,z)` that must be there.
  Vector3 Point(std::string_view name);
  /// `(x,y,z)` of any length but 0; no unit.
  Vector3 Direction(std::string_view name, const Vector3& fallback);
  /// `file`, which must be there, and `scale`: a mesh as large as scenes may have things.
  scene::Custom Custom();
  /// `location` and `rotation`: this element in its parent.
  RigidTransform Pose();
  /// The same; without a `location` it is at the parent's origin.
  RigidTransform PoseOrOrigin();

  /// Refuses an attribute that belongs elsewhere, with better words than RefuseUnknown() has.
  void Forbid(std::string_view name, const std::string& expected);
  void RefuseUnknown();
  /// Adds `found name="value", expected …`, or `found the default of name, …`; nothing for a value
  /// whose expression has been reported.
  void Refuse(std::string_view name, const std::string& expected);
  /// Adds a fault of the whole element.
  void AddFinding(const std::string& message);
  /// Whether anything was wrong so far: then values are defaults and need not fit together.
  bool has_findings() const { return has_findings_; }

 private:
  Matrix3 Rotation();
  Matrix3 RotationMatrix();

  const SceneElement& element_;
  Reading& reading_;
  std::vector<std::string_view> known_, forbidden_;  // literals of the callers
  bool has_findings_ = false;
};

}  // namespace smile::scene_xml
