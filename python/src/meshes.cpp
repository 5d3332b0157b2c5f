// SPDX-License-Identifier: Apache-2.0
// Meshes out of scenes and into them.
#include "meshes.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>

#include <rakelight/base/error.h>
#include <rakelight/io/image_sources.h>
#include <rakelight/scene/validate.h>

#include "errors.h"
#include "scene.h"

namespace rakelight::python {
namespace {

void check_rows(const py::array& values, const std::string& name, py::ssize_t vertices) {
    if (values.shape(0) != vertices)
        throw Error(ErrorCode::usage, name + ": there are " + std::to_string(values.shape(0)) + " rows for " +
                                          std::to_string(vertices) + " vertices");
}

std::optional<py::array_t<float>> vertex_floats(const py::dict& mesh, const char* key, const std::string& place,
                                                py::ssize_t columns, py::ssize_t vertices) {
    if (!mesh.contains(key) || mesh[key].is_none()) return {};
    const std::string name = place + ": " + key;
    py::array_t<float> values = floats(mesh[key], name, columns);
    check_rows(values, name, vertices);
    return values;
}

template <class T>
Block<T> block_of(const py::array_t<float>& array) {
    const std::span<const T> values = span_of<T>(array);
    return std::vector<T>(values.begin(), values.end());
}
template <class T>
Block<T> block_of(const std::optional<py::array_t<float>>& array) {
    return array ? block_of<T>(*array) : Block<T>();
}

vec4 color_of(const py::handle& color, const std::string& place) {
    if (color.is_none()) return {1, 1, 1, 1};
    const py::array_t<float> rgb = floats(color, place + ": color", 0);
    if (rgb.size() != 3 && rgb.size() != 4)
        throw Error(ErrorCode::usage, place + ": color: 3 or 4 numbers are expected");
    const float* const c = rgb.data();
    return {c[0], c[1], c[2], rgb.size() == 4 ? c[3] : 1};
}

/// A surface of one color, neither metal nor mirror.
Material material_of(const py::dict& given, const std::string& place) {
    Material material;
    material.base_color = color_of(given["color"], place);
    if (py::cast<bool>(given["blend"])) material.alpha_mode = AlphaMode::blend;
    material.metallic_roughness.metallic = 0;
    material.metallic_roughness.roughness = 0.6f;
    material.double_sided = true;
    return material;
}

/// Other numbers of the vertices: {name: [V] or [V, n]}.
RareList<VertexArray> other_arrays(const py::dict& mesh, const std::string& place, py::ssize_t vertices) {
    RareList<VertexArray> out;
    for (const auto& [key, value] : py::cast<py::dict>(mesh["arrays"])) {
        if (value.is_none()) continue;  // of no vertices
        VertexArray array;
        array.name = py::cast<std::string>(key);
        const std::string name = place + ": arrays: " + array.name;
        const py::array given = py::array::ensure(value);
        const py::ssize_t columns = given && given.ndim() == 2 ? given.shape(1) : 0;
        if (columns > 16) throw Error(ErrorCode::usage, name + ": there are " + std::to_string(columns) + " columns");
        const py::array_t<float> values = floats(value, name, columns);
        check_rows(values, name, vertices);
        array.components = std::uint32_t(std::max<py::ssize_t>(columns, 1));
        array.values = block_of<float>(values);
        out.push_back(std::move(array));
    }
    return out;
}

Mesh mesh_of(const py::dict& given, const MeshArrays& arrays, const std::string& place) {
    Mesh mesh;
    mesh.name = arrays.name;
    mesh.origin = arrays.origin;
    mesh.positions = block_of<vec3>(arrays.vertices);
    const std::span<const std::uint32_t> indices = span_of(arrays.triangles);
    mesh.indices = std::vector<std::uint32_t>(indices.begin(), indices.end());
    mesh.normals = block_of<vec3>(arrays.normals);
    mesh.tangents = block_of<vec4>(arrays.tangents);
    mesh.colors = block_of<vec4>(arrays.colors);
    if (arrays.uv) mesh.texcoords = {block_of<vec2>(arrays.uv)};
    mesh.arrays = other_arrays(given, place, arrays.vertices.shape(0));
    return mesh;
}

const char* topology_of(const Mesh& mesh) {
    return mesh.topology == Topology::triangles ? "triangles" : mesh.topology == Topology::lines ? "lines" : "points";
}

bool has_own_surface(const py::dict& given) { return !given["color"].is_none() || !given["texture"].is_none(); }

/// A mesh with the number of a material has that one, else the one that it had.
void take_material(const py::dict& given, const std::string& place, std::size_t materials, Mesh& mesh) {
    const py::object material = given["material"];
    if (material.is_none() || has_own_surface(given)) return;
    if (!PyIndex_Check(material.ptr())) throw Error(ErrorCode::usage, place + ": material: a number is expected");
    if (material < py::int_(0) || material >= py::int_(materials))
        throw Error(ErrorCode::usage, place + ": material " + std::string(py::str(material)) + " is not one of the " +
                                          std::to_string(materials));
    mesh.material = py::cast<std::uint32_t>(material);
}

/// A mesh with a color or a texture has a material of its own.
void take_surface(const py::dict& given, const std::string& place, Mesh& mesh, Scene& scene) {
    if (!has_own_surface(given)) return;
    mesh.material = std::uint32_t(scene.materials.size());
    Material& material = scene.materials.emplace_back(material_of(given, place));
    if (given["texture"].is_none()) return;
    const std::string_view png = py::cast<std::string_view>(given["texture"]);
    const auto* const bytes = reinterpret_cast<const std::byte*>(png.data());
    material.base_color_texture.texture = std::uint32_t(scene.textures.size());
    scene.textures.push_back({.image = image_from_bytes({bytes, bytes + png.size()}, "texture of " + place)});
}

SceneHandle scene_of(const py::list& meshes) {
    Scene scene;
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        const py::dict given = meshes[i];
        const std::string place = "mesh " + std::to_string(i);
        const MeshArrays arrays = mesh_arrays(given, place);
        Mesh mesh = mesh_of(given, arrays, place);
        take_surface(given, place, mesh, scene);
        scene.meshes.push_back(std::move(mesh));
        Node& node = scene.nodes.emplace_back();
        node.name = arrays.name;
        node.meshes = {std::uint32_t(i)};
        if (arrays.to_world) node.local.matrix = *arrays.to_world;
    }
    validate(scene);
    return {std::move(scene)};
}

/// The same numbers, bit for bit.
template <class T>
bool are_same(const Block<T>& a, const Block<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

bool has_further_texcoords(const Mesh& mesh) {
    return mesh.texcoords.size() > 1 && std::any_of(mesh.texcoords.begin() + 1, mesh.texcoords.end(),
                                                    [](const Block<vec2>& set) { return !set.empty(); });
}

/// What stays of the vertices needs as many as before.
void check_vertex_count(const Mesh& mesh, std::size_t vertices, const std::string& place) {
    if (vertices == mesh.positions.size()) return;
    const bool moves = !mesh.influences.empty() || !mesh.targets.empty();
    if (!moves && !has_further_texcoords(mesh)) return;
    throw Error(ErrorCode::usage, place + ": there are " + std::to_string(vertices) + " vertices for " +
                                      (moves ? "joints and morph targets" : "further sets of texture coordinates") +
                                      " of " + std::to_string(mesh.positions.size()));
}

/// Puts other arrays into a mesh. What was of the faces stays with the same faces, what was of the surface with the
/// same surface.
void replace_arrays(Mesh& mesh, Mesh arrays, const std::string& place) {
    check_vertex_count(mesh, arrays.positions.size(), place);
    if (has_further_texcoords(mesh)) {
        arrays.texcoords.resize(mesh.texcoords.size());
        std::copy(mesh.texcoords.begin() + 1, mesh.texcoords.end(), arrays.texcoords.begin() + 1);
    }
    const bool has_faces = are_same(arrays.indices, mesh.indices);
    const bool has_places = are_same(arrays.positions, mesh.positions) && arrays.origin == mesh.origin;
    const bool has_surface = has_faces && has_places && are_same(arrays.normals, mesh.normals) &&
                             are_same(arrays.tangents, mesh.tangents) && are_same(arrays.colors, mesh.colors) &&
                             std::ranges::equal(arrays.texcoords, mesh.texcoords, are_same<vec2>);
    if (!arrays.name.empty()) mesh.name = std::move(arrays.name);
    mesh.origin = arrays.origin;
    mesh.positions = std::move(arrays.positions), mesh.indices = std::move(arrays.indices);
    mesh.normals = std::move(arrays.normals), mesh.tangents = std::move(arrays.tangents);
    mesh.colors = std::move(arrays.colors), mesh.texcoords = std::move(arrays.texcoords);
    mesh.arrays = std::move(arrays.arrays);
    mesh.bitangents = {};
    if (!has_faces)
        mesh.smoothing = {}, mesh.smoothing_kind = SmoothingKind::none, mesh.smoothing_hint = {}, mesh.polygons = {};
    if (!has_places) mesh.position_step = 0;
    if (!has_surface) mesh.shape.reset();
}

/// @param meshes  {number: mesh}
SceneHandle with_meshes(const SceneHandle& handle, const py::dict& meshes) {
    SceneHandle out = handle;
    for (const auto& [key, value] : meshes) {
        const auto number = py::cast<std::size_t>(key);
        const std::string place = "mesh " + std::to_string(number);
        if (number >= out.scene.meshes.size())
            throw Error(ErrorCode::usage, place + " is not one of the " + std::to_string(out.scene.meshes.size()));
        const py::dict given = py::reinterpret_borrow<py::dict>(value);
        const MeshArrays arrays = mesh_arrays(given, place);
        if (arrays.to_world) throw Error(ErrorCode::usage, place + ": to_world: objects place it, not the mesh");
        Mesh& mesh = out.scene.meshes[number];
        if (mesh.topology != Topology::triangles)
            throw Error(ErrorCode::usage, place + " has " + topology_of(mesh) + ", not triangles");
        replace_arrays(mesh, mesh_of(given, arrays, place), place);
        take_material(given, place, handle.scene.materials.size(), mesh);
        take_surface(given, place, mesh, out.scene);
    }
    validate(out.scene);
    return out;
}

py::dict arrays_of(const Mesh& mesh) {
    py::dict out;
    for (const VertexArray& array : mesh.arrays) {
        const py::ssize_t columns = py::ssize_t(array.components), rows = py::ssize_t(array.values.size()) / columns;
        out[text_of(array.name)] =
            view(array.values, columns == 1 ? std::vector<py::ssize_t>{rows} : std::vector<py::ssize_t>{rows, columns});
    }
    return out;
}

/// What a mesh has, without copies.
py::dict dict_of(const SceneHandle& handle, std::size_t index) {
    if (index >= handle.scene.meshes.size()) throw py::index_error("no such mesh");
    const Mesh& mesh = handle.scene.meshes[index];
    const py::ssize_t corners = mesh.topology == Topology::triangles ? 3 : mesh.topology == Topology::lines ? 2 : 1;
    py::dict out;
    out["name"] = text_of(mesh.name);
    out["topology"] = topology_of(mesh);
    out["origin"] = py::make_tuple(mesh.origin.x, mesh.origin.y, mesh.origin.z);
    out["vertices"] = view(mesh.positions);
    out["faces"] = view(mesh.indices, {py::ssize_t(mesh.indices.size()) / corners, corners});
    out["normals"] = view(mesh.normals);
    out["tangents"] = view(mesh.tangents);
    out["colors"] = view(mesh.colors);
    py::list sets;
    for (const Block<vec2>& set : mesh.texcoords) sets.append(view(set));
    out["uv_sets"] = sets;
    out["arrays"] = arrays_of(mesh);
    out["material"] = mesh.material == no_index ? py::object(py::none()) : py::int_(mesh.material);
    return out;
}

}  // namespace

dmat4 placement(py::handle from, const std::string& name) {
    const dmat4 m = matrix(from, name);
    if (m[0].w != 0 || m[1].w != 0 || m[2].w != 0 || m[3].w != 1)
        throw Error(ErrorCode::usage, name + ": the last row must be 0 0 0 1");
    return m;
}

MeshArrays mesh_arrays(const py::dict& mesh, const std::string& place) {
    MeshArrays out;
    if (mesh.contains("name")) out.name = py::cast<std::string>(mesh["name"]);
    out.vertices = floats(mesh["vertices"], place + ": vertices", 3);
    const py::ssize_t vertices = out.vertices.shape(0);
    out.triangles = triangles(mesh["faces"], place + ": faces", std::size_t(vertices));
    out.normals = vertex_floats(mesh, "normals", place, 3, vertices);
    out.tangents = vertex_floats(mesh, "tangents", place, 4, vertices);
    out.uv = vertex_floats(mesh, "uv", place, 2, vertices);
    out.colors = vertex_floats(mesh, "colors", place, 4, vertices);
    const auto [x, y, z] = py::cast<std::array<double, 3>>(mesh["origin"]);  // finite: the package looks at it
    out.origin = {x, y, z};
    if (mesh.contains("to_world") && !mesh["to_world"].is_none())
        out.to_world = placement(mesh["to_world"], place + ": to_world");
    return out;
}

void define_meshes(py::module_& module) {
    module.def("mesh", &dict_of);
    module.def("scene_of_meshes", &scene_of);
    module.def("with_meshes", &with_meshes);
}

}  // namespace rakelight::python
