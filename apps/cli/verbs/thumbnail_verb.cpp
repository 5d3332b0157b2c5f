// SPDX-License-Identifier: Apache-2.0
#include <csignal>
#include <filesystem>
#include <system_error>

#include <rakelight/base/current_error.h>
#include <rakelight/world/render_keys.h>
#include <rakelight/world/values.h>
#include <rakelight_internal/tools/text_file.h>
#include <rakelight_internal/tools/thumbnail.h>

#include "../../common/picture_options.h"
#include "../file_uri.h"
#include "../process_limits.h"
#include "../run_file.h"
#include "help_texts.h"
#include "verbs.h"

namespace rakelight::cli {
namespace {

constexpr std::uint64_t most_bytes = 285 << 20;
constexpr std::uint64_t least_bytes = 32 << 20;  ///< below, the program itself does not start its threads
constexpr std::uint64_t own_bytes = 40 << 20;    ///< [bytes] of them the program's own: code, stacks, tables
constexpr double most_cpu_seconds = 0.3,
                 waits = 10;  ///< times as long by the clock, where a machine is busy or a disk is slow

/// Settings of a world file that a thumbnail takes: those that say what is seen and from where. It has its own size,
/// samples, background, engine and output.
std::vector<Option> settings_of_worlds() {
    return apps::without(apps::picture_options(),
                         {"resolution",       "window",     "samples", "background",     "channels",
                          "channel-files",    "exr-colors", "engine",  "method",         "radiosity-elements",
                          "radiosity-unshot", "max-depth",  "naive",   "naive-limit",    "seed",
                          "max-seconds",      "noise",      "clamp",   "light-sampling", "denoise",
                          "filename",         "metadata",   "bar"});
}

/// @throws Error usage: the thumbnail would be written over the model
void check_output(const std::string& path, const std::string& model) {
    std::error_code ignored;
    if (std::filesystem::equivalent(path, model, ignored))
        throw Error(ErrorCode::usage, "FILE is the model itself").with_file(path);
}

PictureRequest request_of(const Run& run, const std::string& model, int size) {
    const InputRequest whole = request_for(run, model);
    if (whole.error) throw *whole.error;
    PictureRequest request = whole.picture;
    const std::string side = std::to_string(size);
    std::vector<WorldValue> values = {{.key = "resolution", .words = {side + "," + side}},
                                      {.key = "background", .words = {"transparent"}}};
    if (whole.world) values.push_back({.key = "samples", .words = {"4"}});  // as the look of models
    read_render_keys(values, request);
    request.output = "thumbnail.png";  // its ending is the format
    return request;
}

Command thumbnail_command() {
    const Option seconds = {
        "cpu-seconds", "Output", "S",
        "Processor time that the thumbnail may take, 0.05 to 60 (default 0.3); by the clock it is ten times as long"};
    std::vector<Option> options = apps::without(apps::joined({{seconds}, apps::common_options()}), {"config", "json"});
    apps::find(options, "max-memory").help = "Memory that the whole program may take, for example 1G (default: 285M)";
    apps::find(options, "threads").help =
        "Worker threads (default: 1, as file managers ask for several thumbnails at once)";
    return {"thumbnail",
            "Draw the small picture of a model that file managers show",
            thumbnail_footer,
            {{"MODEL", "A path, or the file's address: file:///home/me/a%20model.glb", true, false},
             {"FILE", "PNG to write, whatever its ending", true, false},
             {"SIZE", "Width and height in pixels, 16 to 2048", true, false}},
            options,
            settings_of_worlds()};
}

int run_thumbnail(const Run& run) {
    const std::string model = path_of_uri(run.inputs[0]);
    const int size = values::integer("SIZE", run.inputs[2], 16, 2048);
    const Given& given = run.given;
    const double cpu_seconds = given.has("cpu-seconds")
                                   ? values::number("cpu-seconds", given.word("cpu-seconds"), 0.05, 60)
                                   : most_cpu_seconds;
    const std::uint64_t bytes = run.max_memory ? run.max_memory : most_bytes;
    if (bytes < least_bytes)
        throw values::wrong("max-memory", "must be " + std::to_string(least_bytes >> 20) +
                                              "M or more: the program itself takes as much");
    std::signal(SIGXFSZ, SIG_IGN);  // a limit of file sizes is an error of the write
    try {
        std::vector<std::byte> file;
        check_output(run.inputs[1], model);
        {
            const ProcessLimits limits({cpu_seconds, cpu_seconds * waits, bytes}, model);
            Context context({.threads = run.threads ? run.threads : 1,
                             .max_memory = bytes > 2 * own_bytes ? bytes - own_bytes : bytes / 2});
            file = thumbnail(request_of(run, model, size), cpu_seconds, context);
            if (run.loudness == Loudness::verbose) print_remarks(context.report(), run.loudness);
        }
        save_bytes(run.inputs[1], file, Saving::in_place);
    } catch (...) {
        throw current_error().with_file(model);
    }
    return 0;
}

}  // namespace

const Verb thumbnail_verb = {thumbnail_command, run_thumbnail};

}  // namespace rakelight::cli
