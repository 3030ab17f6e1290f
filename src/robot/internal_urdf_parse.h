#pragma once

#include <urdf_model/model.h>

#include <memory>
#include <string>
#include <string_view>

#include "base/diagnostic.h"
#include "xml/element.h"

namespace smile::robot::internal {

/// A parsed URDF, with the lines of its links and joints.
///
/// The parser recurses without bound on nested elements, follows loops of joints and drops line
/// numbers. It is therefore called only with a text that xml::Parse() accepted, which is bounded in
/// size and depth.
class UrdfDocument {
 public:
  /// Parses a text.
  /// @throws InputError if it is not well-formed, too large, or its links do not form one tree.
  UrdfDocument(const std::string& text, std::string file);

  const urdf::ModelInterface& model() const { return *model_; }

  /// Throws an InputError for an `<element name="name">` of the robot, with its line.
  [[noreturn]] void Fail(std::string_view element, std::string_view name,
                         const std::string& message) const;

 private:
  void CheckTree() const;
  void CheckCount(const std::string& element) const;
  int LineOf(std::string_view element, std::string_view name) const;
  [[noreturn]] void FailWithParserLog(const std::string& log) const;

  std::string file_;
  xml::Element root_;
  std::shared_ptr<const urdf::ModelInterface> model_;
};

}  // namespace smile::robot::internal
