// Hands on an engine in Python: see python/smile/adapters/engine.py.

#include "demonstrator/hands.h"

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

#include "arrays.h"
#include "base/state_hash.h"
#include "bindings.h"
#include "demonstrator/motion_plane.h"
#include "math/angles.h"

namespace smile::python {

namespace py = pybind11;

namespace {

using demonstrator::HandName;
using demonstrator::HandStates;
using mechanics::BodyId;
using Refusal = std::optional<world::Refusal>;

/// Engine whose methods are those of an object in Python. What they raise ends the call of Hands.
class PythonEngine : public demonstrator::Engine {
 public:
  explicit PythonEngine(py::object engine) : engine_(std::move(engine)) {}

  double step_seconds() const override { return engine_.attr("step_seconds").cast<double>(); }
  Refusal RefuseToReach(std::string_view object_id) const override {
    return engine_.attr("refuse_to_reach")(object_id).cast<Refusal>();
  }
  Refusal RefuseToCarry(BodyId body) const override {
    return engine_.attr("refuse_to_carry")(body.value).cast<Refusal>();
  }
  BodyId BodyOf(std::string_view object_id) const override {
    return BodyId{engine_.attr("body_of")(object_id).cast<decltype(BodyId::value)>()};
  }
  std::string ObjectOf(BodyId body) const override {
    return engine_.attr("object_of")(body.value).cast<std::string>();
  }
  demonstrator::BodyMotion MotionOf(BodyId body) const override {
    const auto [pose, velocity] =
        engine_.attr("motion_of")(body.value).cast<std::pair<Array, Array>>();
    const std::vector<double> x = NumbersFrom("pose", pose, 7);
    const std::vector<double> v = NumbersFrom("velocity", velocity, 6);
    const Quaternion q(x[3], x[4], x[5], x[6]);
    return {RigidTransform(q.normalized().toRotationMatrix(), Vector3(x[0], x[1], x[2])),
            Vector3(v[0], v[1], v[2]), Vector3(v[3], v[4], v[5])};
  }
  void SetCarried(BodyId body, bool is_carried) override {
    engine_.attr("set_carried")(body.value, is_carried);
  }
  void SetVelocity(BodyId body, const Vector3& v_WB, const Vector3& w_WB) override {
    engine_.attr("set_velocity")(body.value, ArrayOf(v_WB), ArrayOf(w_WB));
  }

 private:
  py::object engine_;
};

/// The state of all hands, as a value that Python only keeps.
struct SavedHands {
  HandStates states;
};

/// Hands with their engine and their states.
class EngineHands {
 public:
  explicit EngineHands(py::object engine) : engine_(std::move(engine)) {}
  EngineHands(const EngineHands&) = delete;
  EngineHands& operator=(const EngineHands&) = delete;

  demonstrator::Hands& hands() { return hands_; }
  const demonstrator::Hand& state(HandName hand) const {
    return states_[static_cast<std::size_t>(hand)];
  }
  SavedHands states() const { return {states_}; }
  void Restore(const SavedHands& saved) { states_ = saved.states; }
  std::optional<std::string> Held(HandName hand) const {
    const BodyId body = state(hand).held;
    return body ? std::optional(engine_.ObjectOf(body)) : std::nullopt;
  }
  /// Returns where the hand wants the grasped point, and the origin and the angles of its object:
  /// three numbers each, in m, m and degrees; None if it is empty.
  std::optional<std::tuple<Array, Array, Array>> Goal(HandName name) const {
    const demonstrator::Hand& hand = state(name);
    if (!hand.is_holding()) return std::nullopt;
    const RigidTransform& X_WB = hand.X_WB_goal;
    return std::tuple(ArrayOf(Vector3(X_WB * hand.p_BH)), ArrayOf(X_WB.translation()),
                      ArrayOf(FixedAxesAngles(X_WB.rotation())));
  }
  std::uint64_t Hash() const {
    StateHash hash;
    demonstrator::AddToHash(states_, &hash);
    return hash.value();
  }

 private:
  PythonEngine engine_;
  HandStates states_;
  demonstrator::Hands hands_{&engine_, &states_};
};

std::optional<Vector3> PointFrom(const std::optional<Array>& point) {
  return point ? std::optional(Vector3From("point", *point)) : std::nullopt;
}

std::pair<Refusal, std::vector<HandName>> PlanGrasp(EngineHands& on, HandName hand,
                                                    const std::string& object) {
  auto plan = on.hands().PlanGrasp(hand, object);
  return {std::move(plan.refusal), std::move(plan.to_release)};
}

Refusal MoveTo(EngineHands& on, HandName hand, const Array& position, std::optional<double> speed) {
  RequireSpeed(speed);
  return on.hands().MoveTo(hand, Vector3From("position", position), speed);
}

/// Returns (refusal, None) or (None, point [m]).
std::pair<Refusal, std::optional<Array>> PointOnPlane(EngineHands& on, HandName hand,
                                                      const Array& origin, const Array& direction,
                                                      double angle_deg, bool is_level) {
  if (auto empty = on.hands().RefuseIfEmpty(hand)) return {std::move(empty), std::nullopt};
  world::Refusal refusal;
  const demonstrator::Ray ray = {Vector3From("origin", origin),
                                 Vector3From("direction", direction)};
  const auto point =
      demonstrator::MeetPlane(hand, on.state(hand), {angle_deg, is_level}, ray, &refusal);
  if (!point) return {std::move(refusal), std::nullopt};
  return {std::nullopt, ArrayOf(*point)};
}

}  // namespace

void BindHands(py::module_& m) {
  py::class_<SavedHands>(m, "SavedHands");
  py::class_<EngineHands>(m, "EngineHands")
      .def(py::init<py::object>(), py::arg("engine"))
      .def("plan_grasp", &PlanGrasp)
      .def("grasp",
           [](EngineHands& on, HandName hand, const std::string& object,
              const std::optional<Array>& point) {
             return on.hands().Grasp(hand, object, PointFrom(point));
           })
      .def("move_to", &MoveTo)
      .def("rotate",
           [](EngineHands& on, HandName hand, const Array& angles) {
             return on.hands().Rotate(hand, Vector3From("angles", angles) * 180.0 / M_PI);
           })
      .def("release", [](EngineHands& on, HandName hand) { return on.hands().Release(hand); })
      .def("point_on_plane", &PointOnPlane)
      .def("held", &EngineHands::Held)
      .def("goal", &EngineHands::Goal)
      .def("has_arrived",
           [](EngineHands& on, HandName hand) { return on.hands().has_arrived(hand); })
      .def("before_step", [](EngineHands& on) { on.hands().BeforeStep(); })
      .def("hash", &EngineHands::Hash)
      .def("states", &EngineHands::states)
      .def("restore", &EngineHands::Restore);
}

}  // namespace smile::python
