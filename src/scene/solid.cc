#include "scene/solid.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "base/overloaded.h"
#include "scene/internal_lights.h"
#include "scene/internal_prisms.h"

// Collision shapes of objects: every shape of the scene language as a union of convex solids, in a
// fixed order. The order matters twice: controls are numbered along it, and contacts are computed
// in it.

namespace smile::scene {
namespace {

/// Context of a piece: its pose in the body, and the control and variant to which it belongs.
struct Belonging {
  RigidTransform X_BE;
  int control = -1;
  int variant = 0;
  // Inherited inside a state of a custom control.
  int next_state = -1;
  TriggerRule rule{};

  Belonging Child(const RigidTransform& X_EC) const {
    Belonging child = *this;
    child.X_BE = X_BE * X_EC;
    return child;
  }
  /// Returns this place with what the part says about its trigger.
  Belonging Of(const Part& part) const {
    Belonging own = *this;
    own.next_state = part.next_state.value_or(next_state);
    own.rule = part.trigger.value_or(rule);
    return own;
  }
};

/// Returns the trigger of a piece; nullopt if only hands can trigger it, or nothing would happen.
std::optional<Trigger> TriggerOf(const TriggerRule& rule, const Vector3& inward_in_body,
                                 int next_state) {
  if (rule.cause == TriggerCause::kHand) return std::nullopt;
  return Trigger{.rule = rule, .inward_in_body = inward_in_body, .next_state = next_state};
}

/// Collects the pieces of a body in the order of the file, numbering controls as ControlsOf() does.
class SolidCollector {
 public:
  void Append(const Part& part, const Belonging& parent) {
    const Belonging place = parent.Of(part);
    std::visit(
        Overloaded{[&](const Box& box) { AppendContainer(box, part, place); },
                   [&](const Composite& composite) {
                     for (const Part& child : composite.parts) {
                       Append(child, place.Child(child.X_PE));
                     }
                   },
                   [&](const Frustum& frustum) { Add(HullOf(frustum), part, place); },
                   [&](const Ring& ring) {
                     for (const RingPiece& piece : PiecesOf(ring)) {
                       Add(piece.hull, part, place.Child(piece.X_RP));
                     }
                   },
                   [&](const Custom& custom) {
                     for (const Hull& hull : custom.mesh->pieces) {
                       Add(Scaled(hull, custom.scale), part, place);
                     }
                   },
                   [&](const ToggleSwitch& toggle) { AppendSwitch(toggle, part, place); },
                   [&](const IndicatorLights& lights) {
                     // Their discs do not depend on the state, but the number is taken: indices
                     // count all controls.
                     ++num_controls_;
                     for (int i = 0; i < lights.num_lights; ++i) {
                       const Belonging at = place.Child(PoseOfLight(lights, i));
                       solids_.push_back(
                           {DiscOf(lights), at.X_BE, part.color, part.id, at.control, at.variant});
                     }
                   },
                   [&](const CustomControl& control) {
                     const int number = num_controls_++;
                     for (std::size_t variant = 0; variant < control.states.size(); ++variant) {
                       for (const Part& child : control.states[variant].parts) {
                         Belonging at = place.Child(child.X_PE);
                         at.control = number;
                         at.variant = static_cast<int>(variant);
                         Append(child, at);
                       }
                     }
                   },
                   [&](const auto& simple) { Add(simple, part, place); }},
        part.shape);
  }

  std::vector<Solid> Take() { return std::move(solids_); }

 private:
  void Add(const SolidShape& shape, const Part& part, const Belonging& place) {
    // A cylinder's axis is y, that of all other shapes is z.
    const bool is_cylinder = std::holds_alternative<Cylinder>(part.shape);
    const Vector3 axis = place.X_BE.rotation().col(is_cylinder ? 1 : 2);
    auto trigger = place.next_state >= 0 ? TriggerOf(place.rule, -axis, place.next_state)
                                         : std::optional<Trigger>();
    solids_.push_back({.shape = shape,
                       .X_BS = place.X_BE,
                       .color = part.color,
                       .part_id = part.id,
                       .control = place.control,
                       .variant = place.variant,
                       .trigger = std::move(trigger)});
  }

  /// Appends floor and walls of a box.
  void AppendContainer(const Box& box, const Part& part, const Belonging& place) {
    const double X = box.size.x(), Y = box.size.y(), Z = box.size.z(), t = box.thickness;
    const auto wall = [&](const Vector3& size, const Vector3& center) {
      Add(Block{size}, part, place.Child(RigidTransform(center)));
    };
    // The floor spans the full area; the walls (left, right, near, far) stand on it.
    wall({X, Y, t}, {0, 0, -Z / 2 + t / 2});
    wall({t, Y - 2 * t, Z - t}, {-(X / 2 - t / 2), 0, t / 2});
    wall({t, Y - 2 * t, Z - t}, {X / 2 - t / 2, 0, t / 2});
    wall({X, t, Z - t}, {0, Y / 2 - t / 2, t / 2});
    wall({X, t, Z - t}, {0, -(Y / 2 - t / 2), t / 2});
  }

  /// Appends both buttons of a switch for both of its positions. The width is such that the flat
  /// and the raised button together span size.x.
  void AppendSwitch(const ToggleSwitch& toggle, const Part& part, const Belonging& place) {
    const int number = num_controls_++;
    const double width = toggle.size.x() / (1 + std::cos(toggle.angle)), height = toggle.size.z();
    const Block button{{width, toggle.size.y(), height}};
    const RigidTransform X_flat(Vector3(-width / 2, 0, height / 2));
    const RigidTransform X_raised =
        AboutY(-toggle.angle) * RigidTransform(Vector3(width / 2, 0, height / 2));
    for (int position : {0, 1}) {
      // The rocker turns about its middle: in position 0 the left button is flat, in position 1 the
      // right.
      const RigidTransform X_ERocker = position == 0 ? RigidTransform() : AboutY(toggle.angle);
      const auto add = [&](Button which, const RigidTransform& X_RockerButton) {
        const RigidTransform X_BButton = place.X_BE * (X_ERocker * X_RockerButton);
        // Only the raised button can be pressed.
        const bool is_raised = (which == Button::kLeft) == (position == 1);
        solids_.push_back(
            {.shape = button,
             .X_BS = X_BButton,
             .color = part.color,
             .part_id = part.id,
             .control = number,
             .variant = position,
             .button = which,
             .trigger = is_raised ? TriggerOf(toggle.trigger, -X_BButton.rotation().col(2), -1)
                                  : std::nullopt});
      };
      add(Button::kLeft, X_flat);
      add(Button::kRight, X_raised);
    }
  }

  static RigidTransform AboutY(double angle) {
    return {Matrix3(Eigen::AngleAxisd(angle, Vector3::UnitY())), Vector3::Zero()};
  }

  std::vector<Solid> solids_;
  int num_controls_ = 0;
};

/// Returns the moments of a shape centered at its origin, with principal axes along its own.
VolumeMoments AboutOrigin(double volume, const Vector3& unit_inertia) {
  return {.volume = volume, .unit_inertia = unit_inertia.asDiagonal()};
}

VolumeMoments VolumeMomentsOf(const SolidShape& shape) {
  using std::numbers::pi;
  return std::visit(
      Overloaded{[](const Block& block) {
                   const Vector3 square = block.size.cwiseAbs2();
                   return AboutOrigin(block.size.prod(),
                                      (Vector3::Constant(square.sum()) - square) / 12.0);
                 },
                 [](const Cylinder& c) {
                   const double across = (3 * c.radius * c.radius + c.length * c.length) / 12.0;
                   return AboutOrigin(pi * c.radius * c.radius * c.length,
                                      {across, c.radius * c.radius / 2.0, across});
                 },
                 [](const Sphere& s) {
                   return AboutOrigin(4.0 / 3.0 * pi * s.radius * s.radius * s.radius,
                                      Vector3::Constant(0.4 * s.radius * s.radius));
                 },
                 [](const Hull& hull) { return MomentsOf(hull); }},
      shape);
}

}  // namespace

std::vector<Solid> SolidsOf(const Part& whole) {
  SolidCollector collector;
  collector.Append(whole, {});
  return collector.Take();
}

Solid TableSolid(const TableSpec& table) {
  return {.shape = Block{{table.x_span, table.y_span, table.thickness}},
          .X_BS = RigidTransform(Vector3(0, 0, -table.thickness / 2)),
          .color = table.color,
          .part_id = "table"};
}

std::size_t NumSolidsOf(const Part& whole) {
  const auto sum = [](const std::vector<Part>& parts) {
    std::size_t count = 0;
    for (const Part& part : parts) count += NumSolidsOf(part);
    return count;
  };
  return std::visit(
      // Must agree with SolidCollector; it needs no geometry, so that limits are checked before
      // work.
      Overloaded{[](const Box&) -> std::size_t { return 5; },
                 [](const Ring& ring) { return NumPiecesOf(ring); },
                 [](const Custom& custom) { return custom.mesh ? custom.mesh->pieces.size() : 0; },
                 [&](const Composite& composite) { return sum(composite.parts); },
                 [](const ToggleSwitch&) -> std::size_t { return 4; },
                 [](const IndicatorLights& lights) -> std::size_t { return lights.num_lights; },
                 [&](const CustomControl& control) {
                   std::size_t count = 0;
                   for (const CustomControl::State& state : control.states) {
                     count += sum(state.parts);
                   }
                   return count;
                 },
                 [](const auto&) -> std::size_t { return 1; }},
      whole.shape);
}

MassProperties MassPropertiesOf(const std::vector<Solid>& solids, double mass,
                                const Vector3& center) {
  MassProperties properties{.mass = mass, .center = center};
  std::vector<VolumeMoments> moments;
  double volume = 0;
  for (const Solid& solid : solids) {
    moments.push_back(VolumeMomentsOf(solid.shape));
    volume += moments.back().volume;
  }
  if (volume <= 0) {
    // Without volume, as an empty composite: the inertia of a ball with a radius of half a unit
    // (0.05 m).
    properties.inertia = mass * 0.4 * 0.05 * 0.05 * Matrix3::Identity();
    return properties;
  }
  for (std::size_t i = 0; i < solids.size(); ++i) {
    // One density for the whole object. Overlapping pieces count twice.
    const double share = mass * moments[i].volume / volume;
    const Matrix3& R = solids[i].X_BS.rotation();
    const Vector3 p = solids[i].X_BS * moments[i].center - center;
    // Parallel-axis theorem: the piece's own inertia, turned, plus that of its mass at its center.
    properties.inertia += share * (R * moments[i].unit_inertia * R.transpose());
    properties.inertia += share * (p.squaredNorm() * Matrix3::Identity() - p * p.transpose());
  }
  return properties;
}

}  // namespace smile::scene
