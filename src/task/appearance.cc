#include "task/appearance.h"

#include <algorithm>

#include "scene/bounds.h"

namespace smile::task {
namespace {

/// Lengths that differ less are equal [m].
constexpr double kEqualLengths = 1e-6;

/// Returns each color once, in order of its first occurrence.
std::vector<Color> KindsOf(const std::vector<Color>& colors) {
  std::vector<Color> kinds;
  for (const Color& color : colors) {
    if (std::ranges::find(kinds, color) == kinds.end()) kinds.push_back(color);
  }
  return kinds;
}

/// Returns the size of the bounding box along the object's own axes [m].
Vector3 ExtentOf(const Appearance& appearance) {
  return scene::BoundsOf(appearance.form, RigidTransform()).size();
}

const std::string* DescriptionOf(const Appearance& appearance, const std::string& name) {
  const auto found = std::ranges::find(appearance.descriptions, name, &scene::Description::name);
  return found != appearance.descriptions.end() ? &found->value : nullptr;
}

/// Equal if both are missing or both have the same value.
bool AreEqualDescriptions(const std::string* a, const std::string* b) {
  return a == nullptr || b == nullptr ? a == b : *a == *b;
}

/// False for the properties that refer to the placement of an object and not to its
/// appearance.
bool IsAboutAppearance(const std::string& property) {
  return property != "position" && property != "orientation" && property != "order" &&
         property != "support";
}

/// True if two objects agree in one property. Color and size are measured; any other property is
/// compared by description.
bool Agree(const Appearance& a, const Appearance& b, const std::string& property) {
  if (property == "color") return KindsOf(a.colors) == KindsOf(b.colors);
  if (property == "size") return (ExtentOf(a) - ExtentOf(b)).cwiseAbs().maxCoeff() < kEqualLengths;
  const std::string* of_a = DescriptionOf(a, property);
  const std::string* of_b = DescriptionOf(b, property);
  // Without a described shape on both sides, the geometric primitive decides.
  if (property == "shape" && (of_a == nullptr || of_b == nullptr)) {
    return a.shape == b.shape;
  }
  return AreEqualDescriptions(of_a, of_b);
}

}  // namespace

Appearance AppearanceOf(const scene::ObjectSpec& object) {
  Appearance appearance{.form = scene::SolidsOf(object.whole),
                        .colors = {},
                        .shape = object.whole.shape.index(),
                        .descriptions = object.descriptions};
  for (scene::Solid& solid : appearance.form) {
    appearance.colors.push_back(solid.color);
    // Ids and colors are erased so that `form` compares geometry alone.
    solid.color = Color();
    solid.part_id.clear();
  }
  return appearance;
}

bool AreAlike(const Appearance& wanted, const Appearance& other,
              const std::vector<std::string>& properties) {
  if (std::ranges::none_of(properties, IsAboutAppearance)) {
    return wanted.form == other.form && wanted.colors == other.colors;
  }
  return std::ranges::all_of(properties, [&](const std::string& property) {
    return !IsAboutAppearance(property) || Agree(wanted, other, property);
  });
}

}  // namespace smile::task
