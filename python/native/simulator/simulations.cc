// States and simulations.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <chrono>
#include <limits>

#include "arrays.h"
#include "bindings.h"
#include "checkpoint/checkpoint.h"
#include "experiment/world_description.h"
#include "handle.h"
#include "saved_state.h"
#include "values.h"

namespace smile::python {
namespace {

using ModelPointer = std::shared_ptr<const model::Model>;

/// A saved state, or the bytes of one that belongs to a model not yet known.
struct State {
  std::optional<SavedState> state;
  std::vector<std::byte> bytes;
};

py::bytes BytesOf(const State& state) {
  const std::vector<std::byte> bytes = state.state ? Serialize(*state.state) : state.bytes;
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

State StateFrom(const py::bytes& bytes) {
  const std::string_view view = bytes;
  const auto span = std::as_bytes(std::span(view.data(), view.size()));
  return {.state = std::nullopt, .bytes = {span.begin(), span.end()}};
}

void BindState(py::module_& m) {
  py::class_<State>(m, "State", "A saved state of a simulation; bytes(state) writes it.")
      .def(py::init(&StateFrom))
      .def("__bytes__", &BytesOf)
      .def(py::pickle(&BytesOf, &StateFrom));
}

void Restore(Handle& handle, const State& state) {
  const ModelPointer start = [&] {
    const Handle::Use use(&handle);
    return use->start_model();
  }();
  if (!state.state) {
    handle.Restore(ParseSavedState(state.bytes, start));
    return;
  }
  // Usually the same model; otherwise an equal one.
  const ModelPointer& its_start = state.state->simulation.start_model;
  if (its_start != start && checkpoint::ModelHash(*its_start) != checkpoint::ModelHash(*start)) {
    throw std::invalid_argument("saved state: it belongs to another scene or robot");
  }
  handle.Restore(*state.state);
}

const world::Object& FindObject(const sim::Simulation& simulation, const std::string& id) {
  const auto index = simulation.model().FindObject(id);
  if (!index) throw py::key_error(id);
  return simulation.tabletop().objects()[*index];
}

const physics::Body& BodyOf(const sim::Simulation& simulation, const std::string& id) {
  const world::Object& object = FindObject(simulation, id);
  if (!simulation.tabletop().IsPresent(object)) {
    throw std::invalid_argument("object '" + id + "' is no longer in the world");
  }
  return simulation.physics().body(object.body);
}

/// Poses of all objects, one row each; rows of absent objects are NaN.
Array PosesOf(const sim::Simulation& simulation) {
  const auto& objects = simulation.tabletop().objects();
  Array poses({static_cast<py::ssize_t>(objects.size()), py::ssize_t{7}});
  double* out = poses.mutable_data();
  for (const world::Object& object : objects) {
    if (simulation.tabletop().IsPresent(object)) {
      WritePose(simulation.physics().body(object.body).pose_in_world(), out);
    } else {
      std::fill(out, out + 7, std::numeric_limits<double>::quiet_NaN());
    }
    out += 7;
  }
  return poses;
}

/// Lets Python handle signals during a long call, ten times a second: Ctrl-C ends it after a tick.
class SignalCheck {
 public:
  /// To be called without the interpreter's lock.
  /// @throws py::error_already_set if the handler of a signal has raised something.
  void operator()() {
    using namespace std::chrono_literals;
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ < 100ms) return;
    last_ = now;
    const py::gil_scoped_acquire acquire;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// Advances until a condition holds.
/// @returns false if `max_ticks` passed before.
bool RunUntil(sim::Simulation& simulation, const std::string& condition, std::uint64_t max_ticks) {
  // As in scripts: bodies at a turning point are slow for a tick, so rest must last.
  constexpr int kRestTicks = sim::kTicksPerSecond / 4;
  int rest = 0;
  const auto holds = [&]() -> bool {
    if (condition == "arrived") {
      return simulation.demonstrator().has_arrived() && !simulation.is_robot_following();
    }
    rest = simulation.is_still() ? rest + 1 : 0;
    return rest > kRestTicks;
  };
  SignalCheck check_signals;
  for (std::uint64_t i = 0; i < max_ticks; ++i) {
    simulation.Tick();
    if (holds()) return true;
    check_signals();
  }
  return false;
}

int ArmIndex(const sim::Simulation& simulation, const std::string& name) {
  if (simulation.robot() == nullptr) throw std::invalid_argument("there is no robot");
  const auto& arms = simulation.robot()->model().arms;
  for (std::size_t i = 0; i < arms.size(); ++i) {
    if (arms[i].name == name) return static_cast<int>(i);
  }
  throw py::key_error(name);
}

template <class Function>
auto WithArm(Function function) {
  return [function](Handle& handle, const std::string& name) {
    const Handle::Use use(&handle);
    const int arm = ArmIndex(*use, name);  // first: it throws where there is no robot
    return function(*use->robot(), arm);
  };
}

/// Applies a command in its written form, with lengths in units of the scene.
std::optional<std::string> Apply(Handle& handle, const std::string& json) {
  const Handle::Use use(&handle);
  const sim::Command command =
      sim::ParseCommand(sim::ParseLineJson(json), use->scene().meters_per_unit);
  const py::gil_scoped_release release;
  return use->Apply(command);
}

void BindCommands(py::class_<Handle>& simulation) {
  simulation.def("apply", &Apply)
      .def("grasp",
           [](Handle& handle, demonstrator::HandName hand, const std::string& object,
              const std::optional<Array>& point) {
             const Handle::Use use(&handle);
             sim::Grasp grasp{.hand = hand, .object = object};
             if (point) grasp.p_WQ = Vector3From("point", *point);
             return use->Apply(grasp);
           })
      .def("move_to",
           [](Handle& handle, demonstrator::HandName hand, const Array& position,
              std::optional<double> speed) {
             const Handle::Use use(&handle);
             RequireSpeed(speed);
             return use->Apply(sim::MoveTo{
                 .hand = hand, .p_WH = Vector3From("position", position), .speed = speed});
           })
      .def("rotate",
           [](Handle& handle, demonstrator::HandName hand, const Array& angles) {
             const Handle::Use use(&handle);
             return use->Apply(sim::Rotate{
                 .hand = hand, .angles_deg = Vector3From("angles", angles) * 180.0 / M_PI});
           })
      .def("held",
           [](Handle& handle, demonstrator::HandName hand) -> std::optional<std::string> {
             const Handle::Use use(&handle);
             const auto& state = use->demonstrator().hand(hand);
             const world::Object* object =
                 state.is_holding() ? use->tabletop().Find(state.held) : nullptr;
             return object != nullptr ? std::optional(object->id()) : std::nullopt;
           })
      .def("has_arrived",
           [](Handle& handle, demonstrator::HandName hand) {
             const Handle::Use use(&handle);
             return use->demonstrator().has_arrived(hand);
           })
      .def("set_joint_velocities",
           [](Handle& handle, const std::string& arm, const std::optional<Array>& velocities,
              const std::optional<double>& gripper) {
             const Handle::Use use(&handle);
             const int index = ArmIndex(*use, arm);
             sim::JointVelocities command;
             if (velocities) {
               command.arms[arm] = NumbersFrom("velocities", *velocities,
                                               use->robot()->model().arms[index].joints.size());
             }
             if (gripper) {
               if (!std::isfinite(*gripper)) throw std::invalid_argument("gripper is not finite");
               command.grippers[arm] = *gripper;
             }
             return use->Apply(command);
           })
      .def("set_joint_angles", [](Handle& handle, const std::string& arm, const Array& angles) {
        const Handle::Use use(&handle);
        const int index = ArmIndex(*use, arm);
        sim::JointAngles command;
        command.arms[arm] =
            NumbersFrom("angles", angles, use->robot()->model().arms[index].joints.size());
        return use->Apply(command);
      });
}

void BindViews(py::class_<Handle>& simulation) {
  simulation
      .def("poses",
           [](Handle& handle) {
             const Handle::Use use(&handle);
             return PosesOf(*use);
           })
      .def("object_ids",
           [](Handle& handle) {
             const Handle::Use use(&handle);
             return ObjectIds(use->model());
           })
      .def("is_present",
           [](Handle& handle, const std::string& id) {
             const Handle::Use use(&handle);
             return use->tabletop().IsPresent(FindObject(*use, id));
           })
      .def("has_fallen",
           [](Handle& handle, const std::string& id) {
             const Handle::Use use(&handle);
             return use->tabletop().HasFallen(FindObject(*use, id));
           })
      .def("pose",
           [](Handle& handle, const std::string& id) {
             const Handle::Use use(&handle);
             return PoseArray(BodyOf(*use, id).pose_in_world());
           })
      .def("velocity",
           [](Handle& handle, const std::string& id) {
             const Handle::Use use(&handle);
             const physics::Body& body = BodyOf(*use, id);
             const Vector3 v = body.linear_velocity(), w = body.angular_velocity();
             const double values[6] = {v.x(), v.y(), v.z(), w.x(), w.y(), w.z()};
             return ArrayOf(std::span<const double>(values));
           })
      .def("describe_controls",
           [](Handle& handle) {
             const Handle::Use use(&handle);
             return ToText(experiment::DescribeControls(*use));
           })
      .def("arm_angles", WithArm([](const world::RobotBody& robot, int arm) {
             return ArrayOf(robot.ArmAngles(arm));
           }))
      .def("arm_velocities", WithArm([](const world::RobotBody& robot, int arm) {
             return ArrayOf(robot.ArmVelocities(arm));
           }))
      .def("gripper_opening", WithArm([](const world::RobotBody& robot, int arm) {
             return robot.GripperOpening(arm);
           }))
      .def("tool_pose", WithArm([](const world::RobotBody& robot, int arm) {
             return PoseArray(robot.ToolPose(arm));
           }))
      .def("arm_held",
           [](Handle& handle, const std::string& name) {
             const Handle::Use use(&handle);
             std::vector<std::string> ids;
             for (physics::BodyId body : use->robot()->HeldBodies(ArmIndex(*use, name))) {
               if (const world::Object* object = use->tabletop().Find(body))
                 ids.push_back(object->id());
             }
             return ids;
           })
      .def("is_robot_following", [](Handle& handle) {
        const Handle::Use use(&handle);
        return use->is_robot_following();
      });
}

py::tuple RenderNow(Handle& handle, const std::string& camera, int width, int height, bool rgb,
                    bool depth, bool id) {
  const Handle::Use use(&handle);
  const std::vector<double> q =
      use->robot() != nullptr ? use->robot()->positions() : std::vector<double>();
  return Render(use->model(), [&use] { return use->visual_state(); }, q, use->is_robot_shown(),
                {.spec = {.width_px = width, .height_px = height, .camera = camera},
                 .channels = {.rgb = rgb, .depth = depth, .id = id}});
}

}  // namespace

void BindSimulation(py::module_& m) {
  BindState(m);
  py::enum_<demonstrator::HandName>(m, "HandName")
      .value("left", demonstrator::HandName::kLeft)
      .value("right", demonstrator::HandName::kRight)
      .value("both", demonstrator::HandName::kBoth)
      .value("any", demonstrator::HandName::kAny);
  py::class_<Handle> simulation(m, "Simulation");
  simulation
      .def(py::init([](std::shared_ptr<model::Model> model) {
        return std::make_unique<Handle>(std::move(model));
      }))
      .def("close", &Handle::Close)
      .def_property_readonly("is_closed", &Handle::is_closed)
      .def("model",
           [](Handle& handle) {
             const Handle::Use use(&handle);
             return std::const_pointer_cast<model::Model>(use->shared_model());
           })
      .def("step",
           [](Handle& handle, std::uint64_t ticks) {
             const Handle::Use use(&handle);
             const py::gil_scoped_release release;
             SignalCheck check_signals;
             for (std::uint64_t i = 0; i < ticks; ++i) {
               use->Tick();
               check_signals();
             }
           })
      .def("run_until",
           [](Handle& handle, const std::string& condition, std::uint64_t max_ticks) {
             const Handle::Use use(&handle);
             const py::gil_scoped_release release;
             return RunUntil(*use, condition, max_ticks);
           })
      .def("tick",
           [](Handle& handle) {
             const Handle::Use use(&handle);
             return use->tick();
           })
      .def("hash",
           [](Handle& handle) {
             const Handle::Use use(&handle);
             return use->state_hash();
           })
      .def("is_still",
           [](Handle& handle) {
             const Handle::Use use(&handle);
             return use->is_still();
           })
      .def("save", [](Handle& handle) { return State{.state = handle.Save(), .bytes = {}}; })
      .def("restore", &Restore)
      .def("events",
           [](Handle& handle) {
             py::list events;
             for (const DatedEvent& event : handle.Events()) events.append(EventDict(event));
             return events;
           })
      .def("record",
           [](Handle& handle, const std::filesystem::path& directory, double rate, bool pictures,
              int width, int height, const std::string& camera, const std::string& title,
              const std::string& notes) {
             std::optional<sim::EyeSpec> eye;
             if (pictures) eye = {.width_px = width, .height_px = height, .camera = camera};
             handle.Record(directory, {.frames_per_second = rate, .title = title, .notes = notes},
                           eye);
           })
      .def("finish", &Handle::Finish)
      .def("render", &RenderNow);
  BindCommands(simulation);
  BindViews(simulation);
}

}  // namespace smile::python
