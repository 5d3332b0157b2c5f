// SPDX-License-Identifier: Apache-2.0
#include "tools/report_json.h"

#include <nlohmann/json.hpp>

#include <rakelight_internal/base/exit_code.h>

namespace rakelight {
namespace {

Json passes_json(const RenderStats& s) {
    Json passes = Json::array();
    for (const GpuPass& pass : s.gpu_passes) passes.push_back({{"name", pass.name}, {"ms", 1e3 * pass.seconds}});
    return passes;
}

Json rays_json(const RayStats& r) {
    return {{"primary", r.primary},
            {"shadow", r.shadow},
            {"reflected", r.reflected},
            {"refracted", r.refracted},
            {"dropped", r.dropped},
            {"deepest", r.deepest},
            {"passes", r.passes},
            {"samples", r.samples},
            {"noise", r.noise},
            {"triangle_tests", r.triangle_tests},
            {"scene_bytes", r.scene_bytes}};
}

}  // namespace

const char* name_of(ErrorCode code) {
    switch (code) {
        case ErrorCode::failed:
            return "failed";
        case ErrorCode::usage:
            return "usage";
        case ErrorCode::not_found:
            return "not_found";
        case ErrorCode::bad_file:
            return "bad_file";
        case ErrorCode::check_failed:
            return "check_failed";
    }
    return "failed";
}

Json remarks_json(const std::vector<ReportEntry>& remarks) {
    Json list = Json::array();
    for (const ReportEntry& r : remarks) {
        list.push_back({{"remark", name_of(r.remark)},
                        {"file", r.file},
                        {"place", r.place},
                        {"message", r.message},
                        {"count", r.count}});
        if (!r.settings.empty()) list.back()["settings"] = r.settings;
    }
    return list;
}

Json error_json(const Error& error) {
    return {{"code", name_of(error.code())}, {"exit_code", exit_code(error.code())},
            {"message", error.reason()},     {"setting", error.setting()},
            {"settings", error.related()},   {"file", error.file()},
            {"place", error.place()},        {"advice", error.advice()}};
}

Json stats_json(const RenderStats& s) {
    return {{"triangles_in", s.triangles_in},
            {"culled_back", s.culled_back},
            {"culled_degenerate", s.culled_degenerate},
            {"culled_outside", s.culled_outside},
            {"objects_outside", s.objects_outside},
            {"clipped", s.clipped},
            {"drawn", s.drawn},
            {"pixels_covered", s.pixels_covered},
            {"samples_covered", s.samples_covered},
            {"pixels_shaded", s.pixels_shaded},
            {"lighting_evaluations", s.lighting_evaluations},
            {"vertices_lit_twice", s.vertices_lit_twice},
            {"depth_passes", s.depth_passes},
            {"overdraw", s.overdraw()},
            {"pixels_marked", s.pixels_marked},
            {"shadow_maps", s.shadow_maps},
            {"shadow_bytes", s.shadow_bytes},
            {"rays", rays_json(s.rays)},
            {"gpu_passes", passes_json(s)}};
}

std::string json_text(const Json& whole, int spaces_a_level) {
    return whole.dump(spaces_a_level, ' ', true, Json::error_handler_t::replace) + "\n";
}

std::string document(const char* schema, Json rows) {
    return json_text({{"schema", schema}, {"rows", std::move(rows)}});
}

}  // namespace rakelight
