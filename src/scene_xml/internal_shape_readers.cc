#include "scene_xml/internal_shape_readers.h"

#include <algorithm>
#include <array>

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

Shape ReadCylinder(AttributeReader* attributes) {
  return scene::Cylinder{.radius = attributes->Span("radius", 0.5),
                         .length = attributes->Span("yspan", 1),
                         .sides = attributes->Count("sides", 32, {3, 4096})};
}

Shape ReadSphere(AttributeReader* attributes) {
  return scene::Sphere{.radius = attributes->Span("radius", 0.5)};
}

constexpr std::array<ShapeElement, 5> kShapeElements{{
    {"block", ReadBlock},
    {"box", ReadBox},
    {"composite", ReadComposite, /*is_composite=*/true},
    {"cylinder", ReadCylinder},
    {"sphere", ReadSphere},
}};

}  // namespace

std::span<const ShapeElement> ShapeElements() { return kShapeElements; }

}  // namespace smile::scene_xml
