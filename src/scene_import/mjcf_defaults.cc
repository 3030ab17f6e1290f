#include <algorithm>
#include <cctype>
#include <numbers>
#include <utility>

#include "base/wording.h"
#include "scene_import/internal_mjcf_context.h"
#include "scene_import/internal_shapes.h"

namespace smile::scene_import {
namespace {

// Elements of MJCF may be as deep as XML allows; classes are copies of those around them.
constexpr int kMaxClassDepth = 32;
constexpr std::size_t kMaxClasses = 1000;
constexpr std::size_t kMaxClassBytes = 1 << 16;

bool IsEulerSequence(const std::string& letters) {
  return letters.size() == 3 && letters.find_first_not_of("xyzXYZ") == std::string::npos;
}

/// Reads a yes or no of MJCF.
bool TruthOf(ElementReader* reader, std::string_view name, bool usual) {
  const std::string word = reader->Text(name, usual ? "true" : "false");
  if (word != "true" && word != "false") {
    reader->Refuse("found " + std::string(name) + "=" + Quoted(word) + ", expected true or false");
  }
  return word == "true";
}

/// Number of ways in which the rotation of an element is written.
int NumRotations(const ElementReader& reader) {
  int count = 0;
  for (const char* name : {"quat", "axisangle", "xyaxes", "zaxis", "euler"}) {
    count += reader.Has(name) ? 1 : 0;
  }
  return count;
}

Matrix3 EulerRotation(const std::vector<double>& angles, const MjcfCompiler& compiler) {
  Matrix3 R = Matrix3::Identity();
  for (std::size_t i = 0; i < 3; ++i) {
    const char letter = compiler.euler_sequence[i];
    const auto axis = std::string_view("xyz").find(
        static_cast<char>(std::tolower(static_cast<unsigned char>(letter))));
    const Matrix3 turn = Eigen::AngleAxisd(angles[i] * compiler.radians_per_angle,
                                           Vector3::Unit(static_cast<Eigen::Index>(axis)))
                             .toRotationMatrix();
    const bool is_about_turned_axes = letter >= 'a';
    R = is_about_turned_axes ? Matrix3(R * turn) : Matrix3(turn * R);
  }
  return R;
}

/// Returns the rotation whose x axis is `x`, and whose y axis lies in the plane of both.
std::optional<Matrix3> RotationOfAxes(const Vector3& x, const Vector3& y) {
  const Vector3 z = x.cross(y);
  if (!(x.norm() > 1e-9) || !(z.norm() > 1e-9)) return std::nullopt;
  Matrix3 R;
  R << x.normalized(), z.cross(x).normalized(), z.normalized();
  return R;
}

std::optional<Matrix3> MjcfRotationOf(ElementReader* reader, const MjcfCompiler& compiler) {
  if (const auto q = reader->Numbers("quat", 4, 4); !q.empty()) {
    const Quaternion rotation(q[0], q[1], q[2], q[3]);
    if (!(rotation.norm() > 1e-9)) return std::nullopt;
    return rotation.normalized().toRotationMatrix();
  }
  if (const auto a = reader->Numbers("axisangle", 4, 4); !a.empty()) {
    const Vector3 axis(a[0], a[1], a[2]);
    if (!(axis.norm() > 1e-9)) return std::nullopt;
    return Eigen::AngleAxisd(a[3] * compiler.radians_per_angle, axis.normalized())
        .toRotationMatrix();
  }
  if (const auto a = reader->Numbers("xyaxes", 6, 6); !a.empty()) {
    return RotationOfAxes({a[0], a[1], a[2]}, {a[3], a[4], a[5]});
  }
  if (const auto z = reader->Numbers("zaxis", 3, 3); !z.empty()) {
    const Vector3 axis(z[0], z[1], z[2]);
    if (!(axis.norm() > 1e-9)) return std::nullopt;
    return Quaternion::FromTwoVectors(Vector3::UnitZ(), axis).toRotationMatrix();
  }
  if (const auto e = reader->Numbers("euler", 3, 3); !e.empty()) return EulerRotation(e, compiler);
  return Matrix3::Identity();
}

}  // namespace

void MjcfDefaults::Add(const SourceElement& element, ImportFindings* findings) {
  const std::string* name = element.FindAttribute("class");
  const std::string top = name ? *name : "main";
  AddClass(element, top, classes_["main"], 0, findings);
  // Elements without a class have that at the top, whatever its name.
  classes_["main"] = classes_[top];
}

void MjcfDefaults::AddClass(const SourceElement& element, const std::string& name,
                            DefaultClass inherited, int depth, ImportFindings* findings) {
  if (depth > kMaxClassDepth || classes_.size() > kMaxClasses) {
    findings->Refuse(element.place(), "found more classes, or deeper ones, than the import allows");
    return;
  }
  for (const SourceElement& child : element.children) {
    if (child.name == "default") continue;
    for (const auto& [key, value] : child.attributes) inherited[child.name][key] = value;
  }
  std::size_t num_bytes = 0;
  for (const auto& [element_name, attributes] : inherited) {
    for (const auto& [key, value] : attributes) num_bytes += key.size() + value.size();
  }
  if (num_bytes > kMaxClassBytes) {
    return findings->Refuse(
        element.place(), "found a class of more than " + std::to_string(kMaxClassBytes) + " bytes");
  }
  classes_[name] = inherited;
  for (const SourceElement& child : element.children) {
    if (child.name != "default") continue;
    const std::string* inner = child.FindAttribute("class");
    if (!inner) {
      findings->Refuse(child.place(), "found no class, expected its name");
      continue;
    }
    AddClass(child, *inner, inherited, depth + 1, findings);
  }
}

SourceElement MjcfDefaults::Completed(const SourceElement& element, const std::string& child_class,
                                      ImportFindings* findings) const {
  const std::string* own = element.FindAttribute("class");
  const std::string name = own ? *own : child_class.empty() ? "main" : child_class;
  SourceElement completed = element;
  const auto found = classes_.find(name);
  if (found == classes_.end()) {
    findings->Refuse(element.place(),
                     "found the class " + Quoted(name) + ", expected one of a default element");
    return completed;
  }
  const auto attributes = found->second.find(element.name);
  if (attributes == found->second.end()) return completed;
  const bool is_turned = NumRotations(ElementReader(element, findings)) > 0;
  for (const auto& [key, value] : attributes->second) {
    // One way to write a rotation replaces the others.
    const bool is_rotation =
        key == "quat" || key == "axisangle" || key == "xyaxes" || key == "zaxis" || key == "euler";
    if (element.FindAttribute(key) || (is_rotation && is_turned)) continue;
    completed.attributes.push_back({key, value});
  }
  return completed;
}

void ReadMjcfCompiler(const SourceElement& element, ImportFindings* findings,
                      MjcfCompiler* compiler) {
  ElementReader reader(element, findings);
  const std::string angle = reader.Text("angle");
  if (angle == "radian") compiler->radians_per_angle = 1;
  if (angle == "degree") compiler->radians_per_angle = std::numbers::pi / 180;
  if (!angle.empty() && angle != "radian" && angle != "degree") {
    reader.Refuse("found angle=" + Quoted(angle) + ", expected degree or radian");
  }
  const std::string sequence = reader.Text("eulerseq", compiler->euler_sequence);
  if (IsEulerSequence(sequence)) {
    compiler->euler_sequence = sequence;
  } else {
    reader.Refuse("found eulerseq=" + Quoted(sequence) + ", expected three of xyzXYZ");
  }
  compiler->has_automatic_limits = TruthOf(&reader, "autolimits", compiler->has_automatic_limits);
  const std::string from_shapes = reader.Text("inertiafromgeom", "auto");
  compiler->ignores_inertial = from_shapes == "true";
  compiler->needs_inertial = from_shapes == "false";
  const std::string assets = reader.Text("assetdir", compiler->mesh_folder);
  compiler->mesh_folder = reader.Text("meshdir", assets);
  if (reader.Text("coordinate", "local") != "local") {
    reader.Refuse("found coordinate=\"global\", expected local ones, as of MuJoCo 2.3.4");
  }
  reader.RemarkRest({"texturedir", "fusestatic", "discardvisual", "balanceinertia", "strippath",
                     "usethread", "convexhull", "boundmass", "boundinertia", "exactmeshinertia"});
}

RigidTransform MjcfPoseOf(ElementReader* reader, const MjcfCompiler& compiler) {
  if (NumRotations(*reader) > 1) {
    reader->Refuse("found more than one of quat, axisangle, xyaxes, zaxis and euler");
  }
  const std::optional<Matrix3> R = MjcfRotationOf(reader, compiler);
  if (!R) reader->Refuse("found a rotation of length 0, expected an axis or a quaternion");
  const Vector3 p = reader->Vector("pos", Vector3::Zero());
  IsPosition(p, reader->place(), &reader->findings());
  return {R.value_or(Matrix3::Identity()), p};
}

}  // namespace smile::scene_import
