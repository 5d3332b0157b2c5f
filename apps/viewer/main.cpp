// SPDX-License-Identifier: Apache-2.0
// The program `rakelight-view`: a window in which to live with a model. `rakelight view` starts it.
#include <cstdio>

#include <rakelight/base/current_error.h>
#include <rakelight/world/render_keys.h>
#include <rakelight/world/values.h>
#include <rakelight_internal/base/exit_code.h>

#include "../common/command_line.h"
#include "../common/interrupt.h"
#include "../common/stack.h"
#include "../common/view_command.h"
#include "app.h"

namespace rakelight::viewer {
namespace {

/// The words behind the program's name as those of `rakelight view`.
std::vector<std::string> words_of(int argc, char** argv) {
    std::vector<std::string> words{"view"};
    words.insert(words.end(), argv + std::min(argc, 1), argv + argc);
    return words;
}

Start start_of(const apps::Command& command, const apps::CommandLine& line) {
    const apps::Given& given = line.given;
    Start start{.files = line.positionals, .settings = given.settings()};
    start.takes = [&command](std::string_view key) { return apps::takes_setting(command, key); };
    start.load.allow_outside = given.has("allow-outside");
    start.load.allow_shaders = given.has("allow-shaders");
    if (given.has("threads")) start.threads = values::integer("threads", given.word("threads"), 1, 1024);
    if (given.has("max-memory")) start.max_memory = values::byte_size("max-memory", given.word("max-memory"));
    start.wants_stats = given.has("stats");
    PictureRequest checked;  // what is wrong with them is said before a window opens
    read_render_keys(start.settings, checked);
    return start;
}

int run(int argc, char** argv, const Context& everything) {
    const apps::Command commands[] = {apps::view_command()};
    const apps::Program program{"rakelight", "Shows 3D models made of many parts in a window.", "", commands};
    const apps::CommandLine line = apps::read_command_line(program, words_of(argc, argv));
    if (!line.help.empty()) return std::fputs(line.help.c_str(), stdout) < 0;
    Start start = start_of(commands[0], line);
    start.everything = &everything;
    return App(start).run();
}

int run_or_say(int argc, char** argv) {
    using apps::CancelOnInterrupt;
    Context everything({.threads = 1});
    const CancelOnInterrupt guard(everything, "rakelight: ended by a signal\n");
    try {
        return CancelOnInterrupt::end_by_signal(run(argc, argv, everything));
    } catch (...) {
        const Error error = current_error();
        CancelOnInterrupt::words_are_said();
        std::fprintf(stderr, "rakelight: error: %s\n", error.what());
        return CancelOnInterrupt::end_by_signal(exit_code(error.code()));
    }
}

}  // namespace
}  // namespace rakelight::viewer

int main(int argc, char** argv) {
    return rakelight::apps::with_enough_stack([&] { return rakelight::viewer::run_or_say(argc, argv); });
}
