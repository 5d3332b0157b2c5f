// SPDX-License-Identifier: Apache-2.0
#include "prepare/normals/tangent_report.h"

#include <cstdio>
#include <string>

#include "geometry/input/orthogonality.h"
#include "prepare/variants.h"
#include "scene/validate_parts.h"

namespace rakelight {
namespace {

geometry::OrthogonalityLoss measure(const Mesh& mesh) {
    geometry::OrthogonalityLoss loss;
    for (std::size_t v = 0; v < mesh.tangents.size(); ++v) {
        const dvec3 normal = normalize_or(cast<double>(mesh.normals[v]), dvec3{});
        const dvec3 tangent = normalize_or(cast<double>(mesh.tangents[v].xyz()), dvec3{});
        if (dot(normal, normal) > 0 && dot(tangent, tangent) > 0) loss.add(geometry::skew_deg(normal, tangent));
    }
    return loss;
}

}  // namespace

void report_orthogonality(const Scene& scene, std::uint32_t mesh, double largest_deg, double mean_deg, Report& report) {
    char text[128];
    std::snprintf(text, sizeof text, "tangents were at most %.2f degrees (mean %.2f) from perpendicular to the normals",
                  largest_deg, mean_deg);
    report.add(Remark::note, scene.source, Place{"mesh", mesh, scene.meshes[mesh].name}.text(), text);
}

void report_inverted(const Scene& scene, const InvertedMaps& inverted, TangentMode mode, Report& report) {
    if (inverted.triangles == 0) return;
    const Mesh& first = scene.meshes[inverted.first_mesh];
    report.add(
        Remark::warning, scene.source, Place{"mesh", inverted.first_mesh, first.name}.text(),
        "the published tangents run against the texture coordinates on " + std::to_string(inverted.triangles) + " of " +
            std::to_string(inverted.of) + " triangles, where bumps look like dents; 'tangents' " +
            (mode == TangentMode::published ? "published-no-handedness leaves out the handedness step, 'tangents' "
                                            : "") +
            "averaged keeps mirrored charts apart",
        {"tangents"});
}

void report_kept_tangents(const Scene& scene, Report& report) {
    std::vector<bool> seen(scene.meshes.size(), false);
    for (const Instance& instance : drawn_instances(scene)) {
        const Mesh& mesh = scene.meshes[instance.mesh];
        if (seen[instance.mesh] || mesh.tangents.empty() || mesh.normals.empty()) continue;
        seen[instance.mesh] = true;
        MeshAttributes told;
        measure(mesh).tell(told);
        report_orthogonality(scene, instance.mesh, told.orthogonality_loss_max_deg, told.orthogonality_loss_mean_deg,
                             report);
    }
}

}  // namespace rakelight
