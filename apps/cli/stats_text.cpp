// SPDX-License-Identifier: Apache-2.0
#include "stats_text.h"

#include <cstdio>

namespace rakelight::cli {
namespace {

std::string rays_text(const std::string& name, const RayStats& rays) {
    const struct {
        const char* what;
        std::uint64_t count;
        bool is_rare = false;
    } rows[] = {{"primary rays", rays.primary},
                {"shadow rays", rays.shadow},
                {"reflected rays", rays.reflected},
                {"refracted rays", rays.refracted},
                {"paths per pixel", std::uint64_t(rays.samples), true},
                {"passes", rays.samples > 0 ? std::uint64_t(rays.passes) : 0, true},
                {"dropped rays", rays.dropped, true},
                {"deepest ray", std::uint64_t(rays.deepest)},
                {"triangle tests", rays.triangle_tests, true},
                {"bytes of the ray tree", rays.scene_bytes}};
    std::string text;
    char line[80];
    for (const auto& row : rows) {
        if (row.count == 0 && row.is_rare) continue;
        std::snprintf(line, sizeof line, "%-21s %12llu\n", row.what, static_cast<unsigned long long>(row.count));
        text += name + line;
    }
    if (rays.samples > 0) {
        std::snprintf(line, sizeof line, "%-21s %12.4f\n", "estimated error", rays.noise);
        text += name + line;
    }
    return text;
}

}  // namespace

std::string stats_text(const PictureResult& result) {
    const RenderStats& s = result.stats;
    const struct {
        const char* what;
        std::uint64_t count;
    } rows[] = {{"lighting evaluations", s.lighting_evaluations},
                {"vertices lit twice", s.vertices_lit_twice},
                {"objects outside", s.objects_outside},
                {"triangles in", s.triangles_in},
                {"culled by side", s.culled_back},
                {"culled outside", s.culled_outside},
                {"culled degenerate", s.culled_degenerate},
                {"clipped", s.clipped},
                {"triangles drawn", s.drawn},
                {"pixels covered", s.pixels_covered},
                {"samples covered", s.samples_covered},
                {"pixels shaded", s.pixels_shaded},
                {"depth passes", s.depth_passes},
                {"line, point pixels", s.pixels_marked},
                {"shadow maps", s.shadow_maps},
                {"shadow map bytes", s.shadow_bytes}};
    const std::string name = one_line(result.output) + ": ";
    std::string text;
    char line[80];
    const bool is_traced = s.rays.all() > 0;  // rays know nothing of clipping and depth
    for (const auto& row : rows) {
        if (is_traced && row.count == 0) continue;
        std::snprintf(line, sizeof line, "%-21s %12llu\n", row.what, static_cast<unsigned long long>(row.count));
        text += name + line;
    }
    if (!is_traced) {
        std::snprintf(line, sizeof line, "%-21s %12.3f\n", "overdraw", s.overdraw());
        text += name + line;
    }
    if (s.rays.all() > 0) text += rays_text(name, s.rays);
    for (const GpuPass& pass : s.gpu_passes) {
        std::snprintf(line, sizeof line, "GPU: %-16s %12.3f ms\n", pass.name.c_str(), 1e3 * pass.seconds);
        text += name + line;
    }
    return text;
}

}  // namespace rakelight::cli
