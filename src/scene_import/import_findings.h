#pragma once

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "base/diagnostic.h"

namespace smile::scene_import {

/// Address of an element in an imported file, for messages.
struct Place {
  std::string file;
  int line = 0;
  std::string element;  ///< for example `geom name="lid"`
};

/// Findings about an imported file: faults, for which it is refused, and remarks about what was
/// left out or changed.
class ImportFindings {
 public:
  /// Adds a fault: what was found and what was expected.
  void Refuse(const Place& place, const std::string& message);
  /// Adds a remark. The same words about further elements of the same name add only their lines.
  void Remark(const Place& place, const std::string& message);

  /// @throws InputError with all faults, if there are any.
  void ThrowIfRefused() const;
  /// Returns the remarks in the order in which they were added.
  std::vector<Diagnostic> Remarks() const;

 private:
  struct CountedRemark {
    Diagnostic first;
    std::vector<int> more_lines;  ///< of further elements of the same name
  };

  std::vector<Diagnostic> faults_;
  std::vector<CountedRemark> remarks_;
  /// Index in remarks_ by file, name of the element, and words.
  std::map<std::tuple<std::string, std::string, std::string>, std::size_t> index_;
};

}  // namespace smile::scene_import
