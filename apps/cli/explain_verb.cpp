// SPDX-License-Identifier: Apache-2.0
#include "explain_verb.h"

#include <CLI/CLI.hpp>

#include <algorithm>

#include "options.h"
#include "run_file.h"
#include "values.h"

namespace rakelight::cli {

void add_explain_options(CLI::App& app, ExplainWords& w) {
    app.add_option("--pixel", w.pixel, "Which pixel; 0,0 is the top left one")
        ->type_name("X,Y")
        ->group("Output")
        ->required();
    add_render_options(app, w.render);
    // What is about files and parts of pictures has no meaning here.
    for (const char* name : {"--output", "--window", "--channels", "--channel-files", "--exr-colors", "--engine"})
        app.remove_option(app.get_option(name));
    for (const char* name : {"--line-width", "--point-size", "--line-color"}) app.remove_option(app.get_option(name));
    hide_drawn_lines(app);
}

void apply(const ExplainWords& words, ExplainRequest& request, PictureRequest& picture) {
    const std::vector<int> pixel = integers("pixel", words.pixel, 2);
    request.x = pixel[0];
    request.y = pixel[1];
    const RenderSettings& s = picture.settings;
    if (request.x < 0 || request.y < 0 || request.x >= s.width || request.y >= s.height)
        throw wrong(
            "pixel",
            "the picture has " + std::to_string(s.width) + " x " + std::to_string(s.height) + " pixels, counted from 0",
            "--resolution says how many");
}

int run_explain(const Options& options) {
    std::vector<ExplainRow> rows;
    int worst = 0;
    for (const std::string& file : options.inputs) {
        const InputRequest input = request_for(options, file);
        ExplainRow row{.file = file, .x = options.explain.x, .y = options.explain.y};
        if (CancelOnInterrupt::happened()) {
            row.error = Error(ErrorCode::failed, "cancelled").with_file(file);
        } else {
            const int code = run_input(options, input, row,
                                       [&](Context& c) { row.pixel = explain(input.picture, row.x, row.y, c); });
            worst = std::max(worst, code);
        }
        if (!options.json && row.pixel) print_text((rows.empty() ? "" : "\n") + to_text(*row.pixel));
        rows.push_back(std::move(row));
    }
    if (options.json) print_data(to_json(rows));
    return worst;
}

}  // namespace rakelight::cli
