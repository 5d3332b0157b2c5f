// SPDX-License-Identifier: Apache-2.0
#include "run.h"

#include <algorithm>

#include <rakelight/tools/values.h>
#include <rakelight/version.h>

namespace rakelight::cli {
namespace {

/// Whether a setting of a world's means something to this command.
bool takes(const Run& run, std::string_view key) {
    refuse_options_of_the_run(key);
    const Option* const option = apps::find_or_null(run.command.options, key);
    if (!option || !option->is_setting) return false;
    return std::string_view(option->group) != "Heat map" || run.given.has("heatmap");
}

}  // namespace

void refuse_options_of_the_run(std::string_view key) {
    for (const std::string_view name :
         {"output", "help", "json", "quiet", "verbose", "stats", "threads", "max-memory", "allow-outside", "material"})
        if (key == name)
            throw Error(ErrorCode::bad_file, "'" + std::string(key) + "' is for the command line alone");
}

void check_engine(const std::string& name) {
    std::string all;
    for (const std::string& known : build_info().engines) {
        if (name == known) return;
        all += (all.empty() ? "" : ", ") + known;
    }
    throw values::wrong("engine", "'" + one_line(name, 40) + "' is not built in", "this build has: " + all);
}

Run run_of(const Command& command, apps::CommandLine line) {
    Run run{.command = command, .given = std::move(line.given), .inputs = std::move(line.positionals), .picture = {}};
    const Given& given = run.given;
    if (given.has("quiet") && given.has("verbose"))
        throw Error(ErrorCode::usage, "--quiet and --verbose exclude each other");
    run.is_json = given.has("json");
    run.loudness = given.has("quiet") ? Loudness::quiet : given.has("verbose") ? Loudness::verbose : Loudness::normal;
    if (given.has("threads")) run.threads = values::integer("threads", given.word("threads"), 1, 1024);
    if (given.has("max-memory")) run.max_memory = values::byte_size("max-memory", given.word("max-memory"));
    run.picture.load.allow_outside = given.has("allow-outside");
    run.picture.output = given.word("output");
    read_render_keys(given.settings(), run.picture);
    check_engine(run.picture.engine);
    run.picture.settings.own_shading = !shades_the_whole(given.settings());
    return run;
}

WorldRequest world_request(const Run& run, const std::string& path, std::vector<WorldValue> given) {
    Context quiet({.threads = 1});
    const RenderOverrides overrides{std::move(given), [&run](std::string_view key) { return takes(run, key); }};
    WorldRequest world = read_world_request(path, run.picture.load, overrides, quiet);
    try {
        check_engine(world.picture.engine);
    } catch (const Error& error) {
        throw at_world_value(error, world);
    }
    world.picture.output = run.picture.output;
    return world;
}

InputRequest request_for(const Run& run, const std::string& input) {
    InputRequest request{run.picture, {}, {}};
    try {
        if (is_world_file(input)) {
            request.world = world_request(run, input, run.given.settings());
            request.picture = request.world->picture;
        }
    } catch (const Error& error) {
        request.error = error;
    }
    request.picture.input = input;
    return request;
}

}  // namespace rakelight::cli
