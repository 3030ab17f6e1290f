#include "scene_xml/internal_shape_readers.h"

#include <algorithm>
#include <array>
#include <string>

#include "scene_xml/internal_values.h"

namespace smile::scene_xml {
namespace {

using scene::Shape;

// Braces evaluate from left to right, so findings come in the order of these lines.

Shape ReadBlock(AttributeReader* attributes) { return scene::Block{.size = attributes->Spans(1)}; }

Shape ReadBox(AttributeReader* attributes) {
  const scene::Box box{.size = attributes->Spans(1),
                       .thickness = attributes->Span("thickness", 0.05)};
  const double limit = std::min({box.size.x() / 2, box.size.y() / 2, box.size.z()});
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
                         .sides = attributes->Count("sides", 32, {3, 4096})};
}

constexpr Range<int> kPolygonSides{3, 1024};

/// A length that may be 0 as well.
double SpanOrZero(std::string_view name, double fallback_units, AttributeReader* attributes) {
  const std::string* text = attributes->Text(name);
  if (text && ParseNumber<double>(*text) == 0.0) return 0;
  return attributes->Span(name, fallback_units);
}

Shape ReadFrustum(AttributeReader* attributes) {
  const scene::Frustum frustum{.radius_top = SpanOrZero("radiusTop", 0.5, attributes),
                               .radius_bottom = SpanOrZero("radiusBottom", 0.5, attributes),
                               .height = attributes->Span("zspan", 1),
                               .sides = attributes->Count("sides", 3, kPolygonSides)};
  if (frustum.radius_top == 0 && frustum.radius_bottom == 0) {
    attributes->Refuse("radiusTop", "radiusTop or radiusBottom above 0");
  }
  return frustum;
}

Shape ReadRing(AttributeReader* attributes) {
  const scene::Ring ring{.radius_outer = attributes->Span("radiusOuter", 1),
                         .radius_inner = SpanOrZero("radiusInner", 0.5, attributes),
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

constexpr std::array<ShapeElement, 8> kShapeElements{{
    {"block", ReadBlock},
    {"box", ReadBox},
    {"composite", ReadComposite, /*is_composite=*/true},
    {"custom", ReadCustom},
    {"cylinder", ReadCylinder},
    {"frustum", ReadFrustum},
    {"ring", ReadRing},
    {"sphere", ReadSphere},
}};

}  // namespace

std::span<const ShapeElement> ShapeElements() { return kShapeElements; }

scene::Surface ReadSurface(AttributeReader* attributes) {
  constexpr Range<double> kFriction{0, 10}, kRestitution{0, 1};
  const scene::Surface usual;
  scene::Surface surface{
      .friction = attributes->Number("friction", usual.friction, kFriction),
      .restitution = attributes->Number("restitution", usual.restitution, kRestitution)};
  if (attributes->Text("rollingFriction")) {
    surface.rolling_friction = SpanOrZero("rollingFriction", 0.01, attributes);
  }
  return surface;
}

}  // namespace smile::scene_xml
