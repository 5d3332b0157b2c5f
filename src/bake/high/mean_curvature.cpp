// SPDX-License-Identifier: Apache-2.0
#include "bake/high/mean_curvature.h"

#include "base/cancel_check.h"
#include "geometry/faults/place_classes.h"
#include "math/linear.h"
#include "scene/placed_normal.h"

namespace rakelight::bake {
namespace {

/// Curvature of one triangle.
struct FaceCurvature {
    double area = 0, mean = 0;
};

FaceCurvature of_face(const dvec3 (&p)[3], const dvec3 (&n)[3]) {
    const dvec3 across = cross(p[1] - p[0], p[2] - p[0]);
    const double twice = length(across);
    if (!(twice > 0)) return {};
    const dvec3 face = across / twice;  // the sum does not depend on the winding
    double divergence = 0;
    for (std::size_t k = 0; k < 3; ++k) divergence += dot(n[k], cross(face, p[(k + 2) % 3] - p[(k + 1) % 3])) / twice;
    return {twice / 2, divergence / 2};
}

}  // namespace

std::vector<std::vector<float>> mean_curvatures(std::span<const AttributeMesh> meshes, Context& context) {
    AttributeOptions options;
    options.crease_angle_rad = pi;
    options.tangents = false;
    const std::vector<MeshAttributes> made = compute_attributes(meshes, options, context);
    const geometry::PlacedMeshes placed = geometry::place_vertices(meshes, options.weld_distance, context);
    context.memory().check(placed.place.size() * 20, "curvatures");
    std::vector<double> areas(placed.place.size(), 0), sums(placed.place.size(), 0);
    CancelCheck check(context);
    for (std::size_t m = 0; m < meshes.size(); ++m) {
        const AttributeMesh& mesh = meshes[m];
        const PlacedNormals normals(mesh.to_world);
        const std::uint32_t base = placed.input.vertex_base[m];
        for (std::size_t first = 0; first < mesh.indices.size(); first += 3, check()) {
            dvec3 p[3], n[3];
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t v = mesh.indices[first + k];
                p[k] = placed.position(base + v);
                n[k] = cast<double>(normals(made[m].normals[made[m].indices.empty() ? v : made[m].indices[first + k]]));
            }
            const FaceCurvature face = of_face(p, n);
            if (!(face.area > 0)) continue;
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t place = placed.place[base + mesh.indices[first + k]];
                areas[place] += face.area, sums[place] += face.area * face.mean;
            }
        }
    }
    std::vector<std::vector<float>> out;
    for (std::size_t m = 0; m < meshes.size(); ++m) {
        std::vector<float>& values = out.emplace_back();
        for (std::size_t v = 0; v < meshes[m].positions.size(); ++v) {
            const std::uint32_t place = placed.place[placed.input.vertex_base[m] + v];
            values.push_back(areas[place] > 0 ? float(sums[place] / areas[place]) : 0.0f);
        }
    }
    return out;
}

}  // namespace rakelight::bake
