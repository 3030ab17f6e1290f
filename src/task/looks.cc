#include "task/looks.h"

#include <algorithm>

#include "scene/bounds.h"
#include "scene/solid.h"

namespace smile::task {
namespace {

/// Lengths that differ less are equal [m].
constexpr double kEqualLengths = 1e-6;

/// What an object looks like, apart from where it is and what it is called.
std::vector<scene::Solid> LooksOf(const scene::ObjectSpec& object) {
  std::vector<scene::Solid> solids = scene::SolidsOf(object.whole);
  for (scene::Solid& solid : solids) solid.part_id.clear();
  return solids;
}

std::vector<scene::Solid> FormOf(const scene::ObjectSpec& object) {
  std::vector<scene::Solid> solids = LooksOf(object);
  for (scene::Solid& solid : solids) solid.color = Color();
  return solids;
}

/// Each once, in order.
std::vector<Color> ColorsOf(const scene::ObjectSpec& object) {
  std::vector<Color> colors;
  for (const scene::Solid& solid : scene::SolidsOf(object.whole)) {
    if (std::ranges::find(colors, solid.color) == colors.end()) colors.push_back(solid.color);
  }
  return colors;
}

Vector3 ExtentOf(const scene::ObjectSpec& object) {
  return scene::BoundsOf(scene::SolidsOf(object.whole), RigidTransform()).size();
}

const std::string* DescriptionOf(const scene::ObjectSpec& object, const std::string& name) {
  const auto found = std::ranges::find(object.descriptions, name, &scene::Description::name);
  return found != object.descriptions.end() ? &found->value : nullptr;
}

bool AreEqualDescriptions(const std::string* a, const std::string* b) {
  return a == nullptr || b == nullptr ? a == b : *a == *b;
}

bool IsAboutLooks(const std::string& property) {
  return property != "position" && property != "orientation" && property != "order";
}

bool Agree(const scene::ObjectSpec& a, const scene::ObjectSpec& b, const std::string& property) {
  if (property == "color") return ColorsOf(a) == ColorsOf(b);
  if (property == "size") return (ExtentOf(a) - ExtentOf(b)).cwiseAbs().maxCoeff() < kEqualLengths;
  const std::string* of_a = DescriptionOf(a, property);
  const std::string* of_b = DescriptionOf(b, property);
  if (property == "shape" && (of_a == nullptr || of_b == nullptr)) {
    return a.whole.shape.index() == b.whole.shape.index();
  }
  return AreEqualDescriptions(of_a, of_b);
}

}  // namespace

bool AreAlike(const scene::ObjectSpec& wanted, const scene::ObjectSpec& other,
              const std::vector<std::string>& properties) {
  if (std::ranges::none_of(properties, IsAboutLooks)) return LooksOf(wanted) == LooksOf(other);
  return std::ranges::all_of(properties, [&](const std::string& property) {
    return !IsAboutLooks(property) || Agree(wanted, other, property);
  });
}

bool AreOfOneForm(const scene::ObjectSpec& a, const scene::ObjectSpec& b) {
  return FormOf(a) == FormOf(b);
}

}  // namespace smile::task
