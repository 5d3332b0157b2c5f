// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <rakelight/tools/convert_file.h>
#include <rakelight/tools/rows.h>

#include "../../common/interrupt.h"
#include "../../common/picture_options.h"
#include "../run_file.h"
#include "help_texts.h"
#include "verbs.h"

namespace rakelight::cli {
namespace {

Command convert_command() {
    const Option file = {
        .name = "output",
        .group = "Output",
        .type = "FILE",
        .help =
            "File to write: .glb, .gltf, .obj or .ply; a folder, for a .glb of each model. {model} stands for the "
            "model's name",
        .is_required = true,
        .letter = 'o'};
    return {"convert",
            "Write models in another format, with their normals as they are",
            convert_footer,
            {{"MODEL", models_help}},
            apps::joined({{file}, apps::input_options(), apps::without(apps::common_options(), {"config"})})};
}

int run_convert(const Run& run) {
    std::vector<ConvertedFileRow> rows;
    int worst = 0;
    for (const InputRequest& input : picture_requests(run)) {
        const PictureRequest& request = input.picture;
        if (CancelOnInterrupt::happened()) break;
        ConvertedFileRow& row = rows.emplace_back();
        row.result.file = request.input, row.result.output = request.output;
        const int code = run_input(run, input, row, [&](Context& c) {
            row.result = convert_file(request.input, request.output, request.load, c);
        });
        if (code == 0) print_note(summary(row.result), run.loudness);
        worst = std::max(worst, code);
    }
    if (run.is_json) print_data(to_json(rows));
    return worst;
}

}  // namespace

const Verb convert_verb = {convert_command, run_convert};

}  // namespace rakelight::cli
