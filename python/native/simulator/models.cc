// Scenes and robots, compiled.

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "bindings.h"
#include "catalog/placed_robot.h"
#include "checkpoint/checkpoint.h"
#include "experiment/robot_region.h"
#include "layout/layout_choice.h"
#include "model/eye.h"
#include "scene_xml/scene_reader.h"
#include "scene_xml/scene_writer.h"

namespace smile::python {

namespace py = pybind11;

namespace {

using ModelPointer = std::shared_ptr<const model::Model>;

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

}  // namespace

void BindModel(py::module_& m) {
  py::class_<model::Model, std::shared_ptr<model::Model>>(
      m, "Model",
      "A scene with a robot, compiled once. It never changes; threads and simulations share it.")
      .def_property_readonly(
          "name", [](const model::Model& model) { return model.scene().name; }, "of the scene")
      .def_property_readonly("object_ids", &ObjectIds,
                             "ids of the objects, in the order of the scene")
      .def_property_readonly(
          "xml", [](const model::Model& model) { return scene_xml::WriteScene(model.scene()); },
          "the scene in its written form (docs/scene-format.md)")
      .def_property_readonly(
          "unit", [](const model::Model& model) { return model.scene().meters_per_unit; },
          "length of a unit of the scene [m]")
      .def_property_readonly(
          "arm_names",
          [](const model::Model& model) {
            std::vector<std::string> names;
            if (model.robot() == nullptr) return names;
            for (const auto& arm : model.robot()->arms) names.push_back(arm.name);
            return names;
          },
          "names of the robot's arms; empty without a robot")
      .def_property_readonly(
          "has_robot", [](const model::Model& model) { return model.robot() != nullptr; },
          "False for a table without a robot")
      .def_property_readonly("camera_names", &model::CameraNames,
                             "names of the robot's and the scene's cameras")
      .def_property_readonly("hash", &checkpoint::ModelHash,
                             "64-bit hash of scene, robot and their options")
      .def(
          "laid_out",
          [](const model::Model& model, std::uint64_t seed, const std::string& level) {
            const py::gil_scoped_release release;
            return std::const_pointer_cast<model::Model>(LayOut(model, seed, level));
          },
          py::arg("seed"), py::arg("level") = "scattered",
          "Returns the model with random starting positions of its loose objects, the same for the "
          "same seed; see `smile layout --help` for the levels.");
  m.def("load", [](const std::filesystem::path& scene, const std::optional<std::string>& robot,
                   const std::vector<std::filesystem::path>& search) {
    const py::gil_scoped_release release;
    return std::const_pointer_cast<model::Model>(LoadModel(scene, robot, search));
  });
}

}  // namespace smile::python
