// SPDX-License-Identifier: Apache-2.0
#include <rakelight_internal/tools/stages.h>

#include <filesystem>
#include <new>
#include <utility>

#include <nlohmann/json.hpp>

#include <rakelight/base/report.h>
#include <rakelight_internal/tools/text_file.h>

#include "scene/charge_arrays.h"
#include "scene/placement.h"
#include "tools/open_engine.h"
#include "tools/report_json.h"
#include "tools/stages/folder.h"
#include "tools/stages/page.h"
#include "tools/stages/stage.h"

namespace rakelight {
namespace {

constexpr std::int64_t most_pixels = 1 << 24;
constexpr std::size_t most_lights = 8;

constexpr const stages::StageKind* all_stages[] = {
    &stages::displacement_stage,    &stages::model_stage,       &stages::world_stage,         &stages::camera_stage,
    &stages::frustum_stage,         &stages::central_stage,     &stages::depth_mapping_stage, &stages::clip_space_stage,
    &stages::clipped_stage,         &stages::clip_planes_stage, &stages::wrap_stage,          &stages::device_stage,
    &stages::screen_stage,          &stages::culling_stage,     &stages::coverage_stage,      &stages::depth_stage,
    &stages::depth_precision_stage, &stages::visibility_stage,  &stages::normal_stage,        &stages::relief_stage,
    &stages::shadow_stage,          &stages::frequency_stage,   &stages::lighting_stage,      &stages::blending_stage,
    &stages::samples_stage,         &stages::tone_stage,        &stages::picture_stage,
};

void check_size(const RenderSettings& settings) {
    if (std::int64_t(settings.width) * settings.height > most_pixels)
        throw Error(ErrorCode::usage, "stages are limited to 16 million pixels", {}, "give a smaller 'resolution'")
            .naming({"resolution"});
}

std::vector<stages::Stage> make_stages(PictureRequest request, Context& context) {
    const Scene loaded = load_for_engine(request, context);
    const auto engine = open_engine(charged_copy(loaded, context), request, context);
    context.progress("stages", 0);
    if (triangle_count(engine->list().scene) == 0)
        context.report().add(Remark::warning, request.input, "",
                             "the model has no triangles: its lines and points are only in the last stage");
    const raster::Inspection::Geometry open(*engine, {}, true, context), drawn(*engine, {}, false, context);
    const raster::PixelStageData pixels = raster::inspect_pixels(*engine, open, drawn, most_lights, context);
    context.progress("stages", 0.5);
    const stages::Sources sources{loaded, request, context, *engine, open, drawn, pixels};
    std::vector<stages::Stage> all;
    for (const stages::StageKind* kind : all_stages)
        if (!kind->is_there || kind->is_there(sources)) all.push_back(kind->make(sources));
    return all;
}

/// "builtin:teapot" has no folder.
std::string title_of(const PictureRequest& request) {
    return one_line(std::filesystem::path(request.input).filename().string(), 200);
}

StagesResult write_folder(const PictureRequest& request, Context& context) {
    stages::NewFolder folder(request.output);  // first: an obstacle is reported at once
    const std::vector<stages::Stage> all = make_stages(request, context);
    folder.write("index.html", stages::page(title_of(request), all, false, context));
    std::size_t done = 0;
    for (const stages::Stage& stage : all) {
        folder.write(stage.id + ".json", stages::table_json(stage));
        for (const stages::Picture& picture : stage.pictures) {
            context.throw_if_cancelled();
            folder.write(picture.name + ".png", picture.canvas.pixels());
        }
        context.progress("write", double(++done) / double(all.size()));
    }
    folder.finish();
    return {request.input, request.output, folder.names()};
}

StagesResult write_page(const PictureRequest& request, Context& context) {
    check_text_output(request.output);
    save_text(request.output, stages::page(title_of(request), make_stages(request, context), true, context));
    return {request.input, request.output, {}};
}

}  // namespace

StagesResult write_stages(const PictureRequest& request, Context& context, StagesForm form) {
    try {
        check_size(request.settings);
        return form == StagesForm::folder ? write_folder(request, context) : write_page(request, context);
    } catch (const std::bad_alloc&) {
        throw Error(ErrorCode::failed, "out of memory").with_file(request.input);
    } catch (const Error& error) {
        throw error.with_file(request.input);
    }
}

std::string to_json(std::span<const StagesRow> rows) {
    Json list = Json::array();
    for (const StagesRow& row : rows) {
        Json json = {{"file", row.result.file}, {"folder", row.result.folder}};  // of a page its name
        if (row.error)
            json["error"] = error_json(*row.error);
        else if (row.result.files.empty())
            json["page"] = row.result.folder;
        else
            json["files"] = row.result.files;
        json["remarks"] = remarks_json(row.remarks);
        json["remarks_left_out"] = row.remarks_left_out;
        list.push_back(std::move(json));
    }
    return document("rakelight.stages/1", std::move(list));
}

}  // namespace rakelight
