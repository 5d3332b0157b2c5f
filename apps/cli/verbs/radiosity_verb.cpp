// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <string_view>

#include <rakelight_internal/tools/radiosity_file.h>

#include "../../common/interrupt.h"
#include "../../common/picture_options.h"
#include "../run_file.h"
#include "help_texts.h"
#include "map_size.h"
#include "verbs.h"

namespace rakelight::cli {
namespace {

/// Those settings of a picture that affect the light of surfaces.
std::vector<Option> light_options() {
    std::vector<Option> out;
    for (const Option& option : apps::picture_options()) {
        const std::string_view group = option.group, name = option.name;
        if (group == "Light" || group == "Normals" || group == "Motion" || name.starts_with("radiosity-"))
            out.push_back(option);
    }
    return apps::without(std::move(out), {"light-cutoff", "animation-autoplay", "look", "fog"});
}

Command radiosity_command() {
    const Option file = {
        .name = "output",
        .group = "Output",
        .type = "FILE",
        .help = "File to write: .glb or .gltf, unlit, with vertex colors. {model} stands for the model's name",
        .is_required = true,
        .letter = 'o'};
    const Option map = {"lightmap", "Output", "N",
                        "Write the model's own triangles with the light as an emission texture of N x N pixels (or "
                        "W,H), instead of vertex colors"};
    return {"radiosity",
            "Write models with their diffuse global illumination baked in",
            radiosity_footer,
            {{"MODEL", models_help}},
            apps::joined({{file, map}, apps::input_options(), light_options(), apps::common_options()})};
}

std::optional<LightmapOptions> lightmap_options(const Given& given) {
    if (!given.has("lightmap")) return std::nullopt;
    LightmapOptions options;
    const std::vector<int> size = map_size("lightmap", given.word("lightmap"));
    options.width = size.front(), options.height = size.back();
    return options;
}

int run_radiosity(const Run& run) {
    const std::optional<LightmapOptions> lightmap = lightmap_options(run.given);
    std::vector<RadiosityRow> rows;
    int worst = 0;
    for (const InputRequest& input : picture_requests(run)) {
        RadiosityRow& row = rows.emplace_back();
        row.result = {.file = input.picture.input, .output = input.picture.output};
        if (CancelOnInterrupt::happened()) {
            row.error = Error(ErrorCode::failed, "cancelled").with_file(input.picture.input);
            continue;
        }
        const int code =
            run_input(run, input, row, [&](Context& c) { row.result = radiosity_file(input.picture, lightmap, c); });
        if (code == 0) print_note(summary(row.result), run.loudness);
        worst = std::max(worst, code);
    }
    if (run.is_json) print_data(to_json(rows));
    return worst;
}

}  // namespace

const Verb radiosity_verb = {radiosity_command, run_radiosity};

}  // namespace rakelight::cli
