// SPDX-License-Identifier: Apache-2.0
#include "stages_verb.h"

#include <CLI/CLI.hpp>

#include <algorithm>

#include "options.h"
#include "run_file.h"

namespace rakelight::cli {

void add_stages_options(CLI::App& app, RenderWords& w) {
    add_render_options(app, w);
    for (const char* name : {"--window", "--channels", "--channel-files", "--exr-colors", "--engine"})
        app.remove_option(app.get_option(name));
    app.remove_option(app.get_option("--line-color"));
    hide_drawn_lines(app);  // the sizes stay: the picture has the model's own lines and points
    app.get_option("--output")
        ->description(
            "Folder to write, with index.html. It must be new, empty, or written by this command. {model} stands for "
            "the model's name")
        ->type_name("DIR");
}

int run_stages(const Options& options) {
    std::vector<StagesRow> rows;
    int worst = 0;
    for (const InputRequest& input : picture_requests(options)) {
        const PictureRequest& request = input.picture;
        StagesRow row;
        row.result.file = request.input;
        row.result.folder = request.output;
        if (CancelOnInterrupt::happened()) {
            row.error = Error(ErrorCode::failed, "cancelled").with_file(request.input);
        } else {
            const int code = run_input(options, input, row, [&](Context& c) { row.result = write_stages(request, c); });
            worst = std::max(worst, code);
            if (code == 0)
                print_note(row.result.folder + "/index.html: " + std::to_string(row.result.files.size()) + " files",
                           options.loudness);
        }
        rows.push_back(std::move(row));
    }
    if (options.json) print_data(to_json(rows));
    return worst;
}

}  // namespace rakelight::cli
