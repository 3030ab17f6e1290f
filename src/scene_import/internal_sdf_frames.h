#pragma once

#include <map>
#include <set>
#include <string>

#include "scene_import/internal_source_element.h"

namespace smile::scene_import {

/// Reads the numbers inside a child element; the usual ones if it is missing.
double SdfNumber(const SourceElement& element, std::string_view child, double usual,
                 ImportFindings* findings);
Vector3 SdfVector(const SourceElement& element, std::string_view child, const Vector3& usual,
                  ImportFindings* findings);
/// Returns the text inside a child element without blanks around it.
std::string SdfText(const SourceElement& element, std::string_view child,
                    const std::string& usual = "");

/// Frames of a SDFormat model M: its links, joints and frames, which may be written relative to
/// one another.
class SdfFrames {
 public:
  SdfFrames(const SourceElement& model, ImportFindings* findings);

  /// Returns the pose of a link, joint or frame in its model.
  RigidTransform PoseOf(const SourceElement& element);
  /// Returns the pose of a named frame in the model; adds a fault if there is none.
  RigidTransform PoseOf(const std::string& name, const Place& place);
  /// Returns the pose that an element writes, in the frame that it is relative to.
  RigidTransform Written(const SourceElement& element);

 private:
  std::map<std::string, const SourceElement*> frames_;  // by name
  std::map<std::string, RigidTransform> poses_;         // those that are known already
  std::set<std::string> being_read_;                    // a frame within this is in a circle
  ImportFindings& findings_;
};

}  // namespace smile::scene_import
