// SPDX-License-Identifier: Apache-2.0
#include "render_verb.h"

#include <algorithm>

#include <rakelight/tools/rows.h>

#include "../common/picture_options.h"
#include "help_texts.h"
#include "interrupt.h"
#include "run_file.h"
#include "stats_text.h"

namespace rakelight::cli {

Command render_command() {
    const Option picture = {.name = "output",
                            .group = "Output",
                            .type = "FILE",
                            .help =
                                "Picture to write: .png .jpg .webp (sRGB) .exr .hdr (linear). {model} stands for "
                                "the model's name",
                            .is_required = true,
                            .letter = 'o'};
    const Option stats = {"stats", "Output", "",
                          "Say what the engine counted: lighting evaluations, triangles, pixels, overdraw",
                          apps::Form::flag};
    const Option partial = {"keep-partial", "Output", "",
                            "Write an interrupted picture all the same, the rest in the background's color",
                            apps::Form::flag};
    return {"render",
            "Draw models to picture files",
            render_footer,
            {{"MODEL", models_help}},
            apps::joined({{picture}, apps::picture_options(), {stats, partial}, apps::common_options()})};
}

int run_render(const Run& run) {
    std::vector<InputRequest> requests = picture_requests(run);
    const bool keeps_partial = run.given.has("keep-partial");
    for (InputRequest& input : requests) input.picture.keep_partial = keeps_partial;
    if (keeps_partial) CancelOnInterrupt::let_finish();
    check_requests(requests);
    std::vector<PictureRow> rows;
    int worst = 0;
    for (const InputRequest& input : requests) {
        const PictureRequest& request = input.picture;
        PictureRow& row = rows.emplace_back();
        row.result = {.file = request.input, .output = request.output};
        if (CancelOnInterrupt::happened()) {
            row.error = Error(ErrorCode::failed, "cancelled").with_file(request.input);
            continue;
        }
        const int code = run_input(run, input, row, [&](Context& c) { row.result = render_picture(request, c); });
        if (code == 0) print_note(summary(row.result), run.loudness);
        if (code == 0 && run.given.has("stats") && !run.is_json) print_text(stats_text(row.result));
        worst = std::max(worst, code);
    }
    if (run.is_json) print_data(to_json(rows));
    return worst;
}

}  // namespace rakelight::cli
