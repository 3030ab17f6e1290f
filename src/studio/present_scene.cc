#include "studio/present_scene.h"

#include <algorithm>
#include <map>
#include <optional>

#include "page/requests.h"

namespace smile::studio {
namespace {

/// Calls `visit` with the part and all within it.
template <class Part, class Visit>
void VisitParts(Part& part, const Visit& visit) {
  visit(part);
  if (auto* composite = std::get_if<scene::Composite>(&part.shape)) {
    for (auto& child : composite->parts) VisitParts(child, visit);
  }
  if (auto* control = std::get_if<scene::CustomControl>(&part.shape)) {
    for (auto& state : control->states) {
      for (auto& child : state.parts) VisitParts(child, visit);
    }
  }
}

/// Lets a control begin in a state.
void Begin(const model::ControlState& state, scene::Shape* shape) {
  if (auto* toggle = std::get_if<scene::ToggleSwitch>(shape)) {
    toggle->is_left_pressed = state.position == 0;
    toggle->initial_state = state.state;
  } else if (auto* lights = std::get_if<scene::IndicatorLights>(shape)) {
    lights->initial_state = state.state;
  } else if (auto* custom = std::get_if<scene::CustomControl>(shape)) {
    custom->initial_state = state.state;
  }
}

void BeginControls(const sim::Simulation& simulation, scene::SceneSpec* scene) {
  std::map<std::string, model::ControlState> states;
  for (model::ControlIndex control : simulation.model().controls()) {
    states[simulation.model().control(control).id()] =
        simulation.tabletop().controls().states()[control];
  }
  for (scene::ObjectSpec& object : scene->objects) {
    VisitParts(object.whole, [&](scene::Part& part) {
      if (scene::IsControl(part.shape)) Begin(states[part.id], &part.shape);
    });
  }
}

void BeginBonds(const sim::Simulation& simulation, scene::SceneSpec* scene) {
  const model::Model& model = simulation.model();
  const std::vector<world::BondState>& bonds = simulation.tabletop().bonds().states();
  std::map<std::string, model::HostIndex> host_of_guest;
  for (model::HostIndex host : model.hosts()) {
    if (!bonds[host].guest) continue;
    host_of_guest.insert_or_assign(model.guest(*bonds[host].guest).point->id, host);
  }
  for (scene::ObjectSpec& object : scene->objects) {
    VisitParts(object.whole, [&](scene::Part& part) {
      auto* composite = std::get_if<scene::Composite>(&part.shape);
      if (composite == nullptr) return;
      for (scene::GuestPoint& guest : composite->guests) {
        const auto found = host_of_guest.find(guest.id);
        const bool is_bound = found != host_of_guest.end();
        guest.initial_host = is_bound ? model.host(found->second).point->id : "";
        guest.initial_tightness = is_bound ? bonds[found->second].tightness : 0;
      }
    });
  }
}

/// Sliders tell where their members are by themselves.
void PlaceSlider(const scene::SceneSpec& scene, scene::SliderSpec* slider) {
  const RigidTransform& X_WA = scene.objects[slider->first_object].pose_in_world();
  const RigidTransform& X_WB = scene.objects[slider->first_object + 1].pose_in_world();
  const RigidTransform X_WJ = X_WA * slider->X_JA.inverse();
  const double offset = -((X_WJ.inverse() * X_WB.translation()) - slider->X_JB.translation()).x();
  slider->X_WJ = X_WJ;
  slider->initial_offset = std::clamp(offset, slider->min_offset, slider->max_offset);
}

/// The number of pieces that are left of a string.
std::size_t CountLeft(const scene::ChainSpec& chain, const std::vector<bool>& is_taken) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < chain.link_ids.size() + 2; ++i) {
    if (!is_taken[chain.first_object + i]) ++count;
  }
  return count;
}

/// Takes out all that names what is not there any more.
void ForgetMissing(scene::SceneSpec* scene) {
  const std::set<std::string> ids = IdsOf(*scene);
  const auto forget = [&ids](std::string* id) {
    if (!ids.contains(*id)) id->clear();
  };
  const auto forget_among = [&ids](std::vector<std::string>* list) {
    std::erase_if(*list, [&ids](const std::string& id) { return !ids.contains(id); });
  };
  for (scene::ObjectSpec& object : scene->objects) {
    VisitParts(object.whole, [&](scene::Part& part) {
      if (auto* toggle = std::get_if<scene::ToggleSwitch>(&part.shape)) {
        forget_among(&toggle->downstream);
      } else if (auto* lights = std::get_if<scene::IndicatorLights>(&part.shape)) {
        forget_among(&lights->downstream);
      } else if (auto* custom = std::get_if<scene::CustomControl>(&part.shape)) {
        forget_among(&custom->downstream);
      } else if (auto* composite = std::get_if<scene::Composite>(&part.shape)) {
        for (scene::GuestPoint& guest : composite->guests) {
          forget(&guest.initial_host);
          if (guest.initial_host.empty()) guest.initial_tightness = 0;
        }
        for (scene::HostPoint& host : composite->hosts) {
          forget(&host.downstream);
          forget(&host.downstream_override);
          forget(&host.downstream_lock);
        }
      }
    });
  }
}

}  // namespace

std::set<std::string> IdsOf(const scene::SceneSpec& scene) {
  std::set<std::string> ids;
  for (const scene::SliderSpec& slider : scene.sliders) ids.insert(slider.id);
  for (const scene::ChainSpec& chain : scene.chains) ids.insert(chain.id);
  for (const scene::ObjectSpec& object : scene.objects) {
    VisitParts(object.whole, [&](const scene::Part& part) {
      ids.insert(part.id);
      const auto* composite = std::get_if<scene::Composite>(&part.shape);
      if (composite == nullptr) return;
      for (const scene::GuestPoint& guest : composite->guests) ids.insert(guest.id);
      for (const scene::HostPoint& host : composite->hosts) ids.insert(host.id);
    });
  }
  return ids;
}

scene::SceneSpec Without(scene::SceneSpec scene,
                         const std::function<bool(const scene::ObjectSpec&)>& is_taken) {
  std::vector<bool> taken;
  for (const scene::ObjectSpec& object : scene.objects) taken.push_back(is_taken(object));
  std::erase_if(scene.chains, [&](const scene::ChainSpec& chain) {
    const std::size_t num_pieces = chain.link_ids.size() + 2;
    if (CountLeft(chain, taken) == num_pieces) return false;
    std::fill_n(taken.begin() + static_cast<std::ptrdiff_t>(chain.first_object), num_pieces, true);
    return true;
  });
  std::erase_if(scene.sliders, [&](const scene::SliderSpec& slider) {
    return taken[slider.first_object] || taken[slider.first_object + 1];
  });
  std::vector<std::size_t> place(taken.size());
  std::vector<scene::ObjectSpec> left;
  for (std::size_t i = 0; i < taken.size(); ++i) {
    place[i] = left.size();
    if (!taken[i]) left.push_back(std::move(scene.objects[i]));
  }
  scene.objects = std::move(left);
  for (scene::SliderSpec& slider : scene.sliders) slider.first_object = place[slider.first_object];
  for (scene::ChainSpec& chain : scene.chains) chain.first_object = place[chain.first_object];
  ForgetMissing(&scene);
  return scene;
}

scene::SceneSpec PresentScene(const sim::Simulation& simulation) {
  const world::Tabletop& tabletop = simulation.tabletop();
  scene::SceneSpec scene = simulation.scene();
  std::vector<bool> is_gone, is_piece(scene.objects.size());
  for (const world::Object& object : tabletop.objects()) {
    is_gone.push_back(!tabletop.IsPresent(object) || tabletop.HasFallen(object));
  }
  for (const scene::ChainSpec& chain : scene.chains) {
    const std::size_t num_pieces = chain.link_ids.size() + 2;
    const std::size_t num_left = CountLeft(chain, is_gone);
    if (num_left > 0 && num_left < num_pieces) {
      throw page::RequestError(
          "the string '" + chain.id +
          "' lost a piece and cannot be put into a scene; undo that, or reload");
    }
    std::fill_n(is_piece.begin() + static_cast<std::ptrdiff_t>(chain.first_object), num_pieces,
                true);
  }
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    if (is_gone[i] || is_piece[i]) continue;
    scene.objects[i].whole.X_PE =
        simulation.physics().body(tabletop.objects()[i].body).pose_in_world();
  }
  for (scene::SliderSpec& slider : scene.sliders) {
    const std::size_t first = slider.first_object;
    if (is_gone[first] || is_gone[first + 1]) continue;
    PlaceSlider(scene, &slider);
    scene.objects[first].whole.X_PE = slider.pose_of_first();
    scene.objects[first + 1].whole.X_PE = slider.pose_of_second();
  }
  BeginControls(simulation, &scene);
  BeginBonds(simulation, &scene);
  std::size_t next = 0;
  return Without(std::move(scene), [&](const scene::ObjectSpec&) { return is_gone[next++]; });
}

std::vector<sim::Command> WhatGoesOn(const sim::Simulation& simulation) {
  std::vector<sim::Command> commands;
  if (const world::RobotBody* robot = simulation.robot()) {
    sim::JointAngles angles;
    if (robot->num_arms() > 0) angles.left = robot->ArmAngles(0);
    if (robot->num_arms() > 1) angles.right = robot->ArmAngles(1);
    if (robot->model().head) angles.head = robot->HeadAngle();
    if (angles != sim::JointAngles()) commands.push_back(angles);
    if (!simulation.is_robot_shown()) commands.push_back(sim::ShowRobot{.is_shown = false});
  }
  for (const sim::HandName name : demonstrator::kHandNames) {
    const demonstrator::Hand& hand = simulation.demonstrator().hand(name);
    const double angle_deg = simulation.demonstrator().plane_angle_deg(name);
    if (angle_deg != 0) commands.push_back(sim::Plane{.hand = name, .angle_deg = angle_deg});
    if (!hand.is_holding()) continue;
    const RigidTransform X_WB = simulation.physics().body(hand.held).pose_in_world();
    commands.push_back(sim::Grasp{.hand = name,
                                  .object = simulation.tabletop().Find(hand.held)->id(),
                                  .p_WQ = X_WB * hand.p_BH});
  }
  return commands;
}

}  // namespace smile::studio
