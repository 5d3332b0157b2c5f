// SPDX-License-Identifier: Apache-2.0
// The program `rakelight`. What the commands do is the library's; here are files in, messages out and the exit code.
#include <algorithm>

#include <rakelight_internal/base/exit_code.h>

#include "../common/completion.h"
#include "../common/interrupt.h"
#include "../common/manual.h"
#include "../common/stack.h"
#include "../common/view_command.h"
#include "implied_verb.h"
#include "run_file.h"
#include "verbs/help_texts.h"
#include "verbs/verbs.h"
#include "verbs/view_verb.h"
#include "version_text.h"

namespace rakelight::cli {
namespace {

int run(int argc, const char* const* argv) {
    const Verb verbs[] = {
        render_verb,
        inspect_verb,
        smooth_verb,
        convert_verb,
#if RL_ALL_VERBS
        bench_verb,
#endif
        explain_verb,
#if RL_ALL_VERBS
        stages_verb,
#endif
        compare_verb,
        check_verb,
#if RL_ALL_VERBS
        join_windows_verb,
        bake_verb,
        radiosity_verb,
#endif
#if RL_PROCESSES
        thumbnail_verb,
        {apps::view_command, nullptr},
#endif
    };
    std::vector<Command> commands;
    for (const Verb& verb : verbs) commands.push_back(verb.command());
    const apps::Program program{"rakelight", "Renders 3D models made of many parts: bumps show, seams do not.",
                                main_footer, commands, "rakelight MODEL... [-o FILE] [OPTIONS]"};
    const std::vector<std::string> words = with_implied_verb(program, {argv + std::min(argc, 1), argv + argc});
    apps::CommandLine line;
    line.help = apps::manual_for(program, words) + apps::completion_for(program, words);
    if (line.help.empty()) line = apps::read_command_line(program, words);
    if (!line.help.empty() || line.is_version) {
        print_data(line.is_version ? version_text() : line.help);
        return 0;
    }
    const std::size_t number = line.command;
    if (!verbs[number].run)
        become_viewer({words.begin() + 1, words.end()}, line.positionals, line.given.has("recursive"));
    return verbs[number].run(run_of(commands[number], std::move(line)));
}

int run_or_say(int argc, const char* const* argv) {
    try {
        return CancelOnInterrupt::end_by_signal(run(argc, argv));
    } catch (...) {
        const Error error = current_error();
        CancelOnInterrupt::words_are_said();
        print_error(error);
        return CancelOnInterrupt::end_by_signal(exit_code(error.code()));
    }
}

}  // namespace
}  // namespace rakelight::cli

int main(int argc, char** argv) {
    return rakelight::apps::with_enough_stack([&] { return rakelight::cli::run_or_say(argc, argv); });
}
