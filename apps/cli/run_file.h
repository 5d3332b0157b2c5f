// SPDX-License-Identifier: Apache-2.0
// The frame around the work of one file: its context, progress, interruption, messages and exit code.
#pragma once
#include <functional>

#include <rakelight/base/current_error.h>
#include <rakelight/world/world_request.h>
#include <rakelight_internal/base/exit_code.h>
#include <string>

#include "../common/interrupt.h"
#include "console.h"
#include "progress_line.h"
#include "run.h"

namespace rakelight::cli {

/// Runs the work of one file with a context of its own; fills the remarks and the error of `row`. Returns the exit
/// code.
template <class Row>
int run_file(const Run& run, const std::string& file, Row& row, const std::function<void(Context&)>& work) {
    ProgressLine progress(file, run.loudness, *run.files);
    Context context({.threads = run.threads, .max_memory = run.max_memory, .progress = progress.callback()});
    const CancelOnInterrupt guard(context, cancelled_line(file));
    try {
        work(context);
    } catch (...) {
        row.error = current_error().with_file(file);
    }
    progress.wipe();
    row.remarks = context.report().entries();
    row.remarks_left_out = context.report().left_out();
    print_remarks(context.report(), run.loudness);
    if (row.error) {
        CancelOnInterrupt::words_are_said();
        print_error(*row.error);
    }
    return row.error ? exit_code(row.error->code()) : 0;
}

/// The same of a request; faults of options carry their place in the world file.
template <class Row>
int run_input(const Run& run, const InputRequest& input, Row& row, const std::function<void(Context&)>& work) {
    return run_file(run, input.picture.input, row, [&](Context& context) {
        if (input.error) throw *input.error;
        try {
            work(context);
        } catch (const Error& error) {
            if (!input.world) throw;
            throw at_world_value(error, *input.world);
        }
    });
}

}  // namespace rakelight::cli
