// SPDX-License-Identifier: Apache-2.0
#include "prepare/refine/displace_parts.h"

#include <rakelight/base/report.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "math/functions.h"
#include "math/linear.h"
#include "scene/placement.h"

namespace rakelight {
namespace {

/// Areas of triangles in space and on their height map.
struct Areas {
    double surface = 0;  ///< [m^2] twice
    double texture = 0;  ///< [square widths of the texture] twice
};

void add_areas(const Mesh& mesh, const DisplacedPart& part, Areas& out) {
    const Block<vec2>& uv = mesh.texcoords[part.material->height_texture.texcoord_set];
    double area = 0, uv_area = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto at = [&](std::size_t k) {
            return transform_point(part.to_world, cast<double>(mesh.positions[mesh.indices[i + k]]));
        };
        const vec2 a = uv[mesh.indices[i]], b = uv[mesh.indices[i + 1]], c = uv[mesh.indices[i + 2]];
        area += length(cross(at(1) - at(0), at(2) - at(0)));
        uv_area += std::abs(double(b.x - a.x) * double(c.y - a.y) - double(c.x - a.x) * double(b.y - a.y));
    }
    out.surface += area;
    out.texture += uv_area * part.heights->square_widths();
}

/// The texture width is one length for all meshes of a material, so that a model split into objects has no steps
/// between them.
void set_depths(const Scene& scene, const Displacement& options, std::vector<DisplacedPart>& parts) {
    std::map<const Material*, Areas> areas;
    for (const DisplacedPart& part : parts)
        if (part.material) add_areas(scene.meshes[part.instance.mesh], part, areas[part.material]);
    for (DisplacedPart& part : parts) {
        if (!part.material) continue;
        const Areas& of = areas[part.material];
        const double width = of.texture > 0 ? std::sqrt(of.surface / of.texture) : 0;  // 0: no coordinates anywhere
        part.depth = double(relief_of(*part.material, options).depth) * double(part.material->height_scale) * width;
    }
}

}  // namespace

const Material* displaced_material(const Scene& scene, const Mesh& mesh, const Displacement& options) {
    if (mesh.material == no_index) return nullptr;
    const Material& m = scene.materials[mesh.material];
    const bool is_wanted = m.bump == Bump::automatic ? options.is_on : m.bump == Bump::displacement;
    const std::uint32_t set = m.height_texture.texcoord_set;
    const bool has_map = m.height_texture && set < mesh.texcoords.size() && !mesh.texcoords[set].empty();
    return is_wanted && has_map ? &m : nullptr;
}

const Relief& relief_of(const Material& material, const Displacement& options) {
    return material.relief ? *material.relief : options.relief;
}

std::vector<DisplacedPart> collect_parts(const Scene& scene, const Displacement& options, Context& context) {
    std::vector<DisplacedPart> parts;
    HeightFields fields(scene, context);
    const std::vector<dmat4> to_world = world_matrices(scene);
    const std::vector<Instance> instances = drawn_instances(scene);
    context.memory().check(instances.size() * sizeof(DisplacedPart), "displaced placements");
    parts.reserve(instances.size());
    for (const Instance& instance : instances) {
        const Mesh& mesh = scene.meshes[instance.mesh];
        DisplacedPart part{.instance = instance, .to_world = to_world[instance.node] * translation(mesh.origin)};
        if (!inverse_affine(part.to_world, part.to_object)) continue;
        part.material = displaced_material(scene, mesh, options);
        if (part.material) part.heights = fields.of(part.material->height_texture);
        if (!part.heights) part.material = nullptr;
        parts.push_back(std::move(part));
    }
    set_depths(scene, options, parts);
    return parts;
}

void set_blur(const Mesh& mesh, DisplacedPart& part) {
    const Block<vec2>& uv = mesh.texcoords[part.material->height_texture.texcoord_set];
    const double side = std::sqrt(0.5);  // of a square, by its diagonal
    part.blur.assign(uv.size(), 1);
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = mesh.indices[i + k], b = mesh.indices[i + (k + 1) % 3];
            const float texels = float(side * part.heights->texels(uv[b] - uv[a]));
            part.blur[a] = std::max(part.blur[a], texels);
            part.blur[b] = std::max(part.blur[b], texels);
        }
    for (float& blur : part.blur) blur = float(math::log2(double(blur)));
}

void warn_of_lost_relief(const Scene& scene, const std::vector<DisplacedPart>& parts, double longest_edge,
                         Report& report) {
    struct Blur {
        double sum = 0, count = 0;
        const HeightField* heights = nullptr;
    };
    std::map<const Material*, Blur> blurs;
    for (const DisplacedPart& part : parts) {
        if (!part.material) continue;
        Blur& blur = blurs[part.material];
        blur.heights = part.heights.get();
        for (const float b : part.blur) blur.sum += double(b), blur.count += 1;
    }
    for (const Material& material : scene.materials) {
        const auto of = blurs.find(&material);
        if (of == blurs.end() || of->second.count <= 0 || of->second.sum < of->second.count) continue;
        const HeightField& heights = *of->second.heights;
        const double level = of->second.sum / of->second.count, all = heights.deviation(0);
        const double at[2] = {heights.deviation(int(level)), heights.deviation(int(level) + 1)};
        const double left = at[0] + (at[1] - at[0]) * (level - std::floor(level));
        if (all < 0.01 || left > 0.5 * all) continue;
        char text[200];
        std::snprintf(text, sizeof text,
                      "the triangles are too large for the height map: %.0f %% of its relief is left with edges up "
                      "to %.3g m; 'displacement-edge' makes them smaller",
                      100 * left / all, longest_edge);
        report.add(Remark::warning, scene.source, material.name, text, {"displacement-edge"});
    }
}

}  // namespace rakelight
