// SPDX-License-Identifier: Apache-2.0
// Scenes: loaded, made of arrays, smoothed, saved, and what is in them.
#include "scene.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include <rakelight/math/linear.h>
#include <rakelight/prepare/prepare.h>
#include <rakelight/render/render.h>
#include <rakelight/scene/scene_queries.h>
#include <rakelight/world/load.h>

#include "arrays.h"
#include "errors.h"
#include "options.h"
#include "run.h"

namespace rakelight::python {
namespace {

py::tuple with_remarks(Scene scene, Runner& runner) {
    return py::make_tuple(SceneHandle{std::move(scene)}, remarks_of(runner.context().report()));
}

std::string absolute(const std::string& path) {
    std::error_code error;
    const std::filesystem::path result = std::filesystem::absolute(path, error);
    return error ? path : result.string();
}

/// Pictures are opened when they are needed: the working directory may be another then.
void make_paths_absolute(SceneHandle& handle) {
    std::map<ImageHandle, ImageHandle> known;  // what textures share stays shared
    const auto add = [&](const ImageHandle& image) {
        if (!image || image->path.empty() || known.contains(image)) return;
        EncodedImage copy = *image;
        copy.path = absolute(image->path);
        if (copy.path == image->path) return;
        const ImageHandle made = std::make_shared<const EncodedImage>(std::move(copy));
        known[image] = made, handle.as_named[made] = image;
    };
    for (const Texture& texture : handle.scene.textures) add(texture.image);
    if (handle.scene.environment) add(handle.scene.environment->image);
    replace_images(handle.scene, known);
}

/// What was made of a scene, with what is known of where it comes from.
py::tuple derived(const SceneHandle& from, Scene scene, Runner& runner) {
    return py::make_tuple(SceneHandle{std::move(scene), from.world, from.load, from.as_named},
                          remarks_of(runner.context().report()));
}

py::tuple load_file(const std::string& path, bool allow_outside, bool allow_shaders, int threads,
                    std::uint64_t max_memory, const py::object& progress) {
    Runner runner(threads, max_memory);
    LoadOptions options;
    options.allow_outside = allow_outside;
    options.allow_shaders = allow_shaders;
    SceneHandle handle{runner.run(progress, [&] { return load(path, options, runner.context()); }),
                       is_world_file(path) ? absolute(path) : std::string(), options};
    make_paths_absolute(handle);
    return py::make_tuple(std::move(handle), remarks_of(runner.context().report()));
}

py::tuple load_bytes(const py::bytes& bytes, const std::string& name, int threads, std::uint64_t max_memory,
                     const py::object& progress) {
    const std::string_view view = bytes;
    const auto* const data = reinterpret_cast<const std::byte*>(view.data());
    std::vector<std::byte> copy(data, data + view.size());
    Runner runner(threads, max_memory);
    return with_remarks(runner.run(progress, [&] { return load(std::move(copy), name, {}, runner.context()); }),
                        runner);
}

py::tuple smoothed(const SceneHandle& handle, const py::dict& options, int threads, const py::object& progress) {
    const AttributeOptions attributes = attribute_options(options);
    Runner runner(threads, 0);
    Scene scene = runner.run(progress, [&] { return smooth(handle.scene, attributes, runner.context()); });
    return derived(handle, std::move(scene), runner);
}

/// Some mesh has normals that can be joined.
bool has_normals(const Scene& scene) {
    return std::ranges::any_of(scene.meshes, [](const Mesh& mesh) { return !mesh.normals.empty(); });
}

/// @param options  only the creases are read
py::tuple repaired(const SceneHandle& handle, const py::dict& options, double border_distance, int threads,
                   const py::object& progress) {
    const AttributeOptions given = attribute_options(options);
    const double crease_angle_rad = given.crease_angle_rad;
    Runner runner(threads, 0);
    Scene scene = runner.run(progress, [&] {
        Context& context = runner.context();
        Scene joined =
            has_normals(handle.scene)
                ? repair_seams(handle.scene, {.crease_angle_rad = crease_angle_rad, .creases = given.creases}, context)
                : smooth(handle.scene, {.crease_angle_rad = crease_angle_rad, .creases = given.creases}, context);
        if (!(border_distance > 0)) return joined;
        MatchOptions match;
        match.distance = border_distance, match.crease_angle_rad = crease_angle_rad, match.keep_flat = true;
        return repair_borders(joined, match, context);
    });
    return derived(handle, std::move(scene), runner);
}

py::list saved(const SceneHandle& handle, const std::string& path, int threads, const py::object& progress) {
    Runner runner(threads, 0);
    runner.run(progress, [&] { save(handle.scene, path, runner.context()); });
    return remarks_of(runner.context().report());
}

std::vector<dmat4> matrices_of(const Scene& scene) {
    std::vector<dmat4> world(scene.nodes.size());
    for (std::size_t i = 0; i < world.size(); ++i) {
        const Transform& local = scene.pose ? scene.pose->local[i] : scene.nodes[i].local;
        world[i] = local.matrix ? *local.matrix : compose(local.translation, local.rotation, local.scale);
        if (scene.nodes[i].parent != no_index) world[i] = world[scene.nodes[i].parent] * world[i];
    }
    return world;
}

/// [(name, node, [mesh, ...], matrix)] of nodes that have meshes.
py::list objects_of(const SceneHandle& handle) {
    py::list out;
    const std::vector<dmat4> world = matrices_of(handle.scene);
    for (std::size_t i = 0; i < world.size(); ++i) {
        const Node& node = handle.scene.nodes[i];
        if (!node.meshes.empty())
            out.append(py::make_tuple(text_of(node.name), i, node.meshes, array_of_matrix(world[i])));
    }
    return out;
}

template <class T>
py::list names_of(const std::vector<T>& things) {
    py::list out;
    for (const T& thing : things) out.append(text_of(thing.name));
    return out;
}

/// (low, high), or None where nothing is drawn.
py::object bounds_of(const SceneHandle& handle) {
    const Bounds box = bounds(handle.scene);
    if (box.empty()) return py::none();
    return py::make_tuple(take(std::vector<double>{box.low.x, box.low.y, box.low.z}),
                          take(std::vector<double>{box.high.x, box.high.y, box.high.z}));
}

}  // namespace

void replace_images(Scene& scene, const std::map<ImageHandle, ImageHandle>& by) {
    const auto replace = [&by](ImageHandle& image) {
        if (const auto found = by.find(image); found != by.end()) image = found->second;
    };
    for (Texture& texture : scene.textures) replace(texture.image);
    if (scene.environment) replace(scene.environment->image);
}

void define_scene(py::module_& module) {
    py::class_<SceneHandle>(module, "Scene")
        .def_property_readonly("source", [](const SceneHandle& h) { return text_of(h.scene.source); })
        .def_property_readonly("nodes", [](const SceneHandle& h) { return names_of(h.scene.nodes); })
        .def_property_readonly("materials", [](const SceneHandle& h) { return names_of(h.scene.materials); })
        .def_property_readonly("cameras", [](const SceneHandle& h) { return names_of(h.scene.cameras); })
        .def_property_readonly("lights", [](const SceneHandle& h) { return names_of(h.scene.lights); })
        .def_property_readonly("animations", [](const SceneHandle& h) { return names_of(h.scene.animations); })
        .def_property_readonly("mesh_count", [](const SceneHandle& h) { return h.scene.meshes.size(); })
        .def("objects", &objects_of)
        .def("bounds", &bounds_of);
    module.def("load", &load_file);
    module.def("load_bytes", &load_bytes);
    module.def("smooth", &smoothed);
    module.def("repair", &repaired);
    module.def("save", &saved);
}

}  // namespace rakelight::python
