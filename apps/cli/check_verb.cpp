// SPDX-License-Identifier: Apache-2.0
#include "check_verb.h"

#include <CLI/CLI.hpp>

#include <algorithm>

#include <rakelight/world.h>

#include "options.h"
#include "run_file.h"

namespace rakelight::cli {

void add_check_options(CLI::App& app, CheckWords& words) {
    app.add_flag("--schema", words.schema, "Print the JSON schema of world files, for editors, and end")
        ->group("Output");
}

int run_check(const Options& options) {
    if (options.print_schema) {
        print_data(world_schema());
        return 0;
    }
    if (options.inputs.empty()) throw Error(ErrorCode::usage, "check needs a scene", {}, "see rakelight check --help");
    std::vector<CheckRow> rows;
    int worst = 0;
    for (const std::string& file : options.inputs) {
        CheckRow& row = rows.emplace_back();
        row.file = file;
        if (CancelOnInterrupt::happened()) {
            row.error = Error(ErrorCode::failed, "cancelled").with_file(file);
            continue;
        }
        const int code = run_file(options, file, row, [&](Context& context) {
            const Scene scene = load(file, options.picture.load, context);
            check_world_options(options, file, scene, context);
            row.summary = summarize(scene);
        });
        worst = std::max(worst, code);
        if (!options.json && row.summary) print_text(to_text(file, *row.summary));
    }
    if (options.json) print_data(to_json(rows));
    return worst;
}

}  // namespace rakelight::cli
