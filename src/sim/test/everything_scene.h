#pragma once

#include <string>
#include <utility>
#include <vector>

#include "math/angles.h"
#include "scene/scene_spec.h"

namespace smile::sim {

/// One of every mechanism, in 0.1 m units made of plain values:
/// a panel with a switch `power`, lamps `lamps` and a dial `dial`, which contact presses; a nut
/// with a host `thread` and three stages that drive the lamps, override them and lock the nut
/// `other`; a screw with the guest `tip`, a spare screw; a drawer in a case; a chain of five links;
/// a loose ball; a block beyond the table's edge that falls for 0.7 s.
class EverythingScene {
 public:
  static scene::SceneSpec Make() {
    scene::SceneSpec scene{.name = "everything"};
    scene.objects = {Panel(),
                     Nut("nut", {-0.5, 0.2, 0.03}, /*drives=*/true),
                     Nut("other_nut", {-0.3, 0.2, 0.03}, /*drives=*/false),
                     Screw("screw", {-0.5, 0.2, 0.2}, "nut_thread"),
                     Screw("spare", {-0.3, 0.0, 0.1}, ""),
                     Simple("ball", scene::Sphere{0.04}, {0.3, -0.4, 0.3})};
    AddDrawer(&scene);
    AddChain(&scene);
    scene.objects.push_back(Simple("stray", scene::Block{}, {1.3, 0, 1.5}));
    return scene;
  }

  /// Appends `weight`, which falls on the dial, and tools of a long reach, which act from anywhere
  /// and at angles up to 90 degrees: `shears` cut the chain, `driver` turns the screw by a stage
  /// every 60 degrees, and `key` loosens it.
  static void AddTools(scene::SceneSpec* scene) {
    scene->objects.push_back(Simple("weight", scene::Block{{0.04, 0.04, 0.04}}, {0.1, 0.3, 0.2}));
    const auto add_tool = [scene](const char* id, const Vector3& p_WB, scene::ToolSpec tool) {
      tool.reach = 5;
      if (tool.action != scene::ToolAction::kCut) tool.angle = DegreesToRadians(90.0);
      scene->objects.push_back(Simple(id, scene::Block{{0.1, 0.04, 0.02}}, p_WB));
      scene->objects.back().tool = tool;
    };
    add_tool("shears", {0, -0.1, 0.02},
             {.action = scene::ToolAction::kCut, .axis = {1, 0, 0}, .edge = 0.1});
    add_tool("driver", {0.2, -0.1, 0.02},
             {.action = scene::ToolAction::kDrive, .type = "ph2", .turn = DegreesToRadians(60.0)});
    add_tool("key", {0.4, -0.1, 0.02}, {.action = scene::ToolAction::kLoosen, .type = "hex"});
    for (scene::ObjectSpec& object : scene->objects) {
      if (object.id() != "screw") continue;
      auto& screw = std::get<scene::Composite>(object.whole.shape);
      screw.guests[0].accepts = {{.type = "ph2", .p_GS = {0, 0, 0.12}},
                                 {.type = "hex", .p_GS = {0, 0, 0.11}, .axis = {1, 0, 0}}};
    }
  }
  /// Returns the scene with tools.
  static scene::SceneSpec MakeWithTools() {
    scene::SceneSpec scene = Make();
    AddTools(&scene);
    return scene;
  }

 private:
  static scene::ObjectSpec Object(std::string id, scene::Shape shape, const Vector3& p_WB) {
    scene::ObjectSpec object;
    object.whole = {.id = std::move(id), .X_PE = RigidTransform(p_WB), .shape = std::move(shape)};
    object.descriptions = {{"shape", "composite"}};
    return object;
  }
  static scene::ObjectSpec Simple(std::string id, scene::Shape shape, const Vector3& p_WB) {
    return Object(std::move(id), std::move(shape), p_WB);
  }
  static scene::Part BlockPart(const Vector3& size, const Vector3& p_PE, std::string id = {},
                               std::optional<int> next_state = std::nullopt) {
    return {.id = std::move(id),
            .X_PE = RigidTransform(p_PE),
            .next_state = next_state,
            .shape = scene::Block{size}};
  }

  static scene::ObjectSpec Panel() {
    scene::IndicatorLights lamps{.num_lights = 2, .downstream = {"dial"}};
    lamps.states = {{.name = "off", .lights = {}},
                    {.name = "left", .lights = {{0, {0, 1, 0}}}},
                    {.name = "right", .lights = {{1, {1, 0, 0}}}}};
    scene::CustomControl dial{.name = "dial"};
    for (int state = 0; state < 2; ++state) {
      dial.states.push_back(
          {.name = state == 0 ? "flat" : "tall",
           .parts = {BlockPart({0.05, 0.05, state == 0 ? 0.02 : 0.1},
                               {0, 0, state == 0 ? 0.01 : 0.05}, "knob", 1 - state)}});
      dial.states.back().parts[0].trigger =
          scene::TriggerRule{.cause = scene::TriggerCause::kPress};
    }
    scene::Composite panel;
    panel.parts = {BlockPart({0.4, 0.2, 0.04}, {0, 0, 0}),
                   {.id = "power",
                    .X_PE = RigidTransform(Vector3(-0.1, 0, 0.02)),
                    .shape = scene::ToggleSwitch{.num_states = 3, .downstream = {"lamps"}}},
                   {.id = "lamps", .X_PE = RigidTransform(Vector3(0, 0.05, 0.02)), .shape = lamps},
                   {.id = "dial", .X_PE = RigidTransform(Vector3(0.1, 0, 0.02)), .shape = dial}};
    return Object("panel", panel, {0, 0.3, 0.021});
  }

  static scene::ObjectSpec Nut(const std::string& id, const Vector3& p_WB, bool drives) {
    scene::HostPoint thread{.id = id + "_thread", .type = "m8", .X_PH = {}};
    for (int stage = 1; stage <= 3; ++stage) {
      thread.stages.push_back(
          {.X_HS = {RotationFromFixedAxes({0, 0, 45.0 * stage}), Vector3(0, 0, 0.1 - 0.02 * stage)},
           .downstream_state = drives && stage == 2 ? std::optional(2) : std::nullopt,
           .locks_downstream = drives && stage == 3});
    }
    if (drives) {
      thread.downstream = "lamps";
      thread.downstream_override = "lamps";
      thread.downstream_lock = "other_nut_thread";
    }
    scene::Composite nut;
    nut.parts = {{.X_PE = {}, .shape = scene::Ring{0.06, 0.03, 0.05, 12}}};
    nut.hosts = {thread};
    return Object(id, nut, p_WB);
  }

  static scene::ObjectSpec Screw(const std::string& id, const Vector3& p_WB,
                                 const std::string& initial_host) {
    scene::Composite screw;
    screw.parts = {BlockPart({0.02, 0.02, 0.1}, {0, 0, 0}),
                   BlockPart({0.08, 0.08, 0.02}, {0, 0, 0.06})};
    screw.guests = {{.id = id + "_tip",
                     .type = "m8",
                     .X_PG = RigidTransform(Vector3(0, 0, -0.05)),
                     .initial_host = initial_host,
                     .initial_tightness = initial_host.empty() ? 0 : 1}};
    return Object(id, screw, p_WB);
  }

  static void AddDrawer(scene::SceneSpec* scene) {
    scene::SliderSpec slider{.X_WJ = {RotationFromFixedAxes({0, 0, 90}), Vector3(0.6, 0.1, 0.15)},
                             .first_object = scene->objects.size(),
                             .max_offset = 0.2,
                             .initial_offset = 0.1,
                             .damping = 0.5,
                             .softness = 0.8};
    scene->objects.push_back(
        Object("case", scene::Box{{0.4, 0.3, 0.15}, 0.01}, slider.pose_of_first().translation()));
    scene->objects.push_back(
        Object("drawer", scene::Block{{0.3, 0.2, 0.05}}, slider.pose_of_second().translation()));
    scene->objects[slider.first_object].whole.X_PE = slider.pose_of_first();
    scene->objects[slider.first_object + 1].whole.X_PE = slider.pose_of_second();
    scene->sliders.push_back(slider);
  }

  static void AddChain(scene::SceneSpec* scene) {
    scene::ChainSpec chain{.id = "rope",
                           .start_id = "rope-start",
                           .end_id = "rope-end",
                           .p_WStart = {-0.6, -0.4, 0.5},
                           .p_WEnd = {-0.1, -0.4, 0.4},
                           .first_object = scene->objects.size()};
    for (int i = 0; i < 6; ++i) chain.link_ids.push_back("rope-link" + std::to_string(i));
    for (scene::ObjectSpec& piece : PiecesOf(chain, scene->meters_per_unit)) {
      scene->objects.push_back(std::move(piece));
    }
    scene->chains.push_back(chain);
  }
};

}  // namespace smile::sim
