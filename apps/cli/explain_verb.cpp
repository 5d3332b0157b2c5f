// SPDX-License-Identifier: Apache-2.0
#include "explain_verb.h"

#include <algorithm>

#include <rakelight/tools/rows.h>
#include <rakelight/tools/values.h>

#include "../common/picture_options.h"
#include "help_texts.h"
#include "interrupt.h"
#include "run_file.h"

namespace rakelight::cli {

Command explain_command() {
    const Option pixel = {.name = "pixel",
                          .group = "Output",
                          .type = "X,Y",
                          .help = "Which pixel; 0,0 is the top left one",
                          .is_required = true};
    // What is about files and parts of pictures has no meaning here.
    std::vector<Option> options = apps::without(
        apps::picture_options(),
        {"window", "channels", "channel-files", "exr-colors", "engine", "line-width", "point-size", "line-color"});
    apps::hide_drawn_lines(options);
    return {"explain",
            "Say why a pixel has its color: every number on the way to it",
            explain_footer,
            {{"MODEL", models_help}},
            apps::joined({{pixel}, options, apps::common_options()})};
}

namespace {

struct Pixel {
    int x, y;
};

Pixel pixel_of(const Run& run) {
    const std::vector<int> pixel = values::integers("pixel", run.given.word("pixel"), 2);
    const RenderSettings& s = run.picture.settings;
    if (std::ranges::all_of(run.inputs, is_world_file)) return {pixel[0], pixel[1]};  // may say how large they are
    if (pixel[0] < 0 || pixel[1] < 0 || pixel[0] >= s.width || pixel[1] >= s.height)
        throw values::wrong(
            "pixel",
            "the picture has " + std::to_string(s.width) + " x " + std::to_string(s.height) + " pixels, counted from 0",
            "--resolution says how many");
    return {pixel[0], pixel[1]};
}

}  // namespace

int run_explain(const Run& run) {
    const Pixel pixel = pixel_of(run);
    std::vector<ExplainRow> rows;
    int worst = 0;
    for (const std::string& file : run.inputs) {
        const InputRequest input = request_for(run, file);
        ExplainRow row{.file = file, .x = pixel.x, .y = pixel.y};
        if (CancelOnInterrupt::happened()) {
            row.error = Error(ErrorCode::failed, "cancelled").with_file(file);
        } else {
            const int code =
                run_input(run, input, row, [&](Context& c) { row.pixel = explain(input.picture, row.x, row.y, c); });
            worst = std::max(worst, code);
        }
        if (!run.is_json && row.pixel) print_text((rows.empty() ? "" : "\n") + to_text(*row.pixel));
        rows.push_back(std::move(row));
    }
    if (run.is_json) print_data(to_json(rows));
    return worst;
}

}  // namespace rakelight::cli
