#pragma once

#include <set>
#include <string>

namespace smile::interchange {

/// Names that are given once each.
class UniqueNames {
 public:
  /// Returns a name like the wanted one that no other has.
  std::string Take(const std::string& wanted) {
    std::string name = wanted;
    for (int number = 2; !taken_.insert(name).second; ++number) {
      name = wanted + "_" + std::to_string(number);
    }
    return name;
  }

 private:
  std::set<std::string> taken_;
};

}  // namespace smile::interchange
