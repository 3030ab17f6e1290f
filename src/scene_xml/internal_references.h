#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "scene_xml/internal_findings.h"

namespace smile::scene_xml {

/// Kinds of elements that can be referred to by id.
enum class Target { kControl, kHost };

/// Attribute that refers to another element, with its place.
struct Reference {
  Target target = Target::kControl;
  std::string attribute, text;
  SourceLocation place;
  std::string element;  ///< its address, for messages
};

/// References between elements. A scene may refer to elements further down, and to elements that
/// get another id than the file gives them, so references are resolved after everything has been
/// read: until then the scene contains tickets in place of ids.
class References {
 public:
  /// @param written  the id in the file; may be empty.
  /// @param id  the unique id that the element got.
  void Declare(Target target, const std::string& written, const std::string& id);

  /// @returns the ticket.
  std::string Add(Reference reference);
  const Reference& Of(const std::string& ticket) const;

  /// Returns the id of the referenced element: the one with that unique id, else the only one with
  /// that written id. Empty, with a finding, if there is none or more than one.
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
