#include "record/trace.h"

#include <array>
#include <cmath>

#include "base/diagnostic.h"
#include "base/files.h"
#include "scene/bond_points.h"
#include "scene/controls_of.h"

namespace smile::record {
namespace {

constexpr std::array kMagic = {'S', 'M', 'I', 'L', 'E', 'T', 'R', 'C'};
constexpr std::uint32_t kVersion = 2;
constexpr std::uint32_t kMaxNames = 1'000'000;
/// How far a quaternion's length may be from 1.
constexpr double kUnitLength = 1e-6;
constexpr std::size_t kMaxBytes = std::size_t{4} << 30;

// What a record says besides tick, hash and moved objects.
constexpr std::uint8_t kJointsChanged = 1;
constexpr std::uint8_t kRobotHidden = 2;
constexpr std::uint8_t kControlsChanged = 4;
constexpr std::uint8_t kBondsChanged = 8;
constexpr std::uint8_t kAllFlags = 15;

void PutNames(const std::vector<std::string>& names, ByteWriter* out) {
  out->Put(static_cast<std::uint32_t>(names.size()));
  for (const std::string& name : names) out->PutString(name);
}

std::vector<std::string> GetNames(ByteReader* in) {
  std::vector<std::string> names;
  const auto count = in->Get<std::uint32_t>();
  for (std::uint32_t i = 0; i < count && count <= kMaxNames && in->ok(); ++i) {
    names.push_back(in->GetString());
  }
  return names;
}

}  // namespace

TraceTick Observe(const sim::Simulation& simulation) {
  TraceTick now{.tick = simulation.tick(),
                .hash = simulation.state_hash(),
                .is_robot_shown = simulation.is_robot_shown()};
  for (const world::Object& object : simulation.tabletop().objects()) {
    if (!simulation.tabletop().IsPresent(object)) {
      now.objects.push_back({.is_present = false});
      continue;
    }
    const RigidTransform X_WB = simulation.physics().body(object.body).pose_in_world();
    const Quaternion q = X_WB.quaternion();
    now.objects.push_back(
        {.position = X_WB.translation(), .rotation = {q.w(), q.x(), q.y(), q.z()}});
  }
  now.controls = simulation.tabletop().controls().states();
  for (const world::BondState& bond : simulation.tabletop().bonds().states()) {
    now.bonds.push_back(
        {.guest = bond.guest, .tightness = bond.tightness, .is_locked = bond.is_locked});
  }
  if (simulation.robot() != nullptr) now.joints = simulation.robot()->positions();
  return now;
}

TraceWriter::TraceWriter(const std::filesystem::path& path, const sim::Simulation& simulation)
    : file_(path) {
  ByteWriter out;
  for (char letter : kMagic) out.Put(letter);
  out.Put(kVersion);
  std::vector<std::string> names;
  for (const world::Object& object : simulation.tabletop().objects()) names.push_back(object.id());
  PutNames(names, &out);
  names.clear();
  if (simulation.robot() != nullptr) {
    for (const auto& link : simulation.robot()->model().links) names.push_back(link.joint_name);
  }
  PutNames(names, &out);
  file_.Append(out.bytes());
}

void TraceWriter::Add(const TraceTick& tick) {
  ByteWriter record;
  record.Put(tick.tick);
  record.Put(tick.hash);
  const bool joints_changed = !last_ || tick.joints != last_->joints;
  const bool controls_changed = !last_ || tick.controls != last_->controls;
  const bool bonds_changed = !last_ || tick.bonds != last_->bonds;
  record.Put(static_cast<std::uint8_t>(
      (joints_changed ? kJointsChanged : 0) | (tick.is_robot_shown ? 0 : kRobotHidden) |
      (controls_changed ? kControlsChanged : 0) | (bonds_changed ? kBondsChanged : 0)));
  std::vector<std::uint32_t> moved;
  for (std::uint32_t i = 0; i < tick.objects.size(); ++i) {
    if (!last_ || tick.objects[i] != last_->objects[i]) moved.push_back(i);
  }
  record.Put(static_cast<std::uint32_t>(moved.size()));
  for (std::uint32_t i : moved) {
    record.Put(i);
    record.Put(tick.objects[i].is_present);
    for (double number : tick.objects[i].position) record.Put(number);
    for (double number : tick.objects[i].rotation) record.Put(number);
  }
  if (joints_changed) {
    for (double q : tick.joints) record.Put(q);
  }
  if (controls_changed) {
    for (const world::ControlState& control : tick.controls) {
      record.Put(control.state);
      record.Put(control.override_state);
      record.Put(control.position);
    }
  }
  if (bonds_changed) {
    for (const TraceBond& bond : tick.bonds) {
      record.Put(bond.guest);
      record.Put(bond.tightness);
      record.Put(bond.is_locked);
    }
  }
  file_.Append(record.bytes());
  last_ = tick;
}

TraceLimits::TraceLimits(const scene::SceneSpec& scene) {
  for (const scene::ObjectSpec& object : scene.objects) {
    for (const scene::Part* control : scene::ControlsOf(object.whole)) {
      num_states.push_back(scene::NumStatesOf(*control));
    }
    for (const auto& host : scene::HostsOf(object.whole)) {
      max_tightness.push_back(static_cast<int>(host.point->stages.size()));
    }
    num_guests += static_cast<int>(scene::GuestsOf(object.whole).size());
  }
}

bool TraceLimits::Allow(std::size_t control, const world::ControlState& state) const {
  return state.state >= 0 && state.state < num_states[control] && state.override_state >= -1 &&
         state.override_state < num_states[control] && state.position >= 0 && state.position <= 1;
}

bool TraceLimits::Allow(std::size_t host, const TraceBond& bond) const {
  return bond.guest >= -1 && bond.guest < num_guests && bond.tightness >= 0 &&
         bond.tightness <= max_tightness[host] && (bond.guest < 0) == (bond.tightness == 0);
}

TraceReader::TraceReader(const Recording& recording)
    : path_(recording.directory / "trace.bin"),
      bytes_(ReadFile(path_, kMaxBytes)),
      rest_(std::as_bytes(std::span(bytes_.data(), bytes_.size()))),
      limits_(recording.scene) {
  const auto fail = [this](const std::string& message) {
    throw InputError({path_.string(), 0, "", message});
  };
  for (char letter : kMagic) {
    if (rest_.Get<char>() != letter) fail("this is not a trace of a recording");
  }
  const auto version = rest_.Get<std::uint32_t>();
  if (version != kVersion) {
    fail("its format is version " + std::to_string(version) + ", expected " +
         std::to_string(kVersion));
  }
  object_names_ = GetNames(&rest_);
  joint_names_ = GetNames(&rest_);
  if (!rest_.ok()) fail("its header is cut short");

  bool fits = object_names_.size() == recording.scene.objects.size();
  for (std::size_t i = 0; fits && i < object_names_.size(); ++i) {
    fits = object_names_[i] == recording.scene.objects[i].id();
  }
  const std::size_t num_joints = recording.robot ? recording.robot->model.links.size() : 0;
  if (!fits || joint_names_.size() != num_joints) {
    fail("is of another scene or robot than scene.xml and robot.urdf");
  }
  now_.objects.resize(object_names_.size());
  now_.joints.resize(joint_names_.size());
  now_.controls.resize(limits_.num_states.size());
  now_.bonds.resize(limits_.max_tightness.size());
}

std::optional<TraceTick> TraceReader::Next() {
  if (rest_.remaining() == 0) return std::nullopt;
  TraceTick next = now_;
  next.tick = rest_.Get<std::uint64_t>();
  next.hash = rest_.Get<std::uint64_t>();
  const auto flags = rest_.Get<std::uint8_t>();
  next.is_robot_shown = (flags & kRobotHidden) == 0;
  const auto num_moved = rest_.Get<std::uint32_t>();
  bool is_sound = (flags & ~kAllFlags) == 0 && num_moved <= next.objects.size() &&
                  next.tick == (has_begun_ ? now_.tick + 1 : 0);
  for (std::uint32_t k = 0; k < num_moved && rest_.ok() && is_sound; ++k) {
    const auto i = rest_.Get<std::uint32_t>();
    is_sound = i < next.objects.size();
    if (!is_sound) break;
    next.objects[i].is_present = rest_.Get<std::uint8_t>() != 0;
    for (double& number : next.objects[i].position) number = rest_.Get<double>();
    for (double& number : next.objects[i].rotation) number = rest_.Get<double>();
    is_sound = next.objects[i].position.allFinite() &&
               std::abs(next.objects[i].rotation.norm() - 1) < kUnitLength;
  }
  if ((flags & kJointsChanged) != 0) {
    for (double& q : next.joints) q = rest_.Get<double>();
  }
  if ((flags & kControlsChanged) != 0) {
    for (std::size_t i = 0; i < next.controls.size(); ++i) {
      world::ControlState& control = next.controls[i];
      control.state = rest_.Get<int>();
      control.override_state = rest_.Get<int>();
      control.position = rest_.Get<int>();
      is_sound = is_sound && limits_.Allow(i, control);
    }
  }
  if ((flags & kBondsChanged) != 0) {
    for (std::size_t i = 0; i < next.bonds.size(); ++i) {
      TraceBond& bond = next.bonds[i];
      bond.guest = rest_.Get<int>();
      bond.tightness = rest_.Get<int>();
      bond.is_locked = rest_.Get<std::uint8_t>() != 0;
      is_sound = is_sound && limits_.Allow(i, bond);
    }
  }
  if (!rest_.ok()) {
    is_cut_ = true;
    return std::nullopt;
  }
  for (double q : next.joints) is_sound = is_sound && std::isfinite(q);
  if (!is_sound) {
    throw InputError({path_.string(), 0, "",
                      "is damaged in the record after tick " + std::to_string(now_.tick)});
  }
  has_begun_ = true;
  return now_ = std::move(next);
}

}  // namespace smile::record
