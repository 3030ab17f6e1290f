#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "math/color.h"
#include "math/rigid_transform.h"
#include "scene_xml/internal_reading.h"
#include "scene_xml/internal_xml_tree.h"

namespace smile::scene_xml {

/// Both ends belong to the range.
template <class Number>
struct Range {
  Number least, most;
};

/// Reads the attributes of one element: text to values, with defaults, ranges and units.
///
/// Each fault becomes a finding and the default is used on, so that the rest of the file is still
/// looked at. Asking for an attribute makes it known; RefuseUnknown() then reports those nobody
/// asked for.
class AttributeReader {
 public:
  AttributeReader(const XmlElement& element, Reading* reading)
      : element_(element), reading_(*reading) {}

  /// As written; nullptr when it is not there.
  const std::string* Text(std::string_view name);
  /// As written, for one that must be there.
  std::string RequiredText(std::string_view name);
  /// As written, for one that must be there and must be a name: letters, digits and `_`.
  std::string RequiredName(std::string_view name);
  /// Letters, digits and `_`, or a name the program gave (`obj#3`).
  std::string Id();

  bool Boolean(std::string_view name, bool fallback);
  int Count(std::string_view name, int fallback, Range<int> range);
  double Number(std::string_view name, double fallback, Range<double> range);
  smile::Color Color();

  /// A positive length; units in the file, metres here.
  double Span(std::string_view name, double fallback_units);
  Vector3 Spans(double fallback_units);  ///< `xspan`, `yspan`, `zspan`
  /// `file`, which must be there, and `scale`: a mesh as large as scenes may have things.
  scene::Custom Custom();
  /// `location` and `rotation`: this element in its parent.
  RigidTransform Pose();

  /// Refuses an attribute that belongs elsewhere, with better words than RefuseUnknown() has.
  void Forbid(std::string_view name, const std::string& expected);
  void RefuseUnknown();
  /// Adds `found name="value", expected …`, or `found the default of name, …`; nothing for a value
  /// whose expression has been reported.
  void Refuse(std::string_view name, const std::string& expected);
  /// Whether anything was wrong so far: then values are defaults and need not fit together.
  bool has_findings() const { return has_findings_; }

 private:
  void AddFinding(const std::string& message);
  Vector3 Location();
  Matrix3 Rotation();
  Matrix3 RotationMatrix();

  const XmlElement& element_;
  Reading& reading_;
  std::vector<std::string_view> known_, forbidden_;  // literals of the callers
  bool has_findings_ = false;
};

}  // namespace smile::scene_xml
