#include "world/object_states.h"

#include <algorithm>

namespace smile::world {

ObjectState ObjectStates::operator[](model::ObjectIndex object) const {
  const auto found = std::ranges::lower_bound(changed_, object, {}, &Numbered::first);
  return found != changed_.end() && found->first == object ? found->second : ObjectState();
}

void ObjectStates::Set(model::ObjectIndex object, const ObjectState& state) {
  auto place = std::ranges::lower_bound(changed_, object, {}, &Numbered::first);
  if (place != changed_.end() && place->first == object) place = changed_.erase(place);
  if (state != ObjectState()) changed_.emplace(place, object, state);
}

}  // namespace smile::world
