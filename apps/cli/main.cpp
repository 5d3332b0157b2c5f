// SPDX-License-Identifier: Apache-2.0
// The program `rakelight`. What the verbs do is the library's; here are files in, messages out and the exit code.
#include <algorithm>

#include <rakelight/rakelight.h>

#include "console.h"
#include "interrupt.h"
#include "options.h"
#include "run_file.h"
#include "stats_text.h"
#include "version_text.h"

namespace rakelight::cli {
namespace {

/// The error of an input that a signal came before.
Error not_begun(const std::string& file) { return Error(ErrorCode::failed, "cancelled").with_file(file); }

int run_render(const Options& options) {
    const std::vector<InputRequest> requests = picture_requests(options);
    for (const InputRequest& request : requests)
        if (!request.error) check_request(request.picture);
    std::vector<PictureRow> rows;
    int worst = 0;
    for (const InputRequest& input : requests) {
        const PictureRequest& request = input.picture;
        PictureRow& row = rows.emplace_back();
        row.result = {.file = request.input, .output = request.output};
        if (CancelOnInterrupt::happened()) {
            row.error = not_begun(request.input);
            continue;
        }
        const int code = run_input(options, input, row, [&](Context& c) { row.result = render_picture(request, c); });
        if (code == 0) print_note(summary(row.result), options.loudness);
        if (code == 0 && options.stats && !options.json) print_text(stats_text(row.result));
        worst = std::max(worst, code);
    }
    if (options.json) print_data(to_json(rows));
    return worst;
}

int run(int argc, const char* const* argv) {
    const Options options = parse(argc, argv);
    switch (options.verb) {
        case Verb::help:
            print_data(options.help);
            return 0;
        case Verb::version:
            print_data(version_text());
            return 0;
        case Verb::render:
            return run_render(options);
        case Verb::inspect:
            return run_inspect(options);
        case Verb::explain:
            return run_explain(options);
        case Verb::stages:
            return run_stages(options);
        case Verb::bench:
            return run_bench(options);
        case Verb::smooth:
            return run_smooth(options);
        case Verb::check:
            return run_check(options);
    }
    return 0;
}

}  // namespace
}  // namespace rakelight::cli

int main(int argc, char** argv) {
    try {
        const int code = rakelight::cli::run(argc, argv);
        rakelight::cli::CancelOnInterrupt::die_of_signal();
        return code;
    } catch (...) {
        const rakelight::Error error = rakelight::current_error();
        rakelight::cli::print_error(error);
        rakelight::cli::CancelOnInterrupt::die_of_signal();
        return rakelight::exit_code(error.code());
    }
}
