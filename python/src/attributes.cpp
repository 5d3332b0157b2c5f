// SPDX-License-Identifier: Apache-2.0
// Normals and tangents of the caller's arrays, which are read where they lie.
#include <rakelight/geometry/attributes.h>

#include <pybind11/stl.h>

#include <rakelight/math/linear.h>

#include "errors.h"
#include "meshes.h"
#include "options.h"
#include "run.h"
#include "scene.h"

namespace rakelight::python {
namespace {

AttributeMesh attribute_mesh(const MeshArrays& arrays, std::uint32_t object) {
    AttributeMesh mesh;
    mesh.object = object;
    mesh.positions = span_of<vec3>(arrays.vertices);
    mesh.indices = span_of(arrays.triangles);
    if (arrays.uv) mesh.texcoords = span_of<vec2>(*arrays.uv);
    if (arrays.normals) mesh.normals = span_of<vec3>(*arrays.normals);
    if (arrays.to_world) mesh.to_world = *arrays.to_world;
    mesh.to_world = mesh.to_world * translation(arrays.origin);
    return mesh;
}

/// None: the mesh has none of them.
template <class T>
py::object taken_or_none(std::vector<T> values) {
    return values.empty() ? py::object(py::none()) : py::object(take(std::move(values)));
}

py::dict dict_of(MeshAttributes made) {
    py::dict out;
    out["normals"] = take(std::move(made.normals));
    out["tangents"] = taken_or_none(std::move(made.tangents));
    out["bitangents"] = taken_or_none(std::move(made.bitangents));
    const py::ssize_t triangles = py::ssize_t(made.indices.size() / 3);
    out["faces"] =
        made.indices.empty() ? py::object(py::none()) : py::object(take(std::move(made.indices), {triangles, 3}));
    out["split_from"] = take(std::move(made.source_vertex));
    out["degenerate_faces"] = made.degenerate_faces;
    out["isolated_vertices"] = made.isolated_vertices;
    return out;
}

/// @param objects  [meshes] meshes of one number are one object
py::tuple attributes_of(const py::list& meshes, const std::vector<std::uint32_t>& objects, const py::dict& options,
                        int threads, const py::object& progress) {
    const AttributeOptions asked = attribute_options(options);
    std::vector<MeshArrays> arrays;
    for (std::size_t i = 0; i < meshes.size(); ++i)
        arrays.push_back(mesh_arrays(py::dict(meshes[i]), "mesh " + std::to_string(i)));
    std::vector<AttributeMesh> spans;
    for (std::size_t i = 0; i < arrays.size(); ++i)
        spans.push_back(attribute_mesh(arrays[i], i < objects.size() ? objects[i] : std::uint32_t(i)));
    Runner runner(threads, 0);
    std::vector<MeshAttributes> made =
        runner.run(progress, [&] { return compute_attributes(spans, asked, runner.context()); });
    py::list out;
    for (MeshAttributes& mesh : made) out.append(dict_of(std::move(mesh)));
    return py::make_tuple(out, remarks_of(runner.context().report()));
}

}  // namespace

void define_attributes(py::module_& module) { module.def("attributes", &attributes_of); }

}  // namespace rakelight::python
