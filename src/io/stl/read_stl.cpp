// SPDX-License-Identifier: Apache-2.0
// STL -> scene. The size of a binary file is that of the facets which it declares, whatever its header begins with.
#include "io/stl/read_stl.h"

#include <rakelight/base/report.h>

#include <algorithm>
#include <cmath>

#include "io/cloud_material.h"
#include "io/files/plain_text.h"
#include "io/model_readers.h"
#include "io/position_origin.h"
#include "io/stl/binary_stl.h"
#include "io/stl/text_stl.h"
#include "io/stray_vertices.h"
#include "math/linear.h"

namespace rakelight::io::stl {
namespace {

template <class T, class Of>
Block<T> block_of(const std::vector<Corner>& vertices, Context& context, const Of& of) {
    MemoryCharge charge(context.memory(), std::uint64_t(vertices.size()) * sizeof(T), "the vertices of an STL file");
    std::vector<T> array;
    array.reserve(vertices.size());
    for (const Corner& v : vertices) array.push_back(of(v));
    return {std::move(array), std::move(charge)};
}

Mesh mesh_of(JoinedCorners& corners, Context& context) {
    Mesh mesh;
    mesh.material = 0;
    mesh.positions = block_of<vec3>(corners.vertices, context, [](const Corner& v) { return v.position(); });
    MemoryCharge charge = corners.charge.split(corners.indices.size() * sizeof(std::uint32_t));
    mesh.indices = {std::move(corners.indices), std::move(charge)};
    return mesh;
}

/// A child of the root.
void add_solid(Scene& scene, const std::string& name, std::optional<Mesh> mesh) {
    Node& node = scene.nodes.emplace_back();
    node.name = name;
    node.parent = 0;
    if (!mesh) return;
    mesh->name = name;
    node.meshes.push_back(std::uint32_t(scene.meshes.size()));
    scene.meshes.push_back(std::move(*mesh));
}

Material material_of(std::optional<vec4> color) {
    Material m = plain_material(true);
    m.name = "DefaultMaterial";
    if (color) m.base_color = {color->x, color->y, color->z, 1}, m.classical.ambient = color->xyz();
    return m;
}

Scene scene_of(const BinaryStl& binary, Context& context) {
    if (binary.facet_count() == 0) throw Error(ErrorCode::bad_file, "nothing to draw: the file holds no triangle");
    JoinedCorners corners = join_corners(
        3 * std::uint64_t(binary.facet_count()),
        [&binary](std::size_t first, std::span<Corner> out) { binary.read_corners(first, out); }, context);
    Mesh mesh = mesh_of(corners, context);
    const bool has_colors = std::ranges::any_of(corners.vertices, [](const Corner& v) { return v.color != 0; });
    if (has_colors)
        mesh.colors =
            block_of<vec4>(corners.vertices, context, [&binary](const Corner& v) { return binary.color(v.color); });
    Scene scene;
    scene.nodes.emplace_back().name = "<STL_BINARY>";
    add_solid(scene, {}, std::move(mesh));
    scene.materials.push_back(material_of(has_colors ? std::nullopt : binary.object_color()));
    return scene;
}

/// One for all solids, so that their borders match.
dvec3 origin_of(const std::vector<dvec3>& corners) {
    dvec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
    double error = 0;
    for (const dvec3& p : corners)
        for (std::size_t k = 0; k < 3; ++k) {
            if (std::isnan(p[k])) continue;
            low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
            error = std::max(error, std::fabs(double(float(p[k])) - p[k]));
        }
    return position_origin(low, high, error);
}

Scene scene_of(TextStl text, const std::string& path, Context& context) {
    const dvec3 origin = origin_of(text.corners);
    Scene scene;
    scene.nodes.emplace_back();
    std::uint64_t empty = 0;
    for (std::size_t s = 0; s < text.solids.size(); ++s) {
        const auto& [name, first] = text.solids[s];
        if (name.empty()) scene.nodes[0].name = "<STL_ASCII>";
        const std::size_t end = s + 1 < text.solids.size() ? text.solids[s + 1].first_corner : text.corners.size();
        if (end == first) {
            ++empty;
            add_solid(scene, name, {});
            continue;
        }
        JoinedCorners corners = join_corners(
            end - first,
            [&](std::size_t at, std::span<Corner> out) {
                for (Corner& c : out) c = Corner(cast<float>(text.corners[first + at++] - origin));
            },
            context);
        Mesh mesh = mesh_of(corners, context);
        mesh.origin = origin;
        add_solid(scene, name, std::move(mesh));
    }
    if (empty > 0)
        context.report().add(Remark::dropped, path, {}, std::to_string(empty) + " solids without facets are left out");
    scene.materials.push_back(material_of({}));
    text.charge.shrink(text.corners.capacity() * sizeof(dvec3));
    scene.charges.push_back(share(std::move(text.charge)));
    return scene;
}

void remark_on_positions(const Scene& scene, const std::string& path, Report& report) {
    std::uint64_t bad = 0;
    for (const Mesh& mesh : scene.meshes) {
        if (has_stray_vertices(mesh.positions))
            report.add(Remark::warning, path, "mesh '" + one_line(mesh.name, 60) + "'", stray_vertices_text);
        bad += std::uint64_t(std::ranges::count_if(mesh.positions, [](const vec3& p) { return !is_finite(p); }));
    }
    if (bad > 0) report.add(Remark::warning, path, {}, std::to_string(bad) + " vertices are not finite numbers");
}

Scene scene_of(std::string_view file, const std::string& path, Context& context) {
    if (const auto binary = BinaryStl::of(file)) {
        if (file.starts_with("solid"))
            context.report().add(Remark::warning, path, {},
                                 "it begins with 'solid' like a text STL, but it is binary and was read as such");
        return scene_of(*binary, context);
    }
    const PlainText text(file, path, context);
    if (!begins_as_text(text.view())) refuse_binary(file);
    return scene_of(read_text_stl(text.view(), path, context), path, context);
}

}  // namespace

Scene read_stl_bytes(std::string_view file, const std::string& path, Context& context) {
    Scene scene = scene_of(file, path, context);
    scene.source = path;
    remark_on_positions(scene, path, context.report());
    return scene;
}

}  // namespace rakelight::io::stl

namespace rakelight::io {

namespace {

Scene read_bytes(const std::string& path, Bytes bytes, const ReadOptions&, Context& context) {
    const std::string_view file(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    return stl::read_stl_bytes(file, path, context);
}

}  // namespace

constinit const ModelReader stl_reader = {.read_bytes = read_bytes};

}  // namespace rakelight::io
