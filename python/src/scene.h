// SPDX-License-Identifier: Apache-2.0
// Scenes and settings as the other files of the binding take them.
#pragma once
#include <pybind11/pybind11.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include <rakelight/scene/scene.h>
#include <rakelight/world/request.h>

namespace rakelight::python {

namespace py = pybind11;

/// A scene that does not change, and where what its pictures are like stands.
struct SceneHandle {
    Scene scene;
    std::string world{};  ///< the world file that it was loaded from; empty: none
    LoadOptions load{};   ///< as it was loaded
    /// Its pictures of files have absolute paths: the working directory may be another when they are opened. Here they
    /// are as the file and the caller name them, for reports.
    std::map<ImageHandle, ImageHandle> as_named{};
};

/// Settings by the keys of [render]: [(key, [word, ...])].
using Settings = std::vector<std::pair<std::string, std::vector<std::string>>>;
std::vector<WorldValue> values_of(const Settings& settings);

/// Gives the pictures of a scene other handles, where the map has them.
void replace_images(Scene& scene, const std::map<ImageHandle, ImageHandle>& by);

/// The picture that the program would draw of a scene with these settings as options. @throws Error usage
PictureRequest request_of(const SceneHandle& handle, const Settings& settings, Context& context);

/// Parts of the module.
void define_meshes(py::module_& module);
void define_attributes(py::module_& module);
void define_scene(py::module_& module);
void define_build(py::module_& module);
void define_session(py::module_& module);
void define_reports(py::module_& module);

}  // namespace rakelight::python
