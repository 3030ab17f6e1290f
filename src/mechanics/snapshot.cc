#include "mechanics/snapshot.h"

#include <array>
#include <string>

#include "scene/field_archive.h"

// Snapshots as bytes. Specs are written field by field by Walk(), one function for writing and
// reading; the changing state is a block of bytes that the parts of the world write and read
// themselves, in the order of World::Save().

namespace smile::mechanics {
namespace {

constexpr std::array kMagic = {'S', 'M', 'I', 'L', 'E', 'S', 'N', 'P'};
/// Version of the format. Others are refused, since snapshots are exchanged only within one build.
constexpr std::uint32_t kVersion = 9;

// Walk() names the fields of each type once; the archive writes or reads them. See
// scene/field_archive.h.
struct Writer : scene::FieldWriter {
  using FieldWriter::FieldWriter;
};
struct Reader : scene::FieldReader {
  using FieldReader::FieldReader;
};

// States are opaque here: their own readers check them when they are restored.

using State = std::vector<std::byte>;

void PutState(const State& state, ByteWriter* out) {
  out->Put(static_cast<std::uint64_t>(state.size()));
  out->PutBytes(state);
}
State GetState(ByteReader* in) {
  // Never more than there are: the reader is bounded by its bytes.
  const auto bytes = in->GetBytes(in->Get<std::uint64_t>());
  return {bytes.begin(), bytes.end()};
}

void WalkState(Writer& writer, const std::shared_ptr<const State>& state) {
  PutState(*state, &writer.bytes);
}
void WalkState(Reader& reader, std::shared_ptr<const State>& state) {
  state = std::make_shared<const State>(GetState(&reader.bytes));
}

template <class Archive>
void Walk(Archive& archive, BodySpec& spec) {
  // The order of fields is the format; a change needs another version.
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

template <class Archive>
void Walk(Archive& archive, Snapshot::BodyEntry& entry) {
  archive(entry.id.value);
  Walk(archive, entry.spec);
  WalkState(archive, entry.state);
}
void WalkBodies(Writer& writer, const SharedList<Snapshot::BodyEntry>& bodies) {
  std::vector<Snapshot::BodyEntry> all(bodies.begin(), bodies.end());
  WalkEach(writer, all);
}
void WalkBodies(Reader& reader, SharedList<Snapshot::BodyEntry>& bodies) {
  std::vector<Snapshot::BodyEntry> all;
  WalkEach(reader, all);
  bodies = SharedList(std::move(all));
}
template <class Archive>
void Walk(Archive& archive, Snapshot::ArticulationEntry& entry) {
  archive(entry.id.value);
  Walk(archive, entry.spec);
}

template <class Archive>
void Walk(Archive& archive, Snapshot& snapshot) {
  archive(snapshot.next_id);
  archive(snapshot.next_joint_id);
  WalkBodies(archive, snapshot.bodies);
  WalkEach(archive, snapshot.articulations);
  WalkEach(archive, snapshot.joints);
  WalkEach(archive, snapshot.passing);
  WalkEach(archive, snapshot.close_fits);
}

}  // namespace

void PutJoint(const Joint& joint, ByteWriter* out) {
  Writer writer("snapshot");
  // Walk() serves reading too, so it takes a mutable object.
  Joint copy = joint;
  Walk(writer, copy);
  out->PutBytes(writer.bytes.bytes());
}

std::vector<std::byte> Serialize(const Snapshot& snapshot) {
  Writer writer("snapshot");
  for (char letter : kMagic) writer(letter);
  writer(kVersion);
  Snapshot copy = snapshot;
  Walk(writer, copy);
  PutState(snapshot.state, &writer.bytes);
  return writer.bytes.Take();
}

Snapshot ParseSnapshot(std::span<const std::byte> bytes) {
  Reader reader("snapshot", bytes);
  for (char letter : kMagic) {
    if (reader.bytes.Get<char>() != letter) reader.Fail("this is not one");
  }
  const auto version = reader.bytes.Get<std::uint32_t>();
  if (version != kVersion) {
    reader.Fail("its format is version " + std::to_string(version) + ", expected " +
                std::to_string(kVersion));
  }
  Snapshot snapshot;
  Walk(reader, snapshot);
  snapshot.state = GetState(&reader.bytes);
  if (!reader.bytes.ok()) reader.Fail("it is truncated");
  return snapshot;
}

}  // namespace smile::mechanics
