// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <rakelight/tools/compare.h>
#include <rakelight/tools/rows.h>
#include <rakelight/world/values.h>
#include <rakelight_internal/tools/compare_page.h>
#include <rakelight_internal/tools/stages.h>

#include "../../common/interrupt.h"
#include "../../common/picture_options.h"
#include "../run_file.h"
#include "help_texts.h"
#include "verbs.h"

namespace rakelight::cli {
namespace {

Command stages_command() {
    const Option folder = {.name = "output",
                           .group = "Output",
                           .type = "DIR",
                           .help =
                               "Folder to write, with index.html. It must be new, empty, or written by this "
                               "command. {model} stands for the model's name",
                           .is_required = true,
                           .letter = 'o'};
    const Option single = {"single-file", "Output", "", "Write one self-contained page: -o names the .html file",
                           apps::Form::flag};
    std::vector<Option> options = apps::without(
        apps::picture_options(), {"window", "channels", "channel-files", "exr-colors", "engine", "line-color"});
    apps::hide_drawn_lines(options);  // the sizes stay: the picture has the model's own lines and points
    return {"stages",
            "Show the result of each pipeline stage for a model, as a web page",
            stages_footer,
            {{"MODEL", models_help}},
            apps::joined(
                {{folder, single}, apps::input_options(), options, {apps::shader_option()}, apps::common_options()})};
}

int run_stages(const Run& run) {
    const StagesForm form = run.given.has("single-file") ? StagesForm::single_file : StagesForm::folder;
    if (form == StagesForm::single_file && !is_page(run.picture.output))
        throw values::wrong("single-file",
                            "writes a page, and '" + one_line(run.picture.output, 80) + "' is no .html file",
                            "write for example -o stages.html");
    if (form == StagesForm::folder && is_page(run.picture.output))
        throw values::wrong("output",
                            "'" + one_line(run.picture.output, 80) + "' names a page, but a folder is written",
                            "add --single-file");
    std::vector<StagesRow> rows;
    int worst = 0;
    for (const InputRequest& input : picture_requests(run)) {
        const PictureRequest& request = input.picture;
        StagesRow row;
        row.result.file = request.input;
        row.result.folder = request.output;
        if (CancelOnInterrupt::happened()) {
            row.error = Error(ErrorCode::failed, "cancelled").with_file(request.input);
        } else {
            const int code =
                run_input(run, input, row, [&](Context& c) { row.result = write_stages(request, c, form); });
            worst = std::max(worst, code);
            if (code == 0)
                print_note(
                    form == StagesForm::single_file
                        ? row.result.folder + ": a page of all stages"
                        : row.result.folder + "/index.html: " + std::to_string(row.result.files.size()) + " files",
                    run.loudness);
        }
        rows.push_back(std::move(row));
    }
    if (run.is_json) print_data(to_json(rows));
    return worst;
}

}  // namespace

const Verb stages_verb = {stages_command, run_stages};

}  // namespace rakelight::cli
