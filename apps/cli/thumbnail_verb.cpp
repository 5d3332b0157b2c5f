// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include <rakelight/tools/current_error.h>
#include <rakelight/tools/values.h>

#include "../common/picture_options.h"
#include "file_uri.h"
#include "help_texts.h"
#include "process_limits.h"
#include "run_file.h"
#include "verbs.h"

namespace rakelight::cli {
namespace {

constexpr std::uint64_t most_bytes = 285 << 20;
constexpr std::uint64_t own_bytes = 40 << 20;  ///< [bytes] of them the program's own: code, stacks, tables
constexpr double most_cpu_seconds = 0.3,
                 waits = 10;  ///< times as long by the clock, where a machine is busy or a disk is slow

/// The file as it is: where it lies may be a sandbox in which nothing can be renamed onto it.
void write_file(const std::string& path, std::span<const std::byte> bytes) {
    const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    bool is_written = file >= 0;
    while (is_written && !bytes.empty()) {
        const ssize_t count = write(file, bytes.data(), bytes.size());
        is_written = count > 0 || (count < 0 && errno == EINTR);
        if (count > 0) bytes = bytes.subspan(std::size_t(count));
    }
    const int reason = errno;
    if (file >= 0 && close(file) == 0 && is_written) return;
    throw Error(ErrorCode::failed, std::string("cannot write: ") + std::strerror(reason)).with_file(path);
}

PictureRequest request_of(const Run& run, const std::string& model, int size) {
    PictureRequest request = request_for(run, model).picture;
    const std::string side = std::to_string(size);
    const WorldValue values[] = {{.key = "resolution", .words = {side + "," + side}},
                                 {.key = "background", .words = {"transparent"}}};
    read_render_keys(values, request);
    request.output = "thumbnail.png";  // its ending is the format
    return request;
}

}  // namespace

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
            options};
}

int run_thumbnail(const Run& run) {
    const std::string model = path_of_uri(run.inputs[0]);
    const int size = values::integer("SIZE", run.inputs[2], 16, 2048);
    const Given& given = run.given;
    const double cpu_seconds = given.has("cpu-seconds")
                                   ? values::number("cpu-seconds", given.word("cpu-seconds"), 0.05, 60)
                                   : most_cpu_seconds;
    const std::uint64_t bytes = run.max_memory ? run.max_memory : most_bytes;
    try {
        const ProcessLimits limits({cpu_seconds, cpu_seconds * waits, bytes}, model);
        Context context({.threads = run.threads ? run.threads : 1,
                         .max_memory = bytes > 2 * own_bytes ? bytes - own_bytes : bytes / 2});
        std::vector<std::byte> file;
        render_picture(request_of(run, model, size), file, context);
        if (run.loudness == Loudness::verbose) print_remarks(context.report(), run.loudness);
        write_file(run.inputs[1], file);
    } catch (...) {
        throw current_error().with_file(model);
    }
    return 0;
}

}  // namespace rakelight::cli
