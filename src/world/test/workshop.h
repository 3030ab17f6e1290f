#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "math/angles.h"
#include "world/tabletop.h"

namespace smile::world {

inline scene::Part BlockPart(const Vector3& size, const Vector3& p_PE = Vector3::Zero()) {
  return {.X_PE = RigidTransform(p_PE), .shape = scene::Block{size}};
}

inline scene::ObjectSpec ObjectAt(std::string id, scene::Shape shape, const Vector3& p_WB,
                                  double mass = 1) {
  return {.whole = {.id = std::move(id), .X_PE = RigidTransform(p_WB), .shape = std::move(shape)},
          .mass = mass};
}

/// Returns the stages of a screw of 0.2 m whose tip goes into a nut's upper side: each is 1/30 m
/// deeper and 45 degrees further.
inline std::vector<scene::TightnessStage> ScrewStages(int count) {
  std::vector<scene::TightnessStage> stages;
  for (int k = 1; k <= count; ++k) {
    stages.push_back({.X_HS = {RotationFromFixedAxes({0, 0, 45.0 * k}), Vector3(0, 0, -k / 30.0)}});
  }
  return stages;
}

/// Returns a nut of 0.11 m height; the upper end of its hole is the host point ID_hole.
inline scene::ObjectSpec Nut(const std::string& id, const Vector3& p_WB, int num_stages = 3,
                             double mass = 1) {
  scene::Composite nut;
  nut.parts = {{.X_PE = {}, .shape = scene::Ring{0.06, 0.03, 0.11, 12}}};
  nut.hosts = {{.id = id + "_hole",
                .type = "m8",
                .X_PH = RigidTransform(Vector3(0, 0, 0.055)),
                .stages = ScrewStages(num_stages)}};
  return ObjectAt(id, nut, p_WB, mass);
}

/// Returns a screw with a head; its lower end is the guest point ID_tip.
inline scene::ObjectSpec Screw(const std::string& id, const Vector3& p_WB,
                               const std::string& initial_host = "", int initial_tightness = 1) {
  scene::Composite screw;
  screw.parts = {BlockPart({0.03, 0.03, 0.2}), BlockPart({0.08, 0.08, 0.02}, {0, 0, 0.11})};
  screw.guests = {{.id = id + "_tip",
                   .type = "m8",
                   .X_PG = RigidTransform(Vector3(0, 0, -0.1)),
                   .initial_host = initial_host,
                   .initial_tightness = initial_host.empty() ? 0 : initial_tightness}};
  return ObjectAt(id, screw, p_WB, 0.5);
}

inline scene::HostPoint& HostPointOf(scene::ObjectSpec& object) {
  return std::get<scene::Composite>(object.whole.shape).hosts.front();
}
inline scene::GuestPoint& GuestPointOf(scene::ObjectSpec& object) {
  return std::get<scene::Composite>(object.whole.shape).guests.front();
}

/// Returns lamps in a corner of the table, whose states 0, 1, … differ only in their number.
inline scene::ObjectSpec Lamps(const std::string& id, int num_states,
                               std::vector<std::string> downstream = {}) {
  scene::IndicatorLights lamps{.downstream = std::move(downstream)};
  lamps.states.resize(static_cast<std::size_t>(num_states));
  return ObjectAt(id, lamps, {-0.8, 0.5, 0.1}, /*mass=*/0);
}

/// A table on which objects are fastened, without hands.
class WorkshopTest : public ::testing::Test {
 protected:
  void Start(std::vector<scene::ObjectSpec> objects, double meters_per_unit = 0.1) {
    Start(scene::SceneSpec{
        .name = "test", .meters_per_unit = meters_per_unit, .objects = std::move(objects)});
  }
  void Start(const scene::SceneSpec& scene) {
    tabletop_.reset();
    world_ = std::make_unique<physics::World>();
    tabletop_ = std::make_unique<Tabletop>(world_.get(), scene);
  }
  void StepSeconds(double seconds) {
    for (int i = 0; i < seconds * 480; ++i) world_->Step();
  }
  physics::Body& BodyOf(std::string_view id) { return world_->body(tabletop_->Find(id)->body); }
  RigidTransform PoseOf(std::string_view id) { return BodyOf(id).pose_in_world(); }
  Vector3 PositionOf(std::string_view id) { return PoseOf(id).translation(); }

  /// Returns "" if it succeeds, else the refusal.
  std::string Fasten(std::string_view id) {
    return tabletop_->Fasten(*tabletop_->Find(id), PositionOf(id)).value_or("");
  }
  std::string Loosen(std::string_view id) {
    return tabletop_->Loosen(*tabletop_->Find(id), PositionOf(id)).value_or("");
  }
  std::string Trigger(std::string_view control, std::string_view part = "") {
    return tabletop_->Trigger(control, part).value_or("");
  }
  /// Returns the state as in recordings.
  std::string StateOf(std::string_view control) {
    const model::ControlIndex index = *tabletop_->model().FindControl(control);
    return RecordedState(tabletop_->model().control(index), tabletop_->controls().states()[index]);
  }
  int TightnessOf(std::string_view host) {
    const auto index = tabletop_->model().FindHost(host);
    return index ? tabletop_->bonds().states()[*index].tightness : -1;
  }
  void ExpectPose(std::string_view id, const Vector3& p_WB, const Vector3& angles_deg) {
    const RigidTransform X_WB = PoseOf(id);
    EXPECT_LT((X_WB.translation() - p_WB).norm(), 1e-6) << id << X_WB.translation().transpose();
    EXPECT_TRUE(X_WB.rotation().isApprox(RotationFromFixedAxes(angles_deg), 1e-6))
        << id << "\n"
        << X_WB.rotation();
  }

  std::unique_ptr<physics::World> world_;
  std::unique_ptr<Tabletop> tabletop_;
};

}  // namespace smile::world
