#include <numbers>

#include "base/wording.h"
#include "scene_import/internal_link_shapes.h"
#include "scene_import/internal_sdf_frames.h"
#include "scene_import/internal_shapes.h"

namespace smile::scene_import {

std::string SdfText(const SourceElement& element, std::string_view child,
                    const std::string& usual) {
  const SourceElement* found = element.FindChild(child);
  if (!found) return usual;
  const std::size_t begin = found->text.find_first_not_of(" \t\r\n");
  if (begin == std::string::npos) return "";
  return found->text.substr(begin, found->text.find_last_not_of(" \t\r\n") - begin + 1);
}

double SdfNumber(const SourceElement& element, std::string_view child, double usual,
                 ImportFindings* findings) {
  const SourceElement* found = element.FindChild(child);
  if (!found) return usual;
  const auto numbers = NumbersOf(found->text, 1, 1, found->place(), std::string(child), findings);
  return numbers ? (*numbers)[0] : usual;
}

Vector3 SdfVector(const SourceElement& element, std::string_view child, const Vector3& usual,
                  ImportFindings* findings) {
  const SourceElement* found = element.FindChild(child);
  if (!found) return usual;
  // Colors have a fourth number, alpha.
  const auto numbers = NumbersOf(found->text, 3, 4, found->place(), std::string(child), findings);
  return numbers ? Vector3((*numbers)[0], (*numbers)[1], (*numbers)[2]) : usual;
}

SdfFrames::SdfFrames(const SourceElement& model, ImportFindings* findings) : findings_(*findings) {
  for (const SourceElement& child : model.children) {
    if (child.name != "link" && child.name != "joint" && child.name != "frame") continue;
    const std::string* name = child.FindAttribute("name");
    if (!name || name->empty()) {
      findings->Refuse(child.place(), "found no name");
    } else if (!frames_.emplace(*name, &child).second) {
      findings->Refuse(child.place(), "found a name that another link, joint or frame has");
    }
  }
}

RigidTransform SdfFrames::Written(const SourceElement& element) {
  const SourceElement* pose = element.FindChild("pose");
  if (!pose) return {};
  const std::string* format = pose->FindAttribute("rotation_format");
  const std::string* degrees = pose->FindAttribute("degrees");
  const bool is_quaternion = format && *format == "quat_xyzw";
  const std::size_t count = is_quaternion ? 7 : 6;
  const auto n = NumbersOf(pose->text, count, count, pose->place(), "pose", &findings_);
  if (!n) return {};
  const Vector3 p((*n)[0], (*n)[1], (*n)[2]);
  IsPosition(p, pose->place(), &findings_);
  if (is_quaternion) {
    const Quaternion q((*n)[6], (*n)[3], (*n)[4], (*n)[5]);
    if (q.norm() > 1e-9) return {q.normalized(), p};
    findings_.Refuse(pose->place(), "found a quaternion of length 0");
    return {};
  }
  const bool is_in_degrees = degrees && (*degrees == "true" || *degrees == "1");
  const double unit = is_in_degrees ? std::numbers::pi / 180 : 1;
  return {RollPitchYawRotation(unit * (*n)[3], unit * (*n)[4], unit * (*n)[5]), p};
}

RigidTransform SdfFrames::PoseOf(const SourceElement& element) {
  const SourceElement* pose = element.FindChild("pose");
  const std::string* relative = pose ? pose->FindAttribute("relative_to") : nullptr;
  const std::string* attached = element.FindAttribute("attached_to");
  std::string base = relative ? *relative : "";
  if (base.empty() && element.name == "frame" && attached) base = *attached;
  if (base.empty() && element.name == "joint") base = SdfText(element, "child");
  const RigidTransform X_MR = base.empty() ? RigidTransform() : PoseOf(base, element.place());
  return X_MR * Written(element);
}

RigidTransform SdfFrames::PoseOf(const std::string& name, const Place& place) {
  if (name == "__model__") return {};
  const auto known = poses_.find(name);
  if (known != poses_.end()) return known->second;
  const auto found = frames_.find(name);
  if (found == frames_.end() || being_read_.size() > 100 || !being_read_.insert(name).second) {
    findings_.Refuse(place, "found the frame " + Quoted(name) +
                                ", expected a link, joint or frame of the model that is not "
                                "relative to itself");
    return {};
  }
  const RigidTransform X = PoseOf(*found->second);
  being_read_.erase(name);
  return poses_[name] = X;
}

}  // namespace smile::scene_import
