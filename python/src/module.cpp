// SPDX-License-Identifier: Apache-2.0
// The extension rakelight._core: what the package in python/rakelight is written upon. Names and defaults for people are there.
#include "errors.h"
#include "run.h"
#include "scene.h"

PYBIND11_MODULE(_core, module) {
    using namespace rakelight::python;
    translate_errors();
    (void)Py_AtExit(&cancel_all);  // refused where others took all places: a call then runs until the process ends
    define_build(module);
    define_scene(module);
    define_meshes(module);
    define_attributes(module);
    define_session(module);
    define_reports(module);
}
