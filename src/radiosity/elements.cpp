// SPDX-License-Identifier: Apache-2.0
#include "radiosity/elements.h"

#include <algorithm>

#include "math/linear.h"
#include "prepare/refine/refined_mesh.h"

namespace rakelight::radiosity {
namespace {

/// Common data of all elements of a part.
struct PartColors {
    const Material& material;
    const Mesh& mesh;
    const ColorMaps& colors;
    dmat3 normal_to_world;

    PartColors(const Material& m, const Mesh& cut, const Part& part, const ColorMaps& maps)
        : material(m), mesh(cut), colors(maps) {
        const dmat3 c = cofactor(upper_left(part.to_world));
        const double sign = part.is_mirrored ? -1 : 1;
        normal_to_world = {{c[0] * sign, c[1] * sign, c[2] * sign}};
    }

    dvec3 albedo(const std::uint32_t* corner) const {
        dvec3 color = colors.mean(material.base_color_texture, mesh, corner);
        if (!mesh.colors.empty()) {
            const vec4 sum = mesh.colors[corner[0]] + mesh.colors[corner[1]] + mesh.colors[corner[2]];
            color = color * (cast<double>(sum.xyz()) / 3.0);
        }
        color = color * cast<double>(material.base_color.xyz()) * colors.diffuse_share(material, mesh, corner);
        return min(max(color, dvec3{}), dvec3{1, 1, 1});
    }

    dvec3 emission(const std::uint32_t* corner) const {
        if (material.emission == vec3{}) return {};
        return cast<double>(material.emission) * colors.mean(material.emission_texture, mesh, corner);
    }

    /// On the side of the face.
    dvec3 normal(const std::uint32_t* corner, dvec3 face) const {
        if (mesh.normals.empty()) return face;
        dvec3 sum{};
        for (std::size_t k = 0; k < 3; ++k)
            sum += normalize_or(normal_to_world * cast<double>(mesh.normals[corner[k]]), dvec3{});
        const dvec3 n = normalize_or(sum, face);
        return dot(n, face) > 0.1 ? n : face;
    }
};

Element other_side(Element e) {
    std::swap(e.corner[1], e.corner[2]);
    e.normal = -e.normal, e.face_normal = -e.face_normal;
    return e;
}

}  // namespace

Elements make_elements(const Scene& scene, const std::vector<Part>& parts,
                       const std::vector<geometry::FineMesh>& meshes, const ColorMaps& colors, Context& context) {
    Elements out;
    out.base.push_back(0);
    for (std::size_t i = 0; i < parts.size(); ++i)
        out.base.push_back(out.base.back() + parts[i].sides() * std::uint32_t(meshes[i].indices.size() / 3));
    context.memory().check(out.base.back() * sizeof(Element), "elements");
    out.list.resize(out.base.back());
    context.parallel_for(parts.size(), [&](std::size_t i) {
        const geometry::FineMesh& fine = meshes[i];
        Mesh coarse = scene.meshes[parts[i].instance.mesh];
        coarse.smoothing = {};  // by triangles of the scene
        const Mesh mesh = refined_mesh(coarse, fine);
        const PartColors of(scene.materials[parts[i].material], mesh, parts[i], colors);
        const std::size_t count = fine.indices.size() / 3;
        for (std::size_t t = 0; t < count; ++t) {
            const std::uint32_t* const corner = fine.indices.data() + 3 * t;
            Element e;
            for (std::size_t k = 0; k < 3; ++k) e.corner[k] = fine.places[corner[k]];
            if (parts[i].is_mirrored) std::swap(e.corner[1], e.corner[2]);
            e.center = (e.corner[0] + e.corner[1] + e.corner[2]) / 3.0;
            const dvec3 area = cross(e.corner[1] - e.corner[0], e.corner[2] - e.corner[0]) * 0.5;
            e.area = is_finite(area) ? length(area) : 0;
            e.face_normal = normalize_or(area, dvec3{0, 0, 1});
            e.normal = of.normal(corner, e.face_normal);
            e.albedo = of.albedo(corner), e.emission = of.emission(corner);
            out.list[out.base[i] + t] = e;
            if (parts[i].is_two_sided) out.list[out.base[i] + count + t] = other_side(e);
        }
    });
    return out;
}

}  // namespace rakelight::radiosity
