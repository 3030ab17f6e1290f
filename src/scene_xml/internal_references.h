#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "scene_xml/internal_findings.h"

namespace smile::scene_xml {

/// What an element can name by its id.
enum class Target { kControl, kHost };

/// An attribute that names another element, and where it stands.
struct Reference {
  Target target = Target::kControl;
  std::string attribute, text;
  Place place;
  std::string element;  ///< its address, for messages
};

/// Who names whom. A scene may name what stands further down, and what the program will call
/// otherwise than its file does, so names are looked up when all has been read: until then the
/// scene holds tickets in their place.
class References {
 public:
  /// @param written  the id in the file; may be empty.
  /// @param id       the one it got.
  void Declare(Target target, const std::string& written, const std::string& id);

  /// @returns the ticket.
  std::string Add(Reference reference);
  const Reference& Of(const std::string& ticket) const;

  /// The id of the element that is meant: the one that is called so, else the only one that is
  /// written so. Empty, with a finding, when there is none, or more than one.
  std::string Find(const Reference& reference, Findings* findings) const;

 private:
  struct Names {
    std::map<std::string, std::vector<std::string>, std::less<>> ids_of_written;
    std::set<std::string, std::less<>> ids;
  };
  const Names& NamesOf(Target target) const { return names_[static_cast<int>(target)]; }

  Names names_[2];
  std::vector<Reference> references_;
};

}  // namespace smile::scene_xml
