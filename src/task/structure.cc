#include "task/structure.h"

#include <algorithm>
#include <map>

namespace smile::task {

bool Structure::is_fixed() const {
  return std::ranges::any_of(objects, &scene::ObjectSpec::is_static);
}

bool Structure::Contains(const std::string& object) const {
  return std::ranges::find(objects, object, &scene::ObjectSpec::id) != objects.end();
}

std::vector<std::string> Structure::AttendedOf(const std::string& object) const {
  const auto attended = attention.find(object);
  return attended != attention.end() ? attended->second : std::vector<std::string>();
}

namespace {

/// Number of the part of each object.
using PartNumbers = std::map<std::string, std::size_t>;

/// Assigns what bases carry, or what is around them or that, to their parts, over several levels:
/// from supports to what they carry, and from what stayed to what is around it.
PartNumbers GrownFrom(const std::vector<std::string>& bases, const Structure& structure) {
  PartNumbers part_of;
  for (std::size_t i = 0; i < bases.size(); ++i) part_of[bases[i]] = i;
  std::vector<std::pair<std::string, std::string>> placed_by;
  for (const Relation& it : structure.relations) placed_by.emplace_back(it.object, it.support);
  for (const Surrounding& it : structure.around) placed_by.emplace_back(it.object, it.inner);
  for (bool has_grown = true; has_grown;) {
    has_grown = false;
    for (const auto& [object, other] : placed_by) {
      const auto part = part_of.find(other);
      if (part == part_of.end()) continue;
      has_grown = part_of.emplace(object, part->second).second || has_grown;
    }
  }
  return part_of;
}

/// Returns true if each foundation may stand anywhere: all objects belong to a base, and nothing
/// connects the parts.
bool AreSeparate(const PartNumbers& part_of, const Structure& structure) {
  const auto are_in_one = [&](const std::string& one, const std::string& other) {
    return part_of.at(one) == part_of.at(other);
  };
  return std::ranges::all_of(
             structure.objects,
             [&](const scene::ObjectSpec& object) { return part_of.contains(object.id()); }) &&
         std::ranges::all_of(structure.relations,
                             [&](const Relation& it) {
                               return it.support.empty() || are_in_one(it.object, it.support);
                             }) &&
         std::ranges::all_of(
             structure.around,
             [&](const Surrounding& it) { return are_in_one(it.object, it.inner); }) &&
         std::ranges::all_of(structure.neighbors,
                             [&](const Neighbors& it) { return are_in_one(it.object, it.other); });
}

}  // namespace

std::vector<Structure> PartsOf(const Structure& structure) {
  std::vector<std::string> bases;
  for (const scene::ObjectSpec& object : structure.objects) {
    if (object.is_static()) bases.push_back(object.id());
  }
  const std::size_t num_fixed = bases.size();
  bases.insert(bases.end(), structure.foundations.begin(), structure.foundations.end());
  PartNumbers part_of = GrownFrom(bases, structure);
  if (bases.size() > num_fixed && !AreSeparate(part_of, structure)) {
    bases.resize(num_fixed);
    part_of = GrownFrom(bases, structure);
  }
  if (bases.size() <= 1) return {structure};
  std::vector<Structure> parts(bases.size());
  for (const scene::ObjectSpec& object : structure.objects) {
    parts[part_of[object.id()]].objects.push_back(object);
  }
  // Of foundations that look alike, the one that carries most is looked for first.
  std::stable_sort(
      parts.begin() + static_cast<std::ptrdiff_t>(num_fixed), parts.end(),
      [](const Structure& a, const Structure& b) { return a.objects.size() > b.objects.size(); });
  // What other parts consist of is not available to a part.
  for (std::size_t i = 0; i < parts.size(); ++i) {
    parts[i].attention = structure.attention;
    parts[i].others = structure.others;
    for (std::size_t k = 0; k < i; ++k) {
      parts[i].others.insert(parts[i].others.end(), parts[k].objects.begin(),
                             parts[k].objects.end());
    }
  }
  return parts;
}

}  // namespace smile::task
