#include "scene_xml/internal_sources.h"

namespace smile::scene_xml {

int Sources::AddFile(std::string name) {
  files_.push_back(std::move(name));
  return static_cast<int>(files_.size()) - 1;
}

int Sources::AddExpansion(const SourceLocation& instance) {
  expansions_.push_back(instance);
  return static_cast<int>(expansions_.size()) - 1;
}

std::string Sources::Address(const SourceLocation& place) const {
  return FileOf(place) + ":" + std::to_string(place.line);
}

std::string Sources::ExpansionNote(const SourceLocation& place) const {
  if (place.expansion < 0) return {};
  const SourceLocation& inner = expansions_[place.expansion];
  std::string note = " (in the instance at " + Address(inner);
  if (inner.expansion >= 0) {
    // The whole chain of instances would be long; the innermost and the outermost suffice to find
    // it.
    SourceLocation outer = inner;
    while (outer.expansion >= 0) outer = expansions_[outer.expansion];
    note += ", within that at " + Address(outer);
  }
  return note + ")";
}

}  // namespace smile::scene_xml
