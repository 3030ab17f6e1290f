#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "math/rigid_transform.h"
#include "scene_import/import_findings.h"
#include "xml/element.h"

namespace smile::scene_import {

/// Element that knows its file: a model may consist of several.
struct SourceElement {
  std::string name;
  std::shared_ptr<const std::string> file;
  int line = 1;
  std::vector<xml::Attribute> attributes;
  std::string text;
  std::vector<SourceElement> children;

  const std::string* FindAttribute(std::string_view attribute_name) const;
  const SourceElement* FindChild(std::string_view child_name) const;
  Place place() const;
};

/// Returns an element of a file with everything inside it.
SourceElement SourceElementOf(const xml::Element& element,
                              const std::shared_ptr<const std::string>& file);

/// Parses a file.
/// @returns nullopt, with faults, if it is not XML or its root has another name.
std::optional<SourceElement> ParseSource(std::string_view text, const std::string& file,
                                         std::string_view root, ImportFindings* findings);

/// Positions and lengths in imported files are within this of 0 [m].
inline constexpr double kMaxLength = 1e5;
/// Shapes are at least this large [m].
inline constexpr double kMinSpan = 1e-4;

/// Reads the numbers of a text with blanks between them.
/// @returns nullopt, with a fault that names `what`, unless there are `least` to `most` finite
///          numbers within 1e9 of 0.
std::optional<std::vector<double>> NumbersOf(const std::string& text, std::size_t least,
                                             std::size_t most, const Place& place,
                                             const std::string& what, ImportFindings* findings);

/// Reads the attributes of an element and knows which ones were read. A missing or refused
/// attribute has its default.
class ElementReader {
 public:
  /// @param element, findings  must outlive this.
  ElementReader(const SourceElement& element, ImportFindings* findings)
      : element_(element), findings_(*findings), place_(element.place()) {}

  const SourceElement& element() const { return element_; }
  const Place& place() const { return place_; }
  ImportFindings& findings() { return findings_; }

  bool Has(std::string_view name) const { return element_.FindAttribute(name) != nullptr; }
  std::string Text(std::string_view name, std::string_view usual = "");
  /// Returns `least` to `most` numbers, or none.
  std::vector<double> Numbers(std::string_view name, std::size_t least, std::size_t most);
  double Number(std::string_view name, double usual);
  Vector3 Vector(std::string_view name, const Vector3& usual);

  void Refuse(const std::string& message) { findings_.Refuse(place_, message); }
  void Remark(const std::string& message) { findings_.Remark(place_, message); }
  /// Remarks each attribute that was not read, except `name` and those that change nothing here.
  void RemarkRest(std::initializer_list<std::string_view> harmless = {});

 private:
  const SourceElement& element_;
  ImportFindings& findings_;
  Place place_;
  std::set<std::string, std::less<>> read_;
};

}  // namespace smile::scene_import
