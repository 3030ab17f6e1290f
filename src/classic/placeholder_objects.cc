// Stand-in scene for an imported recording without its own: enough to see where objects were.
// Values come from descriptions in the texts, so everything is brought into the limits of the scene
// format; only a size that is no number is an error, with its line.

#include "classic/placeholder_objects.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <set>
#include <stdexcept>

#include "base/diagnostic.h"
#include "classic/internal_classic_line.h"
#include "math/angles.h"
#include "scene/units.h"

namespace smile::classic {
namespace {

// Limits of the scene format.
constexpr double kMaxLocation = 1e6;                ///< [units]
constexpr double kMinSpan = 0.001, kMaxSpan = 1e6;  ///< [units]
constexpr std::size_t kMaxName = 100;

constexpr std::array<std::string_view, 9> kPalette = {"red",  "blue",    "yellow", "green", "brown",
                                                      "cyan", "magenta", "orange", "pink"};

/// First lines of a recording about an object: its creation and its first move.
struct FirstAppearance {
  const ClassicCreate* create = nullptr;
  const std::string* file = nullptr;
  int line = 0;
  const ClassicMove* move = nullptr;
};

std::map<std::string, FirstAppearance> FirstAppearances(const ClassicRecording& recording) {
  // insert() keeps the first creation; a second one of the same object is ignored.
  std::map<std::string, FirstAppearance> appearances;
  for (const ClassicFile& segment : recording.segments) {
    for (const ClassicLine& line : segment.lines) {
      if (const auto* create = std::get_if<ClassicCreate>(&line.what)) {
        appearances.insert({create->object, {create, &segment.file, line.number}});
      } else if (const auto* move = std::get_if<ClassicMove>(&line.what)) {
        FirstAppearance& appearance = appearances[move->object];
        if (appearance.move == nullptr) appearance.move = move;
      }
    }
  }
  return appearances;
}

/// Returns a length [units]; throws InputError with the line of the object's creation if it is
/// invalid.
double SpanOf(const scene::Description& description, const FirstAppearance& appearance) {
  try {
    const double span =
        ParseClassicNumber(description.value, "the length " + description.name, kMaxSpan);
    if (span >= kMinSpan) return span;
    throw std::invalid_argument(description.name + " is " + description.value +
                                ", expected at least 0.001");
  } catch (const std::invalid_argument& error) {
    throw InputError({*appearance.file, appearance.line, "", error.what()});
  }
}

/// Returns the text with `_` for everything but letters, digits and `_`.
std::string Letters(std::string_view text) {
  std::string letters(text);
  for (char& letter : letters) {
    // The cast is required: isalnum() of a negative char is undefined.
    if (std::isalnum(static_cast<unsigned char>(letter)) == 0) letter = '_';
  }
  return letters;
}

/// Returns the value without `$`, which scene files use for expressions.
std::string Plain(std::string value) {
  std::ranges::replace(value, '$', '_');
  return value;
}

/// Returns descriptions as scene files have them: `shape` first; a later value of the same name
/// replaces the earlier one.
std::vector<scene::Description> DescriptionsOf(const ClassicCreate& create) {
  std::vector<scene::Description> descriptions{{"shape", "block"}};
  for (const scene::Description& given : create.descriptions) {
    const std::string name = given.name.empty() ? "_" : Letters(given.name).substr(0, kMaxName);
    const auto earlier = std::ranges::find(descriptions, name, &scene::Description::name);
    if (earlier != descriptions.end()) {
      earlier->value = Plain(given.value);
    } else {
      descriptions.push_back({name, Plain(given.value)});
    }
  }
  return descriptions;
}

/// True for ids of the form `obj#3`, which scene files keep.
bool IsRenamed(const std::string& id, std::size_t hash) {
  if (hash == 0 || hash == std::string::npos) return false;
  const std::string number = id.substr(hash + 1);
  return !number.empty() && number.size() <= 10 &&
         std::ranges::all_of(number, [](unsigned char digit) { return std::isdigit(digit) != 0; });
}

/// Returns an id that is valid in a scene file and unique.
std::string IdFor(const std::string& object, std::set<std::string>* taken) {
  // Two ids may become equal by the replacement of letters; a number makes them differ again.
  const std::size_t hash = object.find('#');
  const std::string stem = Letters(object.substr(0, hash));
  std::string id = IsRenamed(object, hash) ? stem + object.substr(hash) : Letters(object);
  for (int number = 0; !taken->insert(id).second; ++number) {
    id = (stem.empty() ? "_" : stem) + "#" + std::to_string(number);
  }
  return id;
}

scene::ObjectSpec Placeholder(const FirstAppearance& appearance, std::size_t index) {
  scene::ObjectSpec object;
  // Sizes along axes that no description specifies [units].
  Vector3 spans(1, 1, 1);
  object.whole.color = *ParseColor(kPalette[index % kPalette.size()]);
  object.descriptions = DescriptionsOf(*appearance.create);
  for (const scene::Description& description : object.descriptions) {
    const auto& [name, value] = description;
    if (name == "bboxx") spans.x() = SpanOf(description, appearance);
    if (name == "bboxy") spans.y() = SpanOf(description, appearance);
    if (name == "bboxz") spans.z() = SpanOf(description, appearance);
    if (name != "color") continue;
    if (const auto color = ParseColor(value)) object.whole.color = *color;
  }
  object.whole.shape = scene::Block{.size = scene::FromFileUnits(spans, scene::kMetersPerUnit)};
  if (appearance.move == nullptr) return object;
  // Objects that fell off the table of the original continue to fall; a scene file has bounds.
  const Vector3 place = appearance.move->position.cwiseMax(-kMaxLocation).cwiseMin(kMaxLocation);
  object.whole.X_PE = RigidTransform(RotationFromFixedAxes(appearance.move->angles_deg),
                                     scene::FromFileUnits(place, scene::kMetersPerUnit));
  return object;
}

}  // namespace

scene::SceneSpec MakePlaceholders(const ClassicRecording& recording) {
  scene::SceneSpec scene;
  const auto appearances = FirstAppearances(recording);
  std::set<std::string> taken;
  for (const std::string& id : recording.Objects()) {
    scene.objects.push_back(Placeholder(appearances.at(id), scene.objects.size()));
    scene.objects.back().whole.id = IdFor(id, &taken);
  }
  return scene;
}

}  // namespace smile::classic
