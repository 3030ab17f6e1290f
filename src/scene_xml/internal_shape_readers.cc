#include "scene_xml/internal_shape_readers.h"

#include <algorithm>
#include <array>
#include <string>

#include "scene_xml/internal_control_shapes.h"
#include "scene_xml/value_ranges.h"

// One reader per kind of shape, and the table by which elements find theirs. Defaults are in units,
// as in docs/scene-format.md; the values returned are in meters.

namespace smile::scene_xml {
namespace {

using scene::Shape;

// Braces evaluate from left to right, so findings come in the order of these lines.

Shape ReadBlock(AttributeReader* attributes) { return scene::Block{.size = attributes->Spans(1)}; }

Shape ReadBox(AttributeReader* attributes) {
  const scene::Box box{.size = attributes->Spans(1),
                       .thickness = attributes->Span("thickness", 0.05)};
  const double limit = std::min({box.size.x() / 2, box.size.y() / 2, box.size.z()});
  // A box is open at the top: two walls share x and y, but only the bottom is along z.
  if (box.thickness >= limit && !attributes->has_findings()) {
    attributes->Refuse("thickness", "less than half of xspan and yspan, and less than zspan");
  }
  return box;
}

Shape ReadComposite(AttributeReader*) { return scene::Composite{}; }

Shape ReadCustom(AttributeReader* attributes) { return attributes->Custom(); }

Shape ReadCylinder(AttributeReader* attributes) {
  return scene::Cylinder{.radius = attributes->Span("radius", 0.5),
                         .length = attributes->Span("yspan", 1),
                         .sides = attributes->Count("sides", 32, kCylinderSides)};
}

Shape ReadFrustum(AttributeReader* attributes) {
  const scene::Frustum frustum{.radius_top = attributes->SpanOrZero("radiusTop", 0.5),
                               .radius_bottom = attributes->SpanOrZero("radiusBottom", 0.5),
                               .height = attributes->Span("zspan", 1),
                               .sides = attributes->Count("sides", 3, kPolygonSides)};
  // One radius of 0 is a cone.
  if (frustum.radius_top == 0 && frustum.radius_bottom == 0) {
    attributes->Refuse("radiusTop", "radiusTop or radiusBottom above 0");
  }
  return frustum;
}

Shape ReadRing(AttributeReader* attributes) {
  const scene::Ring ring{.radius_outer = attributes->Span("radiusOuter", 1),
                         .radius_inner = attributes->SpanOrZero("radiusInner", 0.5),
                         .height = attributes->Span("zspan", 1),
                         .sides = attributes->Count("sides", 32, kPolygonSides)};
  if (ring.radius_inner >= ring.radius_outer && !attributes->has_findings()) {
    attributes->Refuse("radiusInner", "less than radiusOuter");
  }
  return ring;
}

Shape ReadSphere(AttributeReader* attributes) {
  return scene::Sphere{.radius = attributes->Span("radius", 0.5)};
}

/// All elements that are shapes. An empty color is that of elements without a color of their own.
constexpr std::array<ShapeElement, 11> kShapeElements{{
    {"block", ReadBlock},
    {"box", ReadBox},
    {"composite", ReadComposite, /*default_color=*/""},
    {"custom", ReadCustom},
    {"customControl", ReadCustomControl, /*default_color=*/"", /*is_control=*/true},
    {"cylinder", ReadCylinder},
    {"frustum", ReadFrustum},
    {"indicatorLights", ReadIndicatorLights, /*default_color=*/"", /*is_control=*/true},
    {"ring", ReadRing},
    {"sphere", ReadSphere},
    {"toggleSwitch", ReadToggleSwitch, /*default_color=*/"darkgray", /*is_control=*/true},
}};

}  // namespace

std::span<const ShapeElement> ShapeElements() { return kShapeElements; }

scene::Surface ReadSurface(AttributeReader* attributes) {
  const scene::Surface usual;
  scene::Surface surface{
      .friction = attributes->Number("friction", usual.friction, kFriction),
      .restitution = attributes->Number("restitution", usual.restitution, kProportion)};
  // Without the attribute, the default depends on the object's parts (scene::Surface).
  if (attributes->Text("rollingFriction")) {
    surface.rolling_friction = attributes->SpanOrZero("rollingFriction", 0.01);
  }
  return surface;
}

}  // namespace smile::scene_xml
