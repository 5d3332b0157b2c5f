// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
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

bool is_same_file(const struct stat& a, const struct stat& b) { return a.st_dev == b.st_dev && a.st_ino == b.st_ino; }

bool write_all(int file, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t count = write(file, bytes.data(), bytes.size());
        if (count > 0) bytes = bytes.subspan(std::size_t(count));
        if (count == 0 || (count < 0 && errno != EINTR)) return false;
    }
    return true;
}

/// Writes in place: the folder may be a sandbox in which no file can be renamed onto another. A file that cannot be
/// written completely is left empty, or removed if it was not there before.
/// @throws Error usage: the file is the model itself; failed: it cannot be written
void write_file(const std::string& path, const std::string& model, std::span<const std::byte> bytes) {
    struct stat before {
    }, input{};
    const bool was_there = stat(path.c_str(), &before) == 0;
    if (was_there && stat(model.c_str(), &input) == 0 && is_same_file(before, input))
        throw Error(ErrorCode::usage, "FILE is the model itself").with_file(path);
    const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | O_NOCTTY | O_NONBLOCK, 0666);
    bool is_written = file >= 0 && (ftruncate(file, 0) == 0 || errno == EINVAL) && write_all(file, bytes);
    int reason = errno;
    if (file >= 0 && !is_written && ftruncate(file, 0) == 0 && !was_there) unlink(path.c_str());
    if (file >= 0 && close(file) != 0 && is_written) is_written = false, reason = errno;
    if (!is_written)
        throw Error(ErrorCode::failed, std::string("cannot write: ") + std::strerror(reason)).with_file(path);
}

PictureRequest request_of(const Run& run, const std::string& model, int size) {
    const InputRequest whole = request_for(run, model);
    if (whole.error) throw *whole.error;
    PictureRequest request = whole.picture;
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
    std::signal(SIGXFSZ, SIG_IGN);  // a limit of file sizes is an error of the write
    try {
        std::vector<std::byte> file;
        {
            const ProcessLimits limits({cpu_seconds, cpu_seconds * waits, bytes}, model);
            Context context({.threads = run.threads ? run.threads : 1,
                             .max_memory = bytes > 2 * own_bytes ? bytes - own_bytes : bytes / 2});
            render_picture(request_of(run, model, size), file, context);
            if (run.loudness == Loudness::verbose) print_remarks(context.report(), run.loudness);
        }
        write_file(run.inputs[1], model, file);
    } catch (...) {
        throw current_error().with_file(model);
    }
    return 0;
}

}  // namespace rakelight::cli
