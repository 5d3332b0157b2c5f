// SPDX-License-Identifier: Apache-2.0
#include "run.h"

#include <algorithm>

#include <rakelight/world/render_keys.h>
#include <rakelight/world/values.h>
#include <rakelight/world/world_request.h>
#include <rakelight_internal/world/settings_file.h>

#include "../common/view_command.h"
#include "file_uri.h"
#include "inputs.h"
#include "output_names.h"

namespace rakelight::cli {
namespace {

/// Whether a setting of a world's means something to this command.
bool takes(const Run& run, std::string_view key) {
    if (!apps::takes_setting(run.command, key)) return false;
    const Option* const option = apps::find_or_null(run.command.options, key);
    return !option || std::string_view(option->group) != "Heat map" || run.given.has("heatmap") ||
           run.given.has("report");
}

/// Then what several settings can only get wrong together depends on what the worlds say.
bool are_all_worlds(const Run& run) {
    const auto models =
        std::ranges::count_if(run.inputs, [](const std::string& input) { return !is_world_file(input); });
    const bool is_bench = std::string_view(run.command.name) == "bench";  // its first word is no input
    return !run.inputs.empty() && models == (is_bench ? 1 : 0) && run.inputs.size() > (is_bench ? 1u : 0u);
}

/// The settings of --config that the command line says nothing of go before its own.
void take_config(Run& run) {
    Context quiet({.threads = 1});
    std::vector<WorldValue> given = run.given.settings();
    const RenderOverrides overrides{given, [&run](std::string_view key) { return takes(run, key); }};
    run.config = read_settings_file(run.given.word("config"), run.picture.load, overrides, quiet);
    std::vector<WorldValue> all = run.config->applied;
    all.insert(all.end(), given.begin(), given.end());
    run.given.set_settings(std::move(all));
}

constexpr std::uint64_t most_standard_input = std::uint64_t(4) << 30;  ///< [bytes] without --max-memory

/// The texts of the shader files as they are now.
void read_shaders_again(const Run& run, PictureRequest& picture) {
    std::vector<WorldValue> files = run.given.settings();
    std::erase_if(files, [](const WorldValue& value) {
        return (value.key != "lighting" && value.key != "vertex-shader") || !names_files(value);
    });
    read_render_keys(files, picture);
}

/// Folders are gone through, standard input is read, and --as-one leaves one, unless each file is written back.
void take_inputs(Run& run) {
    const std::vector<std::string> words = std::move(run.inputs);
    run.inputs.clear();
    if (run.given.has("watch") && std::ranges::find(words, "-") != words.end())
        throw Error(ErrorCode::usage, "standard input (-) cannot be watched", {}, "name a file").about("watch");
    for (Input& input : expanded(words, run.given.has("recursive"))) {
        if (input.path == "-" && run.picture.load.memory_files.empty())
            run.picture.load.memory_files.push_back(
                standard_input(model_format(run), run.max_memory ? run.max_memory : most_standard_input));
        if (input.path == "-") input.path = run.picture.load.memory_files[0].name;
        run.folders.emplace(input.path, input.folder);
        run.inputs.push_back(std::move(input.path));
    }
    const bool writes_each = std::string_view(run.command.name) == "smooth" && !run.given.has("preview");
    if (!run.given.has("as-one") || run.inputs.empty() || writes_each) return;
    run.picture.load.joined.assign(run.inputs.begin() + 1, run.inputs.end());
    run.inputs.resize(1);
}

}  // namespace

Run run_of(const Command& command, apps::CommandLine line) {
    Run run{.command = command,
            .given = std::move(line.given),
            .inputs = std::move(line.positionals),
            .folders = {},
            .config = {},
            .picture = {}};
    for (std::string& input : run.inputs) input = path_of_uri(input);
    const Given& given = run.given;
    if (given.has("quiet") && given.has("verbose"))
        throw Error(ErrorCode::usage, "--quiet and --verbose exclude each other");
    run.is_json = given.has("json");
    run.loudness = given.has("quiet") ? Loudness::quiet : given.has("verbose") ? Loudness::verbose : Loudness::normal;
    if (given.has("threads")) run.threads = values::integer("threads", given.word("threads"), 1, 1024);
    if (given.has("max-memory")) run.max_memory = values::byte_size("max-memory", given.word("max-memory"));
    run.picture.load.allow_outside = given.has("allow-outside");
    run.picture.load.allow_shaders = given.has("allow-shaders");
    run.picture.output = path_of_uri(given.word("output"));
    run.picture.look = Look::standard;
    if (given.has("config")) take_config(run);
    if (apps::find_or_null(command.options, "recursive")) take_inputs(run);
    run.files->of = std::max(run.inputs.size(), std::size_t(1));
    if (!are_all_worlds(run)) read_render_keys(given.settings(), run.picture);
    run.picture.settings.material_shading = !sets_shading(given.settings());
    return run;
}

WorldRequest world_request(const Run& run, const std::string& path, std::vector<WorldValue> given) {
    Context quiet({.threads = 1});
    const RenderOverrides overrides{std::move(given), [&run](std::string_view key) { return takes(run, key); }};
    WorldRequest world = read_world_request(path, run.picture.load, overrides, quiet);
    world.picture.output = run.picture.output;
    return world;
}

void check_requests(std::vector<InputRequest>& requests) {
    for (InputRequest& request : requests) try {
            if (!request.error) check_request(request.picture);
        } catch (const Error& error) {
            const bool is_of_world = request.world && at_world_value(error, *request.world).file() != error.file();
            if (!is_of_world) throw;
            request.error = at_world_value(error, *request.world);
        }
}

std::string camera_of(const PictureRequest& picture) {
    const std::string& name = !picture.view.camera.empty() ? picture.view.camera : picture.view.side;
    return name.empty() ? "default" : name;
}

std::vector<InputRequest> picture_requests(const Run& run, std::optional<int> frame) {
    std::vector<InputRequest> requests;
    OutputNames names(run, run.inputs.size());
    for (const std::string& input : run.inputs) {
        InputRequest whole = request_for(run, input);
        whole.picture.output = names.of(input, {camera_of(whole.picture), frame});
        requests.push_back(std::move(whole));
    }
    return requests;
}

InputRequest request_for(const Run& run, const std::string& input) {
    InputRequest request{run.picture, {}, run.config};
    try {
        if (is_world_file(input)) {
            request.world = world_request(run, input, run.given.settings());
            request.picture = request.world->picture;
        } else if (run.given.has("watch")) {
            read_shaders_again(run, request.picture);
        }
    } catch (const Error& error) {
        request.error = error;
    }
    request.picture.input = input;
    return request;
}

}  // namespace rakelight::cli
