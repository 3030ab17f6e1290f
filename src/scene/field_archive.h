#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "base/bytes.h"
#include "scene/articulation_spec.h"

// Binary form of solids and articulations, for snapshots and messages of one build.
//
// Each type is written and read by one list of its fields: Walk(archive, value). A FieldWriter
// writes them, a FieldReader reads them, so the two cannot diverge. Other rooms derive their
// archives from these two, and add Walk() for their own types.

namespace smile::scene {

class FieldArchive {
 public:
  /// @param name  of the content, for messages.
  explicit FieldArchive(const char* name) : name_(name) {}
  [[noreturn]] void Fail(const std::string& complaint) const {
    throw std::runtime_error(std::string(name_) + ": " + complaint);
  }

 private:
  const char* name_;
};

struct FieldWriter : FieldArchive {
  using FieldArchive::FieldArchive;
  template <class T>
  requires std::is_arithmetic_v<T> || std::is_enum_v<T>
  void operator()(const T& value) { bytes.Put(value); }
  void operator()(const std::string& text) { bytes.PutString(text); }
  std::uint32_t Count(std::size_t count) {
    bytes.Put(static_cast<std::uint32_t>(count));
    return static_cast<std::uint32_t>(count);
  }

  ByteWriter bytes;
};

/// @throws std::runtime_error if the bytes are not a value of the type that is read.
struct FieldReader : FieldArchive {
  FieldReader(const char* name, std::span<const std::byte> source)
      : FieldArchive(name), bytes(source) {}
  template <class T>
  requires std::is_arithmetic_v<T> || std::is_enum_v<T>
  void operator()(T& value) { value = bytes.Get<T>(); }
  void operator()(std::string& text) { text = bytes.GetString(); }
  std::uint32_t Count(std::size_t) {
    constexpr std::uint32_t kMaxCount = 1'000'000;  // more of anything is not one of ours
    const auto count = bytes.Get<std::uint32_t>();
    if (!bytes.ok() || count > kMaxCount) Fail("it is truncated");
    return count;
  }

  ByteReader bytes;
};

template <class Archive, class Derived>
void WalkMatrix(Archive& archive, Derived& matrix) {
  for (int i = 0; i < matrix.size(); ++i) archive(matrix.data()[i]);
}

template <class Archive>
void Walk(Archive& archive, RigidTransform& X) {
  Matrix3 R = X.rotation();
  Vector3 p = X.translation();
  WalkMatrix(archive, R);
  WalkMatrix(archive, p);
  X = RigidTransform(R, p);
}

template <class Archive, class T>
void WalkEach(Archive& archive, std::vector<T>& values) {
  const std::uint32_t count = archive.Count(values.size());
  values.resize(count);
  for (T& value : values) {
    if constexpr (std::is_arithmetic_v<T>) {
      archive(value);
    } else {
      Walk(archive, value);
    }
  }
}

template <class Archive>
void Walk(Archive& archive, Block& block) {
  WalkMatrix(archive, block.size);
}
template <class Archive>
void Walk(Archive& archive, Cylinder& cylinder) {
  archive(cylinder.radius);
  archive(cylinder.length);
  archive(cylinder.sides);
}
template <class Archive>
void Walk(Archive& archive, Sphere& sphere) {
  archive(sphere.radius);
}

template <class Archive>
void Walk(Archive& archive, Vector3& v) {
  WalkMatrix(archive, v);
}
template <class Archive>
void Walk(Archive& archive, Polyhedron::Face& face) {
  WalkEach(archive, face);
}
template <class Archive>
void Walk(Archive& archive, Hull& hull) {
  Polyhedron polyhedron = hull.polyhedron();
  WalkEach(archive, polyhedron.corners);
  WalkEach(archive, polyhedron.faces);
  if (polyhedron == hull.polyhedron()) return;
  try {
    hull = Hull(std::move(polyhedron));  // reading
  } catch (const std::invalid_argument& error) {
    archive.Fail(error.what());
  }
}

/// Writes or reads whether a value is present, then the value by `walk`.
template <class Archive, class T>
void WalkOptional(Archive& archive, std::optional<T>& value, auto&& walk) {
  auto has_value = static_cast<std::uint8_t>(value.has_value());
  archive(has_value);
  if (has_value != 0 && !value) value.emplace();  // reading
  if (value) walk(*value);
}

template <class Archive>
void Walk(Archive& archive, std::optional<double>& number) {
  WalkOptional(archive, number, [&archive](double& value) { archive(value); });
}

/// Writes the value each time it is shared; reads it into one of its own.
template <class Archive, class T>
void Walk(Archive& archive, std::shared_ptr<const T>& shared) {
  auto copy = shared ? std::make_shared<T>(*shared) : std::make_shared<T>();
  Walk(archive, *copy);
  shared = std::move(copy);
}

/// Reads or writes which alternative a variant holds, then its fields.
template <class Archive, class... Kinds>
void WalkAlternatives(Archive& archive, std::variant<Kinds...>& value, const char* what) {
  auto kind = static_cast<std::uint8_t>(value.index());
  archive(kind);
  if (kind >= sizeof...(Kinds)) {
    archive.Fail(std::string("it has an unknown ") + what);
  }
  if (kind != value.index()) {  // reading
    const std::array<std::variant<Kinds...>, sizeof...(Kinds)> fresh = {Kinds()...};
    value = fresh[kind];
  }
  std::visit([&archive](auto& alternative) { Walk(archive, alternative); }, value);
}

template <class Archive>
void Walk(Archive& archive, Trigger& trigger) {
  archive(trigger.rule.cause);
  archive(trigger.rule.press_force);
  archive(trigger.rule.press_angle);
  WalkMatrix(archive, trigger.inward_in_body);
  archive(trigger.next_state);
}

template <class Archive>
void Walk(Archive& archive, Solid& solid) {
  WalkAlternatives(archive, solid.shape, "shape");
  Walk(archive, solid.X_BS);
  archive(solid.color.red);
  archive(solid.color.green);
  archive(solid.color.blue);
  archive(solid.part_id);
  archive(solid.control);
  archive(solid.variant);
  WalkOptional(archive, solid.button, [&archive](Button& button) { archive(button); });
  WalkOptional(archive, solid.trigger, [&archive](Trigger& trigger) { Walk(archive, trigger); });
}

template <class Archive>
void Walk(Archive& archive, std::optional<Mimic>& mimic) {
  WalkOptional(archive, mimic, [&archive](Mimic& value) {
    archive(value.leader);
    archive(value.multiplier);
    archive(value.offset);
  });
}

template <class Archive>
void Walk(Archive& archive, LinkSpec& link) {
  archive(link.name);
  archive(link.joint_name);
  archive(link.parent);
  archive(link.joint_type);
  Walk(archive, link.X_PJ);
  WalkMatrix(archive, link.axis);
  for (double* number :
       {&link.lower, &link.upper, &link.max_velocity, &link.max_effort, &link.mass}) {
    archive(*number);
  }
  Walk(archive, link.mimic);
  WalkMatrix(archive, link.p_LLcm);
  WalkMatrix(archive, link.inertia);
  WalkEach(archive, link.solids);
  archive(link.friction);
}

template <class Archive>
void Walk(Archive& archive, std::pair<int, int>& pair) {
  archive(pair.first);
  archive(pair.second);
}

template <class Archive>
void Walk(Archive& archive, ArticulationSpec& spec) {
  Walk(archive, spec.X_WBase);
  WalkEach(archive, spec.base_solids);
  WalkEach(archive, spec.links);
  WalkEach(archive, spec.never_collide);
  archive(spec.is_kinematic);
}

}  // namespace smile::scene
