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

std::vector<Structure> PartsOf(const Structure& structure) {
  std::vector<std::string> bases;
  for (const scene::ObjectSpec& object : structure.objects) {
    if (object.is_static()) bases.push_back(object.id());
  }
  bases.insert(bases.end(), structure.foundations.begin(), structure.foundations.end());
  if (bases.size() <= 1) return {structure};
  std::vector<Structure> parts(bases.size());
  std::map<std::string, std::size_t> part_of;
  for (std::size_t i = 0; i < bases.size(); ++i) part_of[bases[i]] = i;
  // From supports to what they carry, and from what stayed to what is around it, over several
  // levels.
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
  for (const scene::ObjectSpec& object : structure.objects) {
    parts[part_of[object.id()]].objects.push_back(object);
  }
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
