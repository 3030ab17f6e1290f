#include "scene_xml/internal_attribute_reader.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/wording.h"
#include "math/angles.h"
#include "scene_xml/internal_units.h"
#include "scene_xml/internal_values.h"

// The border at which text becomes values in meters and radians. Every function follows the same
// pattern: missing means the default, faulty means a finding and the default, so that reading
// continues and one run lists all faults of a file.

namespace smile::scene_xml {
namespace {

// Range of the largest absolute component of a direction: its length then neither overflows nor
// underflows.
constexpr Range<double> kDirectionSize{1e-6, 1e6};
// Largest entry of R R^T - I for a matrix that counts as a rotation.
constexpr double kRotationTolerance = 1e-9;

template <class Number>
bool Contains(const Range<Number>& range, Number value) {
  return value >= range.least && value <= range.most;
}

bool Contains(const std::vector<std::string_view>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

template <class Number>
std::string Wording(const Range<Number>& range) {
  return "from " + PlainNumberText(static_cast<double>(range.least)) + " to " +
         PlainNumberText(static_cast<double>(range.most));
}

// A determinant of -1 would be a reflection.
bool IsRotation(const Matrix3& R) {
  // The rows of a rotation are orthonormal.
  const Matrix3 error = R * R.transpose() - Matrix3::Identity();
  return error.cwiseAbs().maxCoeff() <= kRotationTolerance && R.determinant() > 0;
}

/// Returns the matrix without negative zeros, which the formulas produce for simple angles: equal
/// matrices have equal bits.
Matrix3 WithoutNegativeZeros(const Matrix3& R) { return R.array() + 0.0; }

}  // namespace

void AttributeReader::AddFinding(const std::string& message) {
  has_findings_ = true;
  reading_.findings->Add(element_.place, AddressOf(element_), message);
}

void AttributeReader::Refuse(std::string_view name, const std::string& expected) {
  // A value whose expression failed has a finding already.
  for (const SceneAttribute& attribute : element_.attributes) {
    if (attribute.name == name && attribute.is_faulty) {
      has_findings_ = true;
      return;
    }
  }
  const std::string* text = element_.FindAttribute(name);
  const std::string found =
      text ? std::string(name) + "=" + Quoted(*text) : "the default of " + std::string(name);
  AddFinding("found " + found + ", expected " + expected);
}

const std::string* AttributeReader::Text(std::string_view name) {
  // Asking makes an attribute known, present or not, so that messages can list it.
  if (!Contains(known_, name)) known_.push_back(name);
  return element_.FindAttribute(name);
}

std::string AttributeReader::RequiredText(std::string_view name) {
  if (const std::string* text = Text(name)) return *text;
  AddFinding("found no " + std::string(name) + ", expected " + std::string(name) + "=\"…\"");
  return {};
}

std::string AttributeReader::RequiredName(std::string_view name) {
  std::string text = RequiredText(name);
  // A missing attribute has a finding already.
  if (Text(name) && (text.empty() || !IsId(text))) {
    Refuse(name, "letters A-Z and a-z, digits and _, 1 to 100");
  }
  return text;
}

std::string AttributeReader::OptionalName(std::string_view name) {
  const std::string* text = Text(name);
  return text && !text->empty() ? RequiredName(name) : "";
}

// An id has the same form wherever it occurs: as the element's own and as a reference to it.
std::string AttributeReader::Id() { return Reference("id"); }

std::string AttributeReader::Reference(std::string_view name) {
  const std::string* text = Text(name);
  if (!text || IsId(*text) || IsRenamedId(*text)) return text ? *text : "";
  Refuse(name, "letters A-Z and a-z, digits and _, at most 100");
  return {};
}

std::string AttributeReader::ClaimedId() {
  std::string wanted = Id();
  // An id with # comes from a scene that this program wrote. It must not change, as recordings
  // refer to it.
  if (!IsRenamedId(wanted)) return reading_.ids.Claim(wanted);
  if (!reading_.ids.ClaimExactly(wanted)) {
    Refuse("id", "one that is not used yet: an id with # is never changed");
  }
  return wanted;
}

bool AttributeReader::Boolean(std::string_view name, bool fallback) {
  const std::string* text = Text(name);
  if (!text) return fallback;
  // An empty text is no value: unlike a missing attribute it is refused.
  const std::optional<bool> value = ParseBoolean(*text);
  if (!value) Refuse(name, "true, false, 1 or 0");
  return value.value_or(fallback);
}

int AttributeReader::Choice(std::string_view name, std::span<const std::string_view> words,
                            int fallback) {
  const std::string* text = Text(name);
  if (!text) return fallback;
  const auto word = std::ranges::find(words, *text);
  if (word != words.end()) return static_cast<int>(word - words.begin());
  Refuse(name, OneOf(words) + DidYouMean(*text, words));
  return fallback;
}

int AttributeReader::Count(std::string_view name, int fallback, Range<int> range) {
  const std::string* text = Text(name);
  if (!text) return fallback;
  const std::optional<int> value = ParseCount(*text);
  if (value && Contains(range, *value)) return *value;
  Refuse(name, "a whole number " + Wording(range));
  return fallback;
}

double AttributeReader::Number(std::string_view name, double fallback, Range<double> range) {
  const std::string* text = Text(name);
  if (!text) return fallback;
  const std::optional<double> value = ParseNumber<double>(*text);
  if (value && Contains(range, *value)) return *value;
  Refuse(name, "a number " + Wording(range));
  return fallback;
}

Color AttributeReader::Color(std::string_view fallback, std::string_view name) {
  const std::string* text = Text(name);
  if (!text) return *ParseColor(fallback);
  if (const std::optional<smile::Color> color = ParseColor(*text)) return *color;
  const std::vector<std::string_view> names = ColorNames();
  Refuse(name, "#RRGGBB, " + OneOf(names) + DidYouMean(*text, names));
  return {};
}

double AttributeReader::Span(std::string_view name, double fallback_units) {
  long double units = fallback_units;
  if (const std::string* text = Text(name)) {
    // The wider type, for lengths that must survive writing to the last bit (see internal_units.h).
    const std::optional<long double> value = ParseNumber<long double>(*text);
    if (value && Contains(kSpanUnits, *value)) {
      units = *value;
    } else {
      Refuse(name, "a length " + Wording(kSpanUnits) + " units");
    }
  }
  return MetersFromUnits(units, reading_.meters_per_unit);
}

Vector3 AttributeReader::Spans(double fallback_units) {
  // One by one: the order of findings is that of these lines.
  const double x = Span("xspan", fallback_units);
  const double y = Span("yspan", fallback_units);
  const double z = Span("zspan", fallback_units);
  return {x, y, z};
}

double AttributeReader::SpanOrZero(std::string_view name, double fallback_units) {
  const std::string* text = Text(name);
  // Zero is outside kSpanUnits, whose lower limit keeps shapes from degenerating.
  if (text && ParseNumber<double>(*text) == 0.0) return 0;
  return Span(name, fallback_units);
}

double AttributeReader::Distance(std::string_view name, double fallback_units) {
  long double units = fallback_units;
  if (const std::string* text = Text(name)) {
    const std::optional<long double> value = ParseNumber<long double>(*text);
    if (value && Contains(kLocationUnits, *value)) {
      units = *value;
    } else {
      Refuse(name, "a number " + Wording(kLocationUnits));
    }
  }
  return MetersFromUnits(units, reading_.meters_per_unit);
}

scene::Custom AttributeReader::Custom() {
  scene::Custom custom{.file = RequiredText("file")};
  custom.scale = Span("scale", 1);
  if (!Text("file")) return custom;
  if (std::string fault;
      !reading_.meshes->Fetch(reading_.findings->sources(), element_.place, &custom, &fault)) {
    AddFinding("found file=" + Quoted(custom.file) + fault);
    return custom;
  }
  // The range of lengths applies to the mesh as scaled, in units of the scene.
  double farthest_units = 0;
  for (const Eigen::Vector3f& vertex : custom.mesh->surface.vertices) {
    farthest_units = std::max(farthest_units, vertex.cast<double>().cwiseAbs().maxCoeff());
  }
  farthest_units *= custom.scale / reading_.meters_per_unit;
  if (!Contains(kSpanUnits, static_cast<long double>(farthest_units))) {
    Refuse("scale", "a scale with which the mesh extends " + Wording(kSpanUnits) +
                        " units from its origin; its present extent is " +
                        PlainNumberText(farthest_units));
  }
  return custom;
}

RigidTransform AttributeReader::Pose() {
  const Vector3 p_PE = Point("location");
  return {Rotation(), p_PE};
}

RigidTransform AttributeReader::PoseOrOrigin() {
  if (Text("location")) return Pose();
  return {Rotation(), Vector3::Zero()};
}

Vector3 AttributeReader::Point(std::string_view name) {
  const std::string* text = Text(name);
  if (!text) {
    AddFinding("found no " + std::string(name) + ", expected " + std::string(name) +
               "=\"(x,y,z)\"");
    return Vector3::Zero();
  }
  const auto units = ParseNumbers<3, long double>(*text);
  const auto is_in_range = [](long double value) { return Contains(kLocationUnits, value); };
  if (!units || !std::all_of(units->begin(), units->end(), is_in_range)) {
    Refuse(name, "(x,y,z), three numbers " + Wording(kLocationUnits));
    return Vector3::Zero();
  }
  const auto meters = [&](int i) { return MetersFromUnits((*units)[i], reading_.meters_per_unit); };
  return {meters(0), meters(1), meters(2)};
}

Vector3 AttributeReader::Direction(std::string_view name, const Vector3& fallback) {
  const std::string* text = Text(name);
  if (!text) return fallback;
  const auto numbers = ParseNumbers<3, double>(*text);
  if (numbers) {
    const Vector3 direction((*numbers)[0], (*numbers)[1], (*numbers)[2]);
    // The direction keeps its length: normalizing here would change its digits in a written scene.
    const double size = direction.cwiseAbs().maxCoeff();
    if (Contains(kDirectionSize, size)) return direction;
  }
  Refuse(name, "(x,y,z), three numbers, the largest of which is " + Wording(kDirectionSize));
  return fallback;
}

Matrix3 AttributeReader::Rotation() {
  const std::string* text = Text("rotation");
  // Programs write the matrix where angles cannot express a rotation exactly; people write angles.
  if (Text("rotationMatrix")) {
    if (text) Refuse("rotation", "either rotation or rotationMatrix, not both");
    return RotationMatrix();
  }
  if (!text) return Matrix3::Identity();
  const auto angles_deg = ParseNumbers<3, double>(*text);
  const auto is_in_range = [](double angle) { return Contains(kAngleDegrees, angle); };
  if (!angles_deg || !std::all_of(angles_deg->begin(), angles_deg->end(), is_in_range)) {
    Refuse("rotation", "(a,b,c), three angles in degrees " + Wording(kAngleDegrees));
    return Matrix3::Identity();
  }
  return WithoutNegativeZeros(
      RotationFromFixedAxes({(*angles_deg)[0], (*angles_deg)[1], (*angles_deg)[2]}));
}

Matrix3 AttributeReader::RotationMatrix() {
  const auto numbers = ParseNumbers<9, double>(*Text("rotationMatrix"));
  if (numbers) {
    const Matrix3 R =
        Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(numbers->data());
    // Taken as it is, without correction, so that reading and writing keep every bit.
    if (IsRotation(R)) return R;
  }
  Refuse("rotationMatrix", "nine numbers in parentheses, row by row, that make a rotation");
  return Matrix3::Identity();
}

void AttributeReader::Forbid(std::string_view name, const std::string& expected) {
  // RefuseUnknown() would report it again otherwise.
  forbidden_.push_back(name);
  if (element_.FindAttribute(name)) Refuse(name, expected);
}

void AttributeReader::RefuseUnknown() {
  std::sort(known_.begin(), known_.end());
  for (const SceneAttribute& attribute : element_.attributes) {
    if (Contains(known_, attribute.name) || Contains(forbidden_, attribute.name)) continue;
    // Suggestions for misspelled names are expensive, and would not be listed.
    if (reading_.findings->is_full()) return AddFinding("");  // only notes that there are more
    AddFinding("found attribute " + Quoted(attribute.name) + ", expected " + OneOf(known_) +
               DidYouMean(attribute.name, known_));
  }
}

}  // namespace smile::scene_xml
