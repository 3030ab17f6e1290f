// smile, the compiled half: scenes, simulations and pictures as values of Python. A thin door;
// names and docstrings for people are in python/smile/.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <functional>

#include "arrays.h"
#include "base/diagnostic.h"
#include "base/files.h"
#include "camera/renderer.h"
#include "catalog/placed_robot.h"
#include "checkpoint/checkpoint.h"
#include "experiment/robot_region.h"
#include "experiment/world_description.h"
#include "handle.h"
#include "layout/layout_choice.h"
#include "picture/viewpoint.h"
#include "replay/replay.h"
#include "scene_xml/scene_reader.h"
#include "scene_xml/scene_writer.h"
#include "sim/event_words.h"

namespace smile::python {
namespace {

using ModelPointer = std::shared_ptr<const model::Model>;

/// Raises SceneError with the attribute `diagnostics`: a list of (file, line, element, message).
void RaiseInputError(const py::object& type, const InputError& error) {
  py::list diagnostics;
  for (const Diagnostic& one : error.diagnostics()) {
    diagnostics.append(py::make_tuple(one.file, one.line, one.element, one.message));
  }
  const py::object value = type(error.what());
  value.attr("diagnostics") = diagnostics;
  PyErr_SetObject(type.ptr(), value.ptr());
}

/// Text of JSON that the Python half parses.
std::string TextOf(const Json& json) { return ToText(json); }

// --- Models ---

ModelPointer LoadModel(const std::filesystem::path& scene, const std::optional<std::string>& robot,
                       const std::vector<std::filesystem::path>& search) {
  std::optional<model::RobotPlacement> placement;
  if (robot) placement = catalog::PlaceRobot(*robot, {.package_roots = search}).placement;
  return std::make_shared<const model::Model>(scene_xml::LoadScene(scene, {.search_roots = search}),
                                              std::move(placement));
}

ModelPointer LayOut(const model::Model& model, std::uint64_t seed, const std::string& level) {
  const auto parsed = layout::ParseLayoutLevel(level);
  if (!parsed) {
    std::string words;
    for (std::string_view word : layout::kLayoutLevelWords) {
      words += (words.empty() ? "" : ", ") + std::string(word);
    }
    throw std::invalid_argument("level is '" + level + "', expected one of " + words);
  }
  scene::SceneSpec scene = layout::LaidOut(
      model.scene(), {.seed = seed, .level = *parsed}, [&](double height) -> layout::LayoutRegion {
        if (!model.robot_placement()) return {};
        return experiment::RegionOf(*model.robot_placement(), height);
      });
  return std::make_shared<const model::Model>(model, std::move(scene));
}

std::vector<std::string> ObjectIds(const model::Model& model) {
  std::vector<std::string> ids;
  for (model::ObjectIndex i : model.objects()) ids.push_back(model.id(i));
  return ids;
}

void BindModel(py::module_& m) {
  py::class_<model::Model, std::shared_ptr<model::Model>>(m, "Model")
      .def_property_readonly("name", [](const model::Model& model) { return model.scene().name; })
      .def_property_readonly("object_ids", &ObjectIds)
      .def_property_readonly(
          "xml", [](const model::Model& model) { return scene_xml::WriteScene(model.scene()); })
      .def_property_readonly(
          "unit", [](const model::Model& model) { return model.scene().meters_per_unit; })
      .def_property_readonly("arm_names",
                             [](const model::Model& model) {
                               std::vector<std::string> names;
                               if (model.robot() == nullptr) return names;
                               for (const auto& arm : model.robot()->arms)
                                 names.push_back(arm.name);
                               return names;
                             })
      .def_property_readonly("has_robot",
                             [](const model::Model& model) { return model.robot() != nullptr; })
      .def_property_readonly("camera_names", &model::CameraNames)
      .def_property_readonly("hash", &checkpoint::ModelHash)
      .def("laid_out", [](const model::Model& model, std::uint64_t seed, const std::string& level) {
        const py::gil_scoped_release release;
        return std::const_pointer_cast<model::Model>(LayOut(model, seed, level));
      });
  m.def("load", [](const std::filesystem::path& scene, const std::optional<std::string>& robot,
                   const std::vector<std::filesystem::path>& search) {
    const py::gil_scoped_release release;
    return std::const_pointer_cast<model::Model>(LoadModel(scene, robot, search));
  });
}

// --- States ---

/// A saved state, or the bytes of one that belongs to a model not yet known.
struct State {
  std::optional<sim::SimulationState> state;
  std::vector<std::byte> bytes;
};

py::bytes BytesOf(const State& state) {
  const std::vector<std::byte> bytes =
      state.state ? checkpoint::Serialize(*state.state) : state.bytes;
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

void BindState(py::module_& m) {
  py::class_<State>(m, "State", "A saved state of a simulation; bytes(state) writes it.")
      .def(py::init([](const py::bytes& bytes) {
        const std::string_view view = bytes;
        const auto span = std::as_bytes(std::span(view.data(), view.size()));
        return State{.state = std::nullopt, .bytes = {span.begin(), span.end()}};
      }))
      .def("__bytes__", &BytesOf)
      .def(py::pickle([](const State& state) { return BytesOf(state); },
                      [](const py::bytes& bytes) {
                        const std::string_view view = bytes;
                        const auto span = std::as_bytes(std::span(view.data(), view.size()));
                        return State{.state = std::nullopt, .bytes = {span.begin(), span.end()}};
                      }));
}

void Restore(Handle& handle, const State& state) {
  if (state.state) {
    handle.Restore(*state.state);
    return;
  }
  const ModelPointer start = [&] {
    const Handle::Use use(&handle);
    return use->start_model();
  }();
  handle.Restore(checkpoint::ParseState(state.bytes, start));
}

// --- Simulations ---

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

/// Advances until a condition holds.
/// @returns false if `max_ticks` passed before.
bool RunUntil(sim::Simulation& simulation, const std::string& condition, std::uint64_t max_ticks) {
  // As in scripts: bodies at a turning point are slow for a tick, so rest must last.
  constexpr int kRestTicks = 15;
  int rest = 0;
  const auto holds = [&]() -> bool {
    if (condition == "arrived") {
      return simulation.demonstrator().has_arrived() && !simulation.is_robot_following();
    }
    rest = simulation.is_still() ? rest + 1 : 0;
    return rest >= kRestTicks;
  };
  for (std::uint64_t i = 0; i < max_ticks; ++i) {
    simulation.Tick();
    if (holds()) return true;
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
    return function(*use->robot(), ArmIndex(*use, name));
  };
}

py::dict EventDict(const DatedEvent& dated) {
  py::dict event;
  event["tick"] = dated.tick;
  event["kind"] = std::string(ToString(dated.event.kind));
  if (dated.event.hand) event["hand"] = std::string(ToString(*dated.event.hand));
  for (const auto& [name, text] :
       {std::pair("arm", &dated.event.arm), std::pair("object", &dated.event.object),
        std::pair("part", &dated.event.part), std::pair("control", &dated.event.control),
        std::pair("state", &dated.event.state), std::pair("by", &dated.event.by),
        std::pair("reason", &dated.event.reason)}) {
    if (!text->empty()) event[name] = *text;
  }
  if (!dated.event.objects.empty()) event["objects"] = dated.event.objects;
  return event;
}

/// Applies a command in its written form, but with SI units and radians.
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
             if (speed && !(*speed > 0 && std::isfinite(*speed))) {
               throw std::invalid_argument("speed is " + std::to_string(*speed) +
                                           " m/s, expected a finite number above 0");
             }
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
             return TextOf(experiment::DescribeControls(*use));
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

/// One renderer for each thread: an OpenGL context belongs to the thread that made it.
camera::Renderer& RendererOfThread() {
  thread_local camera::Renderer renderer;
  return renderer;
}

/// A rendered picture: (rgb or None, depth or None, id or None, K, X_WC).
py::tuple Render(Handle& handle, const std::string& camera, int width, int height, bool rgb,
                 bool depth, bool id) {
  const Handle::Use use(&handle);
  const sim::EyeSpec spec{.width_px = width, .height_px = height, .camera = camera};
  Image image;
  CameraView view;
  {
    const py::gil_scoped_release release;
    camera::RenderOptions options{.color = rgb, .depth = depth, .ids = id};
    const std::vector<std::string> cameras = model::CameraNames(use->model());
    if (std::ranges::find(cameras, camera) != cameras.end()) {
      view = sim::EyeView(*use, spec);
      options.excluded_frames =
          model::FramesHiddenFromEye(use->model(), use->is_robot_shown(), camera);
    } else {
      view = picture::FindView(camera, use->scene(), spec, cameras, use->robot() != nullptr);
      options.style = camera::RenderStyle::kPresentation;
    }
    RendererOfThread().Render(use->model().visual_model(), use->visual_state(), view, options,
                              &image);
  }
  const auto h = static_cast<py::ssize_t>(height), w = static_cast<py::ssize_t>(width);
  const auto channel = [](bool is_wanted, auto& values, std::vector<py::ssize_t> shape) {
    return is_wanted ? py::object(OwnedArray(std::move(values), std::move(shape)))
                     : py::object(py::none());
  };
  const CameraIntrinsics& k = view.intrinsics;
  Array matrix({py::ssize_t{3}, py::ssize_t{3}});
  const double entries[9] = {k.fx, 0, k.cx, 0, k.fy, k.cy, 0, 0, 1};
  std::copy(entries, entries + 9, matrix.mutable_data());
  return py::make_tuple(channel(rgb, image.color, {h, w, 3}), channel(depth, image.depth, {h, w}),
                        channel(id, image.ids, {h, w}), matrix, MatrixOf(view.X_WC));
}

void BindSimulation(py::module_& m) {
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
             for (std::uint64_t i = 0; i < ticks; ++i) use->Tick();
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
      .def("can_undo",
           [](Handle& handle) {
             const Handle::Use use(&handle);
             return use->history().can_undo();
           })
      .def("save",
           [](Handle& handle) {
             const Handle::Use use(&handle);
             return State{.state = use->Save(), .bytes = {}};
           })
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
      .def("render", &Render);
  BindCommands(simulation);
  BindViews(simulation);
}

}  // namespace
}  // namespace smile::python

PYBIND11_MODULE(smile_simulator_native, m) {
  namespace py = pybind11;
  // The type outlives the module: exceptions may be translated until the interpreter ends.
  static const py::object* scene_error = nullptr;
  const py::object errors = py::module_::import("smile.errors");
  scene_error = new py::object(errors.attr("SceneError"));
  py::register_exception_translator([](std::exception_ptr pointer) {
    try {
      if (pointer) std::rethrow_exception(pointer);
    } catch (const smile::InputError& error) {
      smile::python::RaiseInputError(*scene_error, error);
    }
  });
  smile::python::BindModel(m);
  smile::python::BindState(m);
  smile::python::BindSimulation(m);
}
