#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include "base/wording.h"
#include "scene_import/internal_import_table.h"
#include "scene_import/internal_source_element.h"

namespace smile::scene_import {
namespace {

constexpr double kLevel = 1e-6;
constexpr double kUsualMargin = 0.2;  ///< of an endless ground around the objects [m]
constexpr double kMaxGroundSpan = 20;

/// Returns a length for people, without what rounding adds to it.
std::string MetersText(double length) { return NumberText(std::round(length * 1e9) / 1e9 + 0.0); }

bool ContainsTable(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char letter) {
    return static_cast<char>(std::tolower(letter));
  });
  return text.find("table") != std::string::npos;
}

/// Static shape that may be the table.
struct Candidate {
  std::size_t object = 0, shape = 0;
  RigidTransform X_WT;
  double x_span = 0, y_span = 0;
  double thickness = 0;  ///< 0: a plane

  /// A box is better than a plane, a larger one than a smaller one.
  std::pair<bool, double> rank() const { return {thickness > 0, x_span * y_span}; }
};

/// Turns z up, with x where the shape has it.
RigidTransform LevelPose(const RigidTransform& X_WE, double top) {
  const Vector3 x = X_WE.rotation().col(0);
  const double yaw = std::atan2(x.y(), x.x());
  Matrix3 R = Matrix3::Identity();
  if (std::abs(yaw) > 1e-12) R = Eigen::AngleAxisd(yaw, Vector3::UnitZ()).toRotationMatrix();
  return {R, X_WE * Vector3(0, 0, top)};
}

/// Returns the shape as a table, if it is level.
std::optional<Candidate> CandidateOf(const RigidTransform& X_WE, const ForeignShape& shape) {
  if (!(X_WE.rotation()(2, 2) > 1 - kLevel)) return std::nullopt;
  if (const auto* block = std::get_if<scene::Block>(&shape.geometry)) {
    if (!shape.collides) return std::nullopt;
    return Candidate{.X_WT = LevelPose(X_WE, block->size.z() / 2),
                     .x_span = block->size.x(),
                     .y_span = block->size.y(),
                     .thickness = block->size.z()};
  }
  if (const auto* plane = std::get_if<GroundPlane>(&shape.geometry)) {
    return Candidate{.X_WT = LevelPose(X_WE, 0), .x_span = plane->x_span, .y_span = plane->y_span};
  }
  return std::nullopt;
}

std::optional<Candidate> BestTable(const std::string& name, const MergedWorld& world) {
  std::optional<Candidate> best;
  for (std::size_t i = 0; i < world.objects.size(); ++i) {
    const MergedObject& object = world.objects[i];
    if (!object.is_static) continue;
    for (std::size_t k = 0; k < object.shapes.size(); ++k) {
      const ForeignShape& shape = object.shapes[k];
      const bool is_named = name.empty() ? ContainsTable(object.name) || ContainsTable(shape.name)
                                         : object.name == name || shape.name == name;
      std::optional<Candidate> candidate = CandidateOf(object.X_WO * shape.X_BE, shape);
      const bool is_ground = candidate && candidate->thickness == 0 && name.empty();
      if (!candidate || !(is_named || is_ground)) continue;
      candidate->object = i;
      candidate->shape = k;
      if (!best || candidate->rank() > best->rank()) best = candidate;
    }
  }
  return best;
}

/// Returns the span of a ground without end: all objects stand on it.
double GroundSpan(const MergedWorld& world, const RigidTransform& X_WT, int axis, double usual) {
  double farthest = usual / 2 - kUsualMargin;
  for (const MergedObject& object : world.objects) {
    const Vector3 p = X_WT.inverse() * object.X_WO.translation();
    farthest = std::max(farthest, std::abs(p[axis]));
  }
  return std::min(2 * (farthest + kUsualMargin), kMaxGroundSpan);
}

/// Returns the color of a shape: its own, or of what is drawn at the same place.
std::optional<Color> ColorOfTable(const MergedObject& object, const ForeignShape& table) {
  for (const ForeignShape& shape : object.shapes) {
    if (shape.is_seen && shape.color && shape.geometry == table.geometry) return shape.color;
  }
  return table.color;
}

void RemarkTable(const ForeignShape& shape, const Candidate& table, const scene::TableSpec& spec,
                 ImportFindings* findings) {
  const Vector3 p = table.X_WT.translation();
  if (p.norm() > 1e-12 || !table.X_WT.rotation().isIdentity(1e-12)) {
    findings->Remark(shape.place, "changed: the center of this table's top, (" + MetersText(p.x()) +
                                      ", " + MetersText(p.y()) + ", " + MetersText(p.z()) +
                                      ") m, is the origin of the scene");
  }
  if (table.thickness > 0 && std::abs(table.thickness - spec.thickness) > 1e-9) {
    findings->Remark(shape.place, "changed: the table is " + MetersText(spec.thickness) +
                                      " m thick in SMILE, and not " + MetersText(table.thickness) +
                                      " m");
  }
  if (table.thickness == 0) {
    findings->Remark(shape.place, "changed: the ground is a table of " + MetersText(spec.x_span) +
                                      " m x " + MetersText(spec.y_span) + " m");
  }
}

/// Lowest and highest point of a shape along the z axis of the world.
double HighestOf(const ForeignShape& shape, const RigidTransform& X_WE) {
  const Matrix3& R = X_WE.rotation();
  const double z = X_WE.translation().z();
  if (const auto* block = std::get_if<scene::Block>(&shape.geometry)) {
    return z + R.row(2).cwiseAbs().dot(block->size / 2);
  }
  if (const auto* cylinder = std::get_if<scene::Cylinder>(&shape.geometry)) {
    const double along = R(2, 1);
    return z + std::abs(along) * cylinder->length / 2 +
           std::sqrt(std::max(0.0, 1 - along * along)) * cylinder->radius;
  }
  if (const auto* sphere = std::get_if<scene::Sphere>(&shape.geometry)) return z + sphere->radius;
  if (const auto* custom = std::get_if<scene::Custom>(&shape.geometry)) {
    double highest = -std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3f& vertex : custom->mesh->surface.vertices) {
      highest = std::max(highest, (X_WE * (custom->scale * vertex.cast<double>())).z());
    }
    return highest;
  }
  return z;  // a plane
}

}  // namespace

ImportTable TakeTable(const std::string& name, MergedWorld* world, ImportFindings* findings) {
  ImportTable result;
  const std::optional<Candidate> table = BestTable(name, *world);
  if (!table) {
    if (name.empty()) {
      findings->Remark({.file = "", .line = 0, .element = ""},
                       "changed: there is no ground; a table stands at z = 0");
      return result;
    }
    throw std::invalid_argument("--table is " + Quoted(name) +
                                ", expected the name of a level, fixed box or plane");
  }
  MergedObject& object = world->objects[table->object];
  const ForeignShape shape = object.shapes[table->shape];
  scene::TableSpec& spec = result.spec;
  result.X_WT = table->X_WT;
  spec.x_span = table->x_span >= kMinSpan && table->x_span <= kMaxGroundSpan
                    ? table->x_span
                    : GroundSpan(*world, table->X_WT, 0, spec.x_span);
  spec.y_span = table->y_span >= kMinSpan && table->y_span <= kMaxGroundSpan
                    ? table->y_span
                    : GroundSpan(*world, table->X_WT, 1, spec.y_span);
  spec.color = ColorOfTable(object, shape).value_or(spec.color);
  RemarkTable(shape, *table, spec, findings);
  object.shapes.erase(object.shapes.begin() + static_cast<std::ptrdiff_t>(table->shape));
  std::erase_if(object.shapes, [&shape](const ForeignShape& drawn) {
    return !drawn.collides && drawn.geometry == shape.geometry;
  });
  return result;
}

void RemoveBelowTable(MergedWorld* world, ImportFindings* findings) {
  for (MergedObject& object : world->objects) {
    if (!object.is_static) continue;
    std::erase_if(object.shapes, [&](const ForeignShape& shape) {
      const bool is_below = HighestOf(shape, object.X_WO * shape.X_BE) < 1e-6;
      if (is_below) {
        findings->Remark(shape.place,
                         "left out: it lies below the top of the table, where SMILE has its own "
                         "table and floor");
      }
      return is_below;
    });
  }
}

}  // namespace smile::scene_import
