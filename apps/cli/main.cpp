// SPDX-License-Identifier: Apache-2.0
// The program `rakelight`. What the verbs do is the library's; here are files in, messages out and the exit code.
#include <algorithm>
#include <cstdio>
#include <functional>
#include <new>

#include <rakelight/rakelight.h>

#include "console.h"
#include "interrupt.h"
#include "options.h"
#include "version_text.h"

namespace rakelight::cli {
namespace {

/// What goes wrong with one of many files, as an error that names it.
Error error_of(const std::string& file) {
    try {
        throw;
    } catch (const Error& error) {
        return error.with_file(file);
    } catch (const std::bad_alloc&) {
        return Error(ErrorCode::failed, "out of memory").with_file(file);
    } catch (const std::exception& error) {
        return Error(ErrorCode::failed, std::string("unexpected: ") + error.what()).with_file(file);
    }
}

/// Runs the work of one file with a context of its own; fills the remarks and the error of `row`. Returns the exit
/// code.
template <class Row>
int run_file(const Options& options, const std::string& file, Row& row, const std::function<void(Context&)>& work) {
    ProgressLine progress(file, options.loudness);
    Context context({.threads = options.threads, .max_memory = options.max_memory, .progress = progress.callback()});
    const CancelOnInterrupt guard(context);
    try {
        work(context);
    } catch (...) {
        row.error = error_of(file);
    }
    progress.wipe();
    row.remarks = context.report().entries();
    row.remarks_left_out = context.report().left_out();
    print_remarks(row.remarks, row.remarks_left_out, options.loudness);
    if (row.error) print_error(*row.error);
    return row.error ? exit_code(row.error->code()) : 0;
}

int run_render(const Options& options) {
    const std::vector<PictureRequest> requests = picture_requests(options);
    for (const PictureRequest& request : requests) check_request(request);
    std::vector<PictureRow> rows;
    int worst = 0;
    for (const PictureRequest& request : requests) {
        PictureRow& row = rows.emplace_back();
        row.result = {.file = request.input, .output = request.output};
        const int code =
            run_file(options, request.input, row, [&](Context& c) { row.result = render_picture(request, c); });
        if (code == 0) print_note(summary(row.result), options.loudness);
        worst = std::max(worst, code);
    }
    if (options.json) print_data(to_json(rows));
    return worst;
}

int run_inspect(const Options& options) {
    std::vector<InspectionRow> rows;
    int worst = 0;
    for (const std::string& file : options.inputs) {
        InspectionRow row{.file = file};
        worst = std::max(worst, run_file(options, file, row, [&](Context& c) {
                             row.inspection = inspect(load(file, options.picture.load, c), options.inspect, c);
                         }));
        if (!options.json && row.inspection) print_data((rows.empty() ? "" : "\n") + to_text(*row.inspection));
        rows.push_back(std::move(row));
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
    }
    return 0;
}

}  // namespace
}  // namespace rakelight::cli

int main(int argc, char** argv) {
    try {
        return rakelight::cli::run(argc, argv);
    } catch (...) {
        const rakelight::Error error = rakelight::cli::error_of("");
        rakelight::cli::print_error(error);
        return rakelight::exit_code(error.code());
    }
}
