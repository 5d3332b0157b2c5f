// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <rakelight/tools/rows.h>
#include <rakelight/world/world_request.h>

#include "../../common/interrupt.h"
#include "../../common/picture_options.h"
#include "../../common/view_command.h"
#include "../run_file.h"
#include "help_texts.h"
#include "verbs.h"

namespace rakelight::cli {
namespace {

Command check_command() {
    const Option schema = {"schema", "Output", "", "Print the JSON schema of world files, for editors, and exit",
                           apps::Form::flag};
    return {"check",
            "Check that scene files load, and list what they contain",
            check_footer,
            {{"SCENE", "Model files and world files", false}},
            apps::joined({{schema}, apps::input_options(), apps::common_options()})};
}

/// Reads [render] of a world, and checks it against the loaded scene; nothing for other files. @throws Error bad_file
void check_render(const Run& run, const std::string& input, const Scene& scene, Context& context) {
    if (!is_world_file(input)) return;
    const auto takes = [](std::string_view key) { return apps::refuse_options_of_the_run(key), true; };
    LoadOptions options = run.picture.load;
    options.allow_shaders = true;  // nothing compiles them here
    const WorldRequest world = read_world_request(input, options, {.values = {}, .accepts = takes}, context);
    try {
        check_picture(scene, world.picture, context);
    } catch (const Error& error) {
        throw at_world_value(error, world);
    }
}

int run_check(const Run& run) {
    if (run.given.has("schema")) {
        print_data(world_schema());
        return 0;
    }
    if (run.inputs.empty()) throw Error(ErrorCode::usage, "check needs a scene", {}, "see rakelight check --help");
    std::vector<CheckRow> rows;
    int worst = 0;
    for (const std::string& file : run.inputs) {
        CheckRow& row = rows.emplace_back();
        row.file = file;
        if (CancelOnInterrupt::happened()) {
            row.error = Error(ErrorCode::failed, "cancelled").with_file(file);
            continue;
        }
        const int code = run_file(run, file, row, [&](Context& context) {
            const Scene scene = load(file, run.picture.load, context);
            check_render(run, file, scene, context);
            row.summary = summarize(scene);
        });
        worst = std::max(worst, code);
        if (!run.is_json && row.summary) print_text(to_text(file, *row.summary));
    }
    if (run.is_json) print_data(to_json(rows));
    return worst;
}

}  // namespace

const Verb check_verb = {check_command, run_check};

}  // namespace rakelight::cli
