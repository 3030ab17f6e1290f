#pragma once

#include <pybind11/pybind11.h>

#include "user_messages.h"

// What each file of this module binds, in this order.

namespace smile::python {

void BindModel(pybind11::module_& m);
void BindSimulation(pybind11::module_& m);
void BindRecording(pybind11::module_& m);
void BindTask(pybind11::module_& m);
void BindExperiments(pybind11::module_& m);
void BindFilms(pybind11::module_& m);
void BindRobotMotion(pybind11::module_& m);
void BindEpisode(pybind11::module_& m);
void BindViewer(pybind11::module_& m);
void BindHands(pybind11::module_& m);
void BindPages(pybind11::module_& m);
void BindRobotBrain(pybind11::module_& m);

}  // namespace smile::python
