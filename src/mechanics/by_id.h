#pragma once

#include <algorithm>
#include <memory>
#include <utility>

namespace smile::mechanics {

/// Returns an iterator to the element with this id in a list of pointers sorted by id, or its end.
template <class Things, class Id>
auto FindById(Things& things, Id id) {
  const auto found = std::lower_bound(things.begin(), things.end(), id,
                                      [](const auto& thing, Id key) { return thing->id() < key; });
  return found != things.end() && (*found)->id() == id ? found : things.end();
}

/// Inserts an element into a list of pointers sorted by id, and returns an iterator to it.
template <class Things, class Thing>
auto InsertById(Things& things, std::unique_ptr<Thing> thing) {
  const auto place = std::lower_bound(things.begin(), things.end(), thing->id(),
                                      [](const auto& other, auto id) { return other->id() < id; });
  return things.insert(place, std::move(thing));
}

/// Returns true if the record describes this object: same id, equal spec.
template <class Thing, class Record>
bool IsOfRecord(const Thing& thing, const Record& record) {
  return thing.id() == record.id &&
         (&thing.spec() == record.spec.get() || thing.spec() == *record.spec);
}

}  // namespace smile::mechanics
