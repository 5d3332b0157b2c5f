// SPDX-License-Identifier: Apache-2.0
#include <rakelight/tools/radiosity_file.h>

#include <cstdio>

#include "engines/check_settings.h"
#include "io/glb_writer.h"
#include "render/look.h"
#include "render/picture_steps.h"
#include "tools/report_json.h"

namespace rakelight {

RadiosityFile radiosity_file(const PictureRequest& asked, Context& context) {
    if (!asked.output.ends_with(".glb") && !asked.output.ends_with(".gltf"))
        throw Error(ErrorCode::usage, "cannot write '" + one_line(asked.output, 80) + "'", {}, "write .glb or .gltf");
    check_output_place(asked.output);
    PictureRequest request = asked;
    request.settings.method = RayMethod::radiosity;
    check_settings(request.settings);
    RadiosityFile result{.file = request.input, .output = request.output};
    context.progress("load", 0);
    Scene loaded = loaded_as_asked(request, context);
    const ReadyScene ready = ready_scene(std::move(loaded), request, context, &result.report);
    context.throw_if_cancelled();
    context.progress("write", 0);
    io::write_glb(scene_of(*ready.prepared), result.output, context);
    return result;
}

std::string summary(const RadiosityFile& result) {
    const RadiosityReport& r = result.report;
    char text[120];
    std::snprintf(text, sizeof text, ": %u elements, %u patches, %u shots in %.1f s", r.elements, r.patches, r.shots,
                  r.seconds);
    return result.output + text;
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
                         {"left_w", r.left},
                         {"seconds", r.seconds}});
        json["remarks"] = remarks_json(row.remarks);
        json["remarks_left_out"] = row.remarks_left_out;
        list.push_back(std::move(json));
    }
    return document("rakelight.radiosity/1", std::move(list));
}

}  // namespace rakelight
