#include "scene_xml/scene_writer.h"

#include <charconv>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

#include "base/overloaded.h"
#include "base/wording.h"
#include "math/angles.h"
#include "scene_xml/internal_units.h"
#include "scene_xml/internal_values.h"
#include "scene_xml/internal_xml_tree.h"
#include "scene_xml/mesh_files.h"

namespace smile::scene_xml {
namespace {

std::string Escaped(std::string_view text) {
  std::string escaped;
  for (char letter : text) {
    switch (letter) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      // A parser would turn these into blanks.
      case '\t':
        escaped += "&#9;";
        break;
      case '\n':
        escaped += "&#10;";
        break;
      case '\r':
        escaped += "&#13;";
        break;
      default:
        escaped += letter;
    }
  }
  return escaped;
}

/// The angles as text, when reading it gives back exactly `R`.
std::optional<std::string> AnglesText(const Matrix3& R) {
  const Vector3 angles_deg = FixedAxesAngles(R);
  // The angles come back with an error in their last digits; the number that was meant is round.
  for (int num_digits : {9, 12, 13, 14, 15, 17}) {
    std::string text = "(";
    Vector3 read_back;
    for (int i = 0; i < 3; ++i) {
      char buffer[64];
      const auto end = std::to_chars(buffer, buffer + sizeof buffer, angles_deg[i] + 0.0,
                                     std::chars_format::general, num_digits);
      read_back[i] = *ParseNumber<double>({buffer, end.ptr});
      text += (i ? "," : "") + std::string(buffer, end.ptr);
    }
    if (RotationFromFixedAxes(read_back) == R) return text + ")";
  }
  return std::nullopt;
}

class SceneWriter {
 public:
  SceneWriter(double meters_per_unit, std::vector<MeshFile> mesh_files)
      : meters_per_unit_(meters_per_unit), mesh_files_(std::move(mesh_files)) {}

  std::string Write(const scene::SceneSpec& scene, std::span<const std::string> origins) {
    text_ = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<tabletop";
    Attribute("xmlns", kSceneNamespace);
    Length("xspan", scene.table.x_span);
    Length("yspan", scene.table.y_span);
    // Only when it says something: programs older than this attribute refuse it.
    if (meters_per_unit_ != scene::kMetersPerUnit) {
      Attribute("metersPerUnit", NumberText(meters_per_unit_));
    }
    text_ += ">\n";
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
      if (i < origins.size()) Comment(origins[i], 1);
      Element(scene.objects[i].whole, &scene.objects[i], 1);
    }
    return std::move(text_) + "</tabletop>\n";
  }

 private:
  /// File names come from anywhere: two hyphens would end the comment, or break it.
  void Comment(std::string_view text, int depth) {
    Indent(depth);
    text_ += "<!-- ";
    for (char letter : text) {
      if (letter == '-' && text_.back() == '-') text_ += ' ';
      text_ += static_cast<unsigned char>(letter) < 0x20 ? '?' : letter;
    }
    text_ += " -->\n";
  }

  /// @param object  the whole object when `part` is one, else nullptr.
  void Element(const scene::Part& part, const scene::ObjectSpec* object, int depth) {
    const std::string_view name = NameOf(part.shape);
    Indent(depth);
    text_ += "<" + std::string(name);
    if (!part.id.empty()) Attribute("id", part.id);
    Pose(part.X_PE);
    std::visit([this](const auto& shape) { Sizes(shape); }, part.shape);
    const auto* composite = std::get_if<scene::Composite>(&part.shape);
    if (!composite) Attribute("color", ToString(part.color));
    if (object) {
      Attribute("mass", NumberText(object->mass));
      Touch(object->surface);
    }
    if (part.is_pointable) Attribute("pointable", "true");

    const std::size_t length_of_tag = text_.size();
    text_ += ">\n";
    const std::size_t length_when_empty = text_.size();
    if (object) Descriptions(*object, ShapeWord(part.shape, name), depth + 1);
    if (composite) {
      for (const scene::Part& child : composite->parts) Element(child, nullptr, depth + 1);
    }
    if (text_.size() == length_when_empty) {
      text_.resize(length_of_tag);
      text_ += "/>\n";
    } else {
      Indent(depth);
      text_ += "</" + std::string(name) + ">\n";
    }
  }

  /// Only what is not as usual: older programs refuse these attributes.
  void Touch(const scene::Surface& surface) {
    const scene::Surface usual;
    if (surface.friction != usual.friction) Attribute("friction", NumberText(surface.friction));
    if (surface.restitution != usual.restitution) {
      Attribute("restitution", NumberText(surface.restitution));
    }
    if (surface.rolling_friction) Length("rollingFriction", *surface.rolling_friction);
  }

  /// What the reader will say of the shape when nothing is written.
  std::string ShapeWord(const scene::Shape& shape, std::string_view element) const {
    const auto* custom = std::get_if<scene::Custom>(&shape);
    return custom ? WordOfMeshFile(FileOf(*custom)) : ShapeWordOf(shape, element);
  }

  /// All but the `shape` the reader adds by itself.
  void Descriptions(const scene::ObjectSpec& object, const std::string& shape, int depth) {
    for (const scene::Description& description : object.descriptions) {
      if (description.name == "shape" && description.value == shape) continue;
      Indent(depth);
      text_ += "<description";
      Attribute("name", description.name);
      Attribute("value", description.value);
      text_ += "/>\n";
    }
  }

  static std::string_view NameOf(const scene::Shape& shape) {
    return std::visit(
        Overloaded{[](const scene::Block&) { return "block"; },
                   [](const scene::Cylinder&) { return "cylinder"; },
                   [](const scene::Sphere&) { return "sphere"; },
                   [](const scene::Box&) { return "box"; },
                   [](const scene::Frustum&) { return "frustum"; },
                   [](const scene::Ring&) { return "ring"; },
                   [](const scene::Custom&) { return "custom"; },
                   [](const scene::Composite&) { return "composite"; },
                   [](const auto&) -> const char* { throw std::logic_error("not written yet"); }},
        shape);
  }

  void Sizes(const scene::Block& block) { Spans(block.size); }
  void Sizes(const scene::Cylinder& cylinder) {
    Length("radius", cylinder.radius);
    Length("yspan", cylinder.length);
    Attribute("sides", std::to_string(cylinder.sides));
  }
  void Sizes(const scene::Sphere& sphere) { Length("radius", sphere.radius); }
  void Sizes(const scene::Box& box) {
    Spans(box.size);
    Length("thickness", box.thickness);
  }
  void Sizes(const scene::Frustum& frustum) {
    Length("radiusTop", frustum.radius_top);
    Length("radiusBottom", frustum.radius_bottom);
    Length("zspan", frustum.height);
    Attribute("sides", std::to_string(frustum.sides));
  }
  void Sizes(const scene::Ring& ring) {
    Length("radiusOuter", ring.radius_outer);
    Length("radiusInner", ring.radius_inner);
    Length("zspan", ring.height);
    Attribute("sides", std::to_string(ring.sides));
  }
  void Sizes(const scene::Custom& custom) {
    Attribute("file", FileOf(custom));
    Length("scale", custom.scale);
  }
  void Sizes(const scene::Composite&) {}
  template <class Other>
  void Sizes(const Other&) {}

  std::string FileOf(const scene::Custom& custom) const {
    for (const MeshFile& file : mesh_files_) {
      if (file.mesh == custom.mesh) return std::string(kMeshFolder) + "/" + file.name;
    }
    return custom.file;
  }

  void Spans(const Vector3& size) {
    Length("xspan", size.x());
    Length("yspan", size.y());
    Length("zspan", size.z());
  }

  void Pose(const RigidTransform& X_PE) {
    const Vector3& p_PE = X_PE.translation();
    Attribute("location",
              "(" + Units(p_PE.x()) + "," + Units(p_PE.y()) + "," + Units(p_PE.z()) + ")");
    if (const std::optional<std::string> angles = AnglesText(X_PE.rotation())) {
      Attribute("rotation", *angles);
    } else {
      Attribute("rotationMatrix", MatrixText(X_PE.rotation()));
    }
  }

  static std::string MatrixText(const Matrix3& R) {
    std::string text;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        text += (text.empty() ? "(" : ",") + NumberText(R(row, column));
      }
    }
    return text + ")";
  }

  std::string Units(double meters) const { return UnitsText(meters, meters_per_unit_); }
  void Length(std::string_view name, double meters) { Attribute(name, Units(meters)); }
  void Attribute(std::string_view name, std::string_view value) {
    text_ += " " + std::string(name) + "=\"" + Escaped(value) + "\"";
  }
  void Indent(int depth) { text_.append(std::size_t{2} * depth, ' '); }

  double meters_per_unit_;
  std::vector<MeshFile> mesh_files_;  // none: meshes are where they are
  std::string text_;
};

}  // namespace

std::string WriteScene(const scene::SceneSpec& scene, std::span<const std::string> origins,
                       MeshNames mesh_names) {
  std::vector<MeshFile> files;
  if (mesh_names == MeshNames::kBeside) files = MeshFilesOf(scene);
  return SceneWriter(scene.meters_per_unit, std::move(files)).Write(scene, origins);
}

}  // namespace smile::scene_xml
