// The objects of the menu, made at a random free place. A recipe builds them around the origin;
// then one rejection sampling moves all of them as a whole. The sequence of random numbers is:
// colors, then places.

#include "layout/presets.h"

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <random>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "base/uniform.h"
#include "base/wording.h"
#include "math/angles.h"
#include "scene/bounds.h"
#include "scene/units.h"
#include "texts/user_message.h"

namespace smile::layout {

using texts::Say;
namespace {

using Random = std::mt19937_64;

/// Makes the objects of a preset; lengths are in units of the scene.
class Maker {
 public:
  Maker(double meters_per_unit, Random* random) : unit_(meters_per_unit), random_(random) {}

  double Meters(double units) const { return scene::FromFileUnits(units, unit_); }

  Color RandomColor() {
    constexpr std::array<const char*, 8> kColors = {"red",   "blue", "yellow",  "green",
                                                    "brown", "cyan", "magenta", "orange"};
    // min() guards against an upper end that is reached by rounding.
    const auto lot = static_cast<std::size_t>(Uniform(random_, 0, kColors.size()));
    return ParseColor(kColors[std::min(lot, kColors.size() - 1)]).value_or(Color());
  }

  /// Adds an object whose lowest point is at `bottom` [units] above the table.
  void Add(const std::string& id, const std::string& word, const scene::Shape& shape, double bottom,
           const Color& color, double mass = 1, double x = 0) {
    scene::ObjectSpec object{.whole = {.id = id, .color = color, .shape = shape}, .mass = mass};
    // The lowest point depends on the shape.
    const scene::Bounds bounds = scene::BoundsOf(scene::SolidsOf(object.whole), RigidTransform());
    object.whole.X_PE = RigidTransform(Vector3(Meters(x), 0, Meters(bottom) - bounds.low.z()));
    object.descriptions = {{"shape", word}, {"color", ToString(color)}};
    made_.push_back(std::move(object));
  }

  std::vector<scene::ObjectSpec> Take() { return std::move(made_); }

 private:
  double unit_;
  Random* random_;
  std::vector<scene::ObjectSpec> made_;
};

Vector3 Cube(const Maker& maker, double side) { return Vector3::Constant(maker.Meters(side)); }

/// Adds a tower of unit cubes.
void MakeStack(int count, Maker* maker) {
  for (int i = 0; i < count; ++i) {
    maker->Add("smallblock", "block", scene::Block{Cube(*maker, 1)}, i, maker->RandomColor());
  }
}

/// Adds five dominoes, one unit apart, so that one topples the next.
void MakeDominoes(Maker* maker) {
  const Vector3 size(maker->Meters(0.3), maker->Meters(1), maker->Meters(2));
  for (int i = 0; i < 5; ++i) {
    maker->Add("domino", "block", scene::Block{size}, 0, maker->RandomColor(), 0.5, i - 2.0);
  }
}

struct Recipe {
  Preset preset;
  std::function<void(Maker*)> make;
};

const std::vector<Recipe>& Recipes() {
  static const std::vector<Recipe> kRecipes = {
      {{"big_block", Say("presets.bigBlock")},
       [](Maker* maker) {
         maker->Add("largeblock", "block", scene::Block{Cube(*maker, 1.5)}, 0,
                    maker->RandomColor());
       }},
      {{"stack_3", Say("presets.stack", {{"number", 3}})},
       [](Maker* maker) { MakeStack(3, maker); }},
      {{"stack_5", Say("presets.stack", {{"number", 5}})},
       [](Maker* maker) { MakeStack(5, maker); }},
      {{"stack_8", Say("presets.stack", {{"number", 8}})},
       [](Maker* maker) { MakeStack(8, maker); }},
      {{"box", Say("presets.box")},
       [](Maker* maker) {
         const Vector3 size(maker->Meters(5), maker->Meters(5), maker->Meters(3));
         maker->Add("container", "box", scene::Box{.size = size, .thickness = maker->Meters(0.5)},
                    0, ParseColor("gray").value_or(Color()), 3);
       }},
      {{"ball", Say("presets.ball")},
       [](Maker* maker) {
         maker->Add("ball", "sphere", scene::Sphere{maker->Meters(0.5)}, 0, maker->RandomColor(),
                    0.5);
       }},
      {{"prism", Say("presets.prism")},
       [](Maker* maker) {
         const double radius = maker->Meters(0.7);
         maker->Add("prism", "frustum",
                    scene::Frustum{.radius_top = radius,
                                   .radius_bottom = radius,
                                   .height = maker->Meters(1),
                                   .sides = 6},
                    0, maker->RandomColor());
       }},
      {{"ring", Say("presets.ring")},
       [](Maker* maker) {
         maker->Add("ring", "ring",
                    scene::Ring{.radius_outer = maker->Meters(1),
                                .radius_inner = maker->Meters(0.6),
                                .height = maker->Meters(0.4)},
                    0, maker->RandomColor(), 0.5);
       }},
      {{"dominoes", Say("presets.dominoes", {{"number", 5}})}, &MakeDominoes},
  };
  return kRecipes;
}

/// Returns the recipe of a preset.
/// @throws std::invalid_argument if there is none of this name.
const Recipe& FindRecipe(const std::string& name) {
  std::vector<std::string_view> known;
  for (const Recipe& recipe : Recipes()) {
    if (name == recipe.preset.name) return recipe;
    known.emplace_back(recipe.preset.name);
  }
  throw std::invalid_argument("\"preset\" is " + Quoted(name) + ", expected " + OneOf(known) +
                              DidYouMean(name, known));
}

/// Returns `ball_1`, or the next free number.
std::string NewId(const std::string& word, std::set<std::string>* ids) {
  for (int number = 1;; ++number) {
    std::string id = word + "_" + std::to_string(number);
    if (ids->insert(id).second) return id;
  }
}

scene::Bounds BoundsIn(const scene::ObjectSpec& object, const RigidTransform& X_WA) {
  return scene::BoundsOf(scene::SolidsOf(object.whole), X_WA * object.pose_in_world());
}

/// Returns the objects at a place A as a scene of their own, with new ids.
scene::SceneSpec SceneOf(const std::string& preset, std::vector<scene::ObjectSpec> things,
                         const RigidTransform& X_WA, const PlacementContext& context) {
  scene::SceneSpec scene{
      .name = preset, .meters_per_unit = context.meters_per_unit, .table = context.table};
  // Ids of the new objects must also differ among themselves.
  std::set<std::string> ids = context.ids;
  for (scene::ObjectSpec& thing : things) {
    thing.whole.id = NewId(thing.whole.id, &ids);
    thing.whole.X_PE = X_WA * thing.whole.X_PE;
    scene.objects.push_back(std::move(thing));
  }
  return scene;
}

/// Finds a place A where objects meet no others and do not extend over the table's edge.
class PlaceFinder {
 public:
  /// @param context  must outlive this.
  explicit PlaceFinder(const PlacementContext& context)
      : margin_(scene::FromFileUnits(0.2, context.meters_per_unit)), context_(context) {}

  std::optional<RigidTransform> Find(const std::vector<scene::ObjectSpec>& things,
                                     Random* random) const {
    // Rejection sampling: a full table ends it after this many tries.
    constexpr int kMaxTries = 2'000;
    for (int i = 0; i < kMaxTries; ++i) {
      const double x = Uniform(random, -context_.table.x_span / 2, context_.table.x_span / 2);
      const double y = Uniform(random, -context_.table.y_span / 2, context_.table.y_span / 2);
      const RigidTransform X_WA(RotationFromFixedAxes({0, 0, Uniform(random, 0, 90)}), {x, y, 0});
      // The common bounds of all objects, which move as one.
      scene::Bounds bounds;
      for (const scene::ObjectSpec& thing : things) bounds.Add(BoundsIn(thing, X_WA));
      if (IsFree(bounds)) return X_WA;
    }
    return std::nullopt;
  }

 private:
  bool IsFree(const scene::Bounds& bounds) const {
    // Axis-aligned bounds of the rotated objects: too large, but the table has room.
    const Vector3 edge(context_.table.x_span / 2 - margin_, context_.table.y_span / 2 - margin_, 0);
    if ((bounds.low.head<2>().array() < -edge.head<2>().array()).any()) return false;
    if ((bounds.high.head<2>().array() > edge.head<2>().array()).any()) return false;
    for (const scene::Bounds& other : context_.taken) {
      if (bounds.Meets(other, margin_)) return false;
    }
    return true;
  }

  double margin_;  ///< around everything [m]
  const PlacementContext& context_;
};

}  // namespace

const std::vector<Preset>& Presets() {
  static const std::vector<Preset> kPresets = [] {
    std::vector<Preset> presets;
    for (const Recipe& recipe : Recipes()) presets.push_back(recipe.preset);
    return presets;
  }();
  return kPresets;
}

std::optional<scene::SceneSpec> MakePreset(const std::string& preset,
                                           const PlacementContext& context, std::uint64_t seed) {
  Random random(seed);
  Maker maker(context.meters_per_unit, &random);
  FindRecipe(preset).make(&maker);
  std::vector<scene::ObjectSpec> things = maker.Take();
  const auto X_WA = PlaceFinder(context).Find(things, &random);
  if (!X_WA) return std::nullopt;
  return SceneOf(preset, std::move(things), *X_WA, context);
}

scene::SceneSpec MakePreset(const std::string& preset, const PlacementContext& context,
                            std::uint64_t seed, const Vector3& p_WQ) {
  Random random(seed);
  Maker maker(context.meters_per_unit, &random);
  FindRecipe(preset).make(&maker);
  std::vector<scene::ObjectSpec> things = maker.Take();
  scene::Bounds bounds;
  for (const scene::ObjectSpec& thing : things) bounds.Add(BoundsIn(thing, RigidTransform()));
  Vector3 p_AQ = (bounds.low + bounds.high) / 2;
  p_AQ.z() = bounds.low.z();
  return SceneOf(preset, std::move(things), RigidTransform(Vector3(p_WQ - p_AQ)), context);
}

}  // namespace smile::layout
