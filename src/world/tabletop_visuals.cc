// What there is to be seen of a tabletop.

#include "world/internal_ground.h"
#include "world/tabletop.h"

namespace smile::world {
namespace {

/// A look that nothing has: nothing of the choice is to be seen.
constexpr int kHidden = -1;

/// Links are drawn longer than they are, so that a chain has no gaps.
void Lengthen(double padding, scene::Visual* visual) {
  if (auto* block = std::get_if<scene::Block>(&visual->shape)) block->size.y() += 2 * padding;
}

}  // namespace

// Each object is a choice, hidden once it is destroyed; its controls are the choices after it.

void Tabletop::AppendVisuals(scene::VisualModel* model) const {
  const auto name_object = [model](const std::string& name) {
    model->object_names.push_back(name);
    return static_cast<std::uint32_t>(model->object_names.size() - 1);
  };
  const scene::Solid table = TableSolid(table_);
  model->visuals.push_back({.shape = scene::VisualShapeOf(table.shape),
                            .color = table.color,
                            .X_FV = table.X_BS,
                            .object_id = name_object("table")});
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    const std::uint32_t object_id = name_object(objects_[i].id());
    const int presence = model->num_choices++;
    for (scene::Visual visual : scene::VisualsOf(objects_[i].spec->whole)) {
      visual.frame = model->num_frames;
      visual.object_id = object_id;
      visual.choice = visual.choice < 0 ? presence : presence + 1 + visual.choice;
      if (link_padding_[i]) Lengthen(*link_padding_[i], &visual);
      model->visuals.push_back(visual);
    }
    ++model->num_frames;
    model->num_choices += static_cast<int>(LooksOf(i).size());
  }
}

void Tabletop::AppendVisualState(scene::VisualState* state) const {
  std::vector<bool> is_present;
  for (const Object& object : objects_) {
    is_present.push_back(IsPresent(object));
    state->poses.push_back(is_present.back() ? world_->body(object.body).pose_in_world()
                                             : RigidTransform());
  }
  state->looks = LooksAt(controls_.states(), is_present);
}

std::vector<int> Tabletop::LooksOf(std::size_t object) const {
  std::vector<int> looks;
  const auto [first, last] = controls_.RangeOf(object);
  for (std::size_t i = first; i < last; ++i) {
    looks.push_back(LookOf(controls_.all()[i], controls_.states()[i]));
  }
  return looks;
}

std::vector<int> Tabletop::LooksAt(const std::vector<ControlState>& controls,
                                   const std::vector<bool>& is_present) const {
  std::vector<int> looks;
  std::size_t next = 0;  // controls are in the order of their objects
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    looks.push_back(is_present[i] ? 0 : kHidden);
    for (; next < controls.size() && controls_.all()[next].object == i; ++next) {
      looks.push_back(is_present[i] ? LookOf(controls_.all()[next], controls[next]) : kHidden);
    }
  }
  return looks;
}

}  // namespace smile::world
