// SPDX-License-Identifier: Apache-2.0
#include <rakelight_internal/base/file_ending.h>
#include <rakelight_internal/base/text.h>
#include <rakelight_internal/tools/radiosity_file.h>

#include <cstdio>

#include <nlohmann/json.hpp>

#include "base/format_text.h"
#include "engines/check_settings.h"
#include "io/gltf/write/glb_writer.h"
#include "io/pictures/image_io.h"
#include "render/check_request.h"
#include "render/lit_scenes.h"
#include "render/shot.h"
#include "tools/report_json.h"
#include "world/z_up.h"

namespace rakelight {

namespace {

/// The scene with its lightmap as a picture that can be written.
Scene with_coded_map(Lightmap made) {
    std::vector<std::byte> bytes;
    io::write_image({"lightmap.png", bytes}, made.picture);
    made.scene.textures.back().image = io::image_from_bytes(
        "lightmap", made.scene.source, std::make_shared<const std::vector<std::byte>>(std::move(bytes)), "image/png");
    return std::move(made.scene);
}

/// @param scene  with the lights of the picture
Scene lightmapped(const Scene& scene, const PictureRequest& request, const LightmapOptions& options,
                  RadiosityFile& result, Context& context) {
    LightmapReport& report = result.lightmap.emplace();
    Scene out =
        with_coded_map(with_lightmap(scene, request.settings.radiosity, options, result.report, report, context));
    add_note(result.report, request.input, context.report());
    if (report.overlapping > 0)
        context.report().add(
            Remark::warning, request.input, {},
            format_text("{} of {} charts overlap themselves: they may show light that belongs elsewhere",
                        report.overlapping, report.charts));
    return out;
}

/// Prepared, with the lights of the picture.
Scene scene_to_light(PictureRequest& request, Context& context) {
    Scene loaded = load(request.input, request.load, context);
    Session session("soft");
    Shot shot = decide_single(session, std::move(loaded), request, {}, {.without_adjusting = true}, context);
    shot.settings.method = RayMethod::path;  // the same lights, not yet worked out
    return drawn_scene(*session.prepared_for(shot, context), shot, context);
}

}  // namespace

RadiosityFile radiosity_file(const PictureRequest& asked, const std::optional<LightmapOptions>& lightmap,
                             Context& context) {
    if (const std::string ending = file_ending(asked.output); ending != "glb" && ending != "gltf")
        throw Error(ErrorCode::usage, "cannot write '" + one_line(asked.output, 80) + "'", {}, "write .glb or .gltf");
    check_output_place(asked.output);
    PictureRequest request = asked;
    request.settings.method = RayMethod::radiosity;
    check_settings(request.settings);
    RadiosityFile result{.file = request.input, .output = request.output};
    context.progress("load", 0);
    Scene scene = scene_to_light(request, context);
    Scene out = lightmap ? lightmapped(scene, request, *lightmap, result, context)
                         : lit_by_radiosity(std::move(scene), request.settings.radiosity, result.report, context);
    context.throw_if_cancelled();
    context.progress("write", 0);
    if (request.view.world_up == dvec3{0, 0, 1}) out = with_y_up(std::move(out), result.output, context.report());
    io::write_glb(out, result.output, context);
    return result;
}

std::string summary(const RadiosityFile& result) {
    const RadiosityReport& r = result.report;
    char text[120];
    std::snprintf(text, sizeof text, ": %u elements, %u patches, %u shots in %.1f s", r.elements, r.patches, r.shots,
                  r.seconds);
    std::string line = result.output + text;
    if (!result.lightmap) return line;
    std::snprintf(text, sizeof text, "; lightmap of %s, %.4g pixels a meter",
                  counted(result.lightmap->charts, "chart").c_str(), result.lightmap->texels_per_meter);
    return line + text;
}

static Json lightmap_json(const LightmapReport& r) {
    return {{"charts", r.charts},
            {"overlapping_charts", r.overlapping},
            {"texels", r.texels},
            {"texels_per_meter", r.texels_per_meter},
            {"brightest", r.brightest}};
}

std::string to_json(std::span<const RadiosityRow> rows) {
    Json list = Json::array();
    for (const RadiosityRow& row : rows) {
        const RadiosityReport& r = row.result.report;
        Json json = {{"file", row.result.file}, {"output", row.result.output}};
        if (row.error)
            json["error"] = error_json(*row.error);
        else
            json.update({{"elements", r.elements},
                         {"patches", r.patches},
                         {"shots", r.shots},
                         {"rounds", r.rounds},
                         {"emitted_w", r.emitted},
                         {"absorbed_w", r.absorbed},
                         {"unshot_w", r.unshot},
                         {"left_w", r.escaped},
                         {"seconds", r.seconds}});
        if (!row.error && row.result.lightmap) json["lightmap"] = lightmap_json(*row.result.lightmap);
        json["remarks"] = remarks_json(row.remarks);
        json["remarks_left_out"] = row.remarks_left_out;
        list.push_back(std::move(json));
    }
    return document("rakelight.radiosity/1", std::move(list));
}

}  // namespace rakelight
