#include "texts/lists.h"

namespace smile::texts {

UserMessage EachOf(const std::vector<UserMessage>& names) {
  UserMessage list;
  for (const UserMessage& name : names) {
    list = list.empty() ? name : Say("lists.more", {{"list", list}, {"name", name}});
  }
  return list;
}

UserMessage AllOf(const std::vector<UserMessage>& names) {
  if (names.size() < 2) return EachOf(names);
  const UserMessage begin = EachOf({names.begin(), names.end() - 1});
  return Say("lists.last", {{"list", begin}, {"name", names.back()}});
}

}  // namespace smile::texts
