#include "physics/snapshot.h"

#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>

#include "base/bytes.h"
#include "physics/internal_joint_bytes.h"

namespace smile::physics {
namespace {

constexpr std::array kMagic = {'S', 'M', 'I', 'L', 'E', 'S', 'N', 'P'};
constexpr std::uint32_t kVersion = 5;
/// More of anything than this is not one of ours.
constexpr std::uint32_t kMaxCount = 1'000'000;

// Each type is written and read by one list of its fields: Walk(archive, value). A Writer puts
// them, a Reader gets them, so the two cannot drift apart.

struct Writer {
  ByteWriter bytes;
  template <class T>
  requires std::is_arithmetic_v<T> || std::is_enum_v<T>
  void operator()(const T& value) { bytes.Put(value); }
  void operator()(const std::string& text) { bytes.PutString(text); }
  std::uint32_t Count(std::size_t count) {
    bytes.Put(static_cast<std::uint32_t>(count));
    return static_cast<std::uint32_t>(count);
  }
};

struct Reader {
  ByteReader bytes;
  template <class T>
  requires std::is_arithmetic_v<T> || std::is_enum_v<T>
  void operator()(T& value) { value = bytes.Get<T>(); }
  void operator()(std::string& text) { text = bytes.GetString(); }
  std::uint32_t Count(std::size_t) {
    const auto count = bytes.Get<std::uint32_t>();
    if (!bytes.ok() || count > kMaxCount) throw std::runtime_error("snapshot: it is cut short");
    return count;
  }
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
void Walk(Archive& archive, scene::Block& block) {
  WalkMatrix(archive, block.size);
}
template <class Archive>
void Walk(Archive& archive, scene::Cylinder& cylinder) {
  archive(cylinder.radius);
  archive(cylinder.length);
  archive(cylinder.sides);
}
template <class Archive>
void Walk(Archive& archive, scene::Sphere& sphere) {
  archive(sphere.radius);
}

template <class Archive>
void Walk(Archive& archive, Vector3& v) {
  WalkMatrix(archive, v);
}
template <class Archive>
void Walk(Archive& archive, scene::Polyhedron::Face& face) {
  WalkEach(archive, face);
}
template <class Archive>
void Walk(Archive& archive, scene::Hull& hull) {
  scene::Polyhedron polyhedron = hull.polyhedron();
  WalkEach(archive, polyhedron.corners);
  WalkEach(archive, polyhedron.faces);
  if (polyhedron == hull.polyhedron()) return;
  try {
    hull = scene::Hull(std::move(polyhedron));  // reading
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error("snapshot: " + std::string(error.what()));
  }
}

template <class Archive>
void Walk(Archive& archive, std::optional<double>& number) {
  auto has_value = static_cast<std::uint8_t>(number.has_value());
  archive(has_value);
  if (has_value != 0 && !number) number = 0;  // reading
  if (number) archive(*number);
}

/// Reads or writes which alternative a variant holds, then its fields.
template <class Archive, class... Kinds>
void WalkAlternatives(Archive& archive, std::variant<Kinds...>& value, const char* what) {
  auto kind = static_cast<std::uint8_t>(value.index());
  archive(kind);
  if (kind >= sizeof...(Kinds)) {
    throw std::runtime_error(std::string("snapshot: it has an unknown ") + what);
  }
  if (kind != value.index()) {  // reading
    const std::array<std::variant<Kinds...>, sizeof...(Kinds)> fresh = {Kinds()...};
    value = fresh[kind];
  }
  std::visit([&archive](auto& alternative) { Walk(archive, alternative); }, value);
}

template <class Archive>
void Walk(Archive& archive, scene::Solid& solid) {
  WalkAlternatives(archive, solid.shape, "shape");
  Walk(archive, solid.X_BS);
  archive(solid.color.red);
  archive(solid.color.green);
  archive(solid.color.blue);
  archive(solid.part_id);
}

template <class Archive>
void Walk(Archive& archive, BodySpec& spec) {
  WalkEach(archive, spec.solids);
  archive(spec.mass.mass);
  WalkMatrix(archive, spec.mass.center);
  WalkMatrix(archive, spec.mass.inertia);
  Walk(archive, spec.X_WB);
  archive(spec.friction);
  archive(spec.restitution);
  Walk(archive, spec.rolling_friction);
  Walk(archive, spec.angular_damping);
}

template <class Archive>
void Walk(Archive& archive, scene::LinkSpec& link) {
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
void Walk(Archive& archive, scene::ArticulationSpec& spec) {
  Walk(archive, spec.X_WBase);
  WalkEach(archive, spec.base_solids);
  WalkEach(archive, spec.links);
  WalkEach(archive, spec.never_collide);
  archive(spec.is_kinematic);
}

template <class Archive>
void Walk(Archive& archive, WeldSpec& weld) {
  archive(weld.articulation.value);
  archive(weld.link);
  archive(weld.body.value);
  Walk(archive, weld.X_LB);
  WalkEach(archive, weld.links_not_colliding);
  archive(weld.holds_up);
}
template <class Archive>
void Walk(Archive& archive, FixedJointSpec& fixed) {
  archive(fixed.a.value);
  archive(fixed.b.value);
  Walk(archive, fixed.X_AB);
}
template <class Archive>
void Walk(Archive& archive, SliderJointSpec& slider) {
  archive(slider.a.value);
  archive(slider.b.value);
  Walk(archive, slider.X_AJ);
  Walk(archive, slider.X_BK);
  archive(slider.do_collide);
  for (double* number :
       {&slider.lower, &slider.upper, &slider.damping, &slider.restitution, &slider.softness}) {
    archive(*number);
  }
}
template <class Archive>
void Walk(Archive& archive, BallJointSpec& ball) {
  archive(ball.a.value);
  archive(ball.b.value);
  WalkMatrix(archive, ball.p_AQ);
  WalkMatrix(archive, ball.p_BQ);
}

template <class Archive>
void Walk(Archive& archive, Joint& joint) {
  archive(joint.id.value);
  WalkAlternatives(archive, joint.spec, "joint");
}

template <class Archive>
void Walk(Archive& archive, std::pair<BodyId, BodyId>& pair) {
  archive(pair.first.value);
  archive(pair.second.value);
}

/// An id and the spec it shares with the world it came from.
template <class Archive, class Entry>
void WalkEntries(Archive& archive, std::vector<Entry>& entries) {
  const std::uint32_t count = archive.Count(entries.size());
  entries.resize(count);
  for (Entry& entry : entries) {
    using Spec = std::remove_const_t<typename decltype(entry.spec)::element_type>;
    auto spec = entry.spec ? std::make_shared<Spec>(*entry.spec) : std::make_shared<Spec>();
    archive(entry.id.value);
    Walk(archive, *spec);
    entry.spec = std::move(spec);
  }
}

template <class Archive>
void Walk(Archive& archive, Snapshot& snapshot) {
  archive(snapshot.next_id);
  archive(snapshot.next_joint_id);
  WalkEntries(archive, snapshot.bodies);
  WalkEntries(archive, snapshot.articulations);
  WalkEach(archive, snapshot.joints);
  WalkEach(archive, snapshot.passing);
  WalkEach(archive, snapshot.close_fits);
}

}  // namespace

void PutJoint(const Joint& joint, ByteWriter* out) {
  Writer writer;
  Joint copy = joint;
  Walk(writer, copy);
  out->PutBytes(writer.bytes.bytes());
}

std::vector<std::byte> Serialize(const Snapshot& snapshot) {
  Writer writer;
  for (char letter : kMagic) writer(letter);
  writer(kVersion);
  Snapshot copy = snapshot;
  Walk(writer, copy);
  writer.bytes.Put(static_cast<std::uint64_t>(snapshot.state.size()));
  writer.bytes.PutBytes(snapshot.state);
  return writer.bytes.Take();
}

Snapshot ParseSnapshot(std::span<const std::byte> bytes) {
  Reader reader{ByteReader(bytes)};
  for (char letter : kMagic) {
    if (reader.bytes.Get<char>() != letter) throw std::runtime_error("snapshot: this is not one");
  }
  const auto version = reader.bytes.Get<std::uint32_t>();
  if (version != kVersion) {
    throw std::runtime_error("snapshot: its format is version " + std::to_string(version) +
                             ", expected " + std::to_string(kVersion));
  }
  Snapshot snapshot;
  Walk(reader, snapshot);
  const auto state = reader.bytes.GetBytes(reader.bytes.Get<std::uint64_t>());
  if (!reader.bytes.ok()) throw std::runtime_error("snapshot: it is cut short");
  snapshot.state.assign(state.begin(), state.end());
  return snapshot;
}

}  // namespace smile::physics
