// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "io/import/scene_from_import.h"
#include "io/stray_vertices.h"
#include "math/color.h"
#include "math/linear.h"

namespace rakelight::io {
namespace {

using import_stream::Influence, import_stream::Part;

/// Unit to within rounding stays as it is; zero and non-finite ones are left for prepare, which replaces and reports them.
std::vector<vec3> unit_normals(std::vector<vec3>&& normals) {
    for (vec3& n : normals) {
        const float squared = dot(n, n);
        if (!(std::fabs(squared - 1) <= 1e-4f)) n = normalize_or(n, n);
    }
    return std::move(normals);
}

/// All tangents, or none when one of them is no direction: a broken set is recomputed.
std::vector<vec4> unit_tangents(std::vector<vec4>&& tangents) {
    for (vec4& t : tangents) {
        const vec3 unit = normalize_or(t.xyz(), vec3{});
        if (dot(unit, unit) == 0 || !(t.w == 1 || t.w == -1)) return {};
        t = {unit.x, unit.y, unit.z, t.w};
    }
    return std::move(tangents);
}

std::vector<vec4> linear_colors(std::vector<vec4>&& colors) {
    for (vec4& c : colors) {
        const vec3 rgb = linear_from_srgb(c.xyz());
        c = {rgb.x, rgb.y, rgb.z, c.w >= 0 && c.w <= 1 ? c.w : 1.0f};
    }
    return std::move(colors);
}

std::vector<vec2> v_down(std::vector<vec2>&& set) {
    for (vec2& uv : set) uv.y = 1 - uv.y;
    return std::move(set);
}

/// Joints 4 * set to 4 * set + 3 of each vertex; empty where none has as many.
std::vector<JointInfluence> influences_of(const Part& part, std::size_t set) {
    const auto has_more = [&](const Influence& f) { return f.weights[4 * set] > 0; };
    std::vector<JointInfluence> result;
    if (set > 0 && std::ranges::none_of(part.influences, has_more)) return result;
    result.reserve(part.influences.size());
    for (const Influence& f : part.influences) {
        JointInfluence& out = result.emplace_back();
        for (std::size_t k = 0; k < 4; ++k)
            out.joints[k] = f.joints[4 * set + k], out.weights[k] = f.weights[4 * set + k];
    }
    return result;
}

}  // namespace

void detail::add_meshes(import_stream::Import& import, const std::string& path, Scene& scene, Context& context) {
    const auto block = [&](auto&& array) {  // takes its part of what was charged for the import
        MemoryCharge charge = import.charge.split(array.size() * sizeof(array[0]));
        return Block(std::move(array), std::move(charge));
    };
    for (Part& part : import.parts) {
        Mesh& mesh = scene.meshes.emplace_back();
        mesh.name = std::move(part.name);
        mesh.topology = Topology(part.topology);
        mesh.material = part.surface;
        if (has_stray_vertices(part.positions))
            context.report().add(Remark::warning, path, "mesh '" + one_line(mesh.name, 60) + "'", stray_vertices_text);
        const bool had_tangents = !part.tangents.empty();
        mesh.influences = block(influences_of(part, 0));
        mesh.more_influences = block(influences_of(part, 1));
        mesh.positions = block(std::move(part.positions));
        mesh.indices = block(std::move(part.indices));
        mesh.normals = block(unit_normals(std::move(part.normals)));
        mesh.tangents = block(unit_tangents(std::move(part.tangents)));
        if (had_tangents && mesh.tangents.empty())
            context.report().add(Remark::dropped, path, "mesh '" + one_line(mesh.name, 60) + "'",
                                 "the file's tangents contain zeros and are recomputed");
        mesh.smoothing = block(std::move(part.smoothing));
        if (!mesh.smoothing.empty()) mesh.smoothing_kind = SmoothingKind::masks;
        mesh.smoothing_hint = block(std::move(part.smoothing_hint));
        mesh.polygons = block(std::move(part.polygons));
        for (auto& set : part.texcoords) mesh.texcoords.push_back(block(v_down(std::move(set))));
        mesh.colors = block(linear_colors(std::move(part.colors)));
        std::vector<MorphTarget> targets;
        for (auto& s : part.shapes)
            targets.push_back({std::move(s.name), block(std::move(s.positions)), block(std::move(s.normals)), {}});
        mesh.targets = block(std::move(targets));
    }
    import.parts.clear();
}

}  // namespace rakelight::io
