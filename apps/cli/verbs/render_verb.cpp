// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <algorithm>
#include <cstdint>

#include <rakelight/tools/rows.h>
#include <rakelight_internal/base/text.h>

#include "../../common/interrupt.h"
#include "../../common/picture_options.h"
#include "../../common/watched_files.h"
#include "../output_names.h"
#include "../run_file.h"
#include "../stats_text.h"
#include "help_texts.h"
#include "references.h"
#include "sequence_verb.h"
#include "verbs.h"

namespace rakelight::cli {
namespace {

Command render_command() {
    const Option picture = {
        .name = "output",
        .group = "Output",
        .type = "FILE",
        .help =
            "Picture to write: .png .jpg .webp .ppm (sRGB) .exr .hdr (linear); a folder, for one picture per model; - "
            "or ppm:- for standard output. Placeholders: {model} {ext} {dir} (name, ending and folder of the model), "
            "{n} (its number; {n:3} has three digits), {camera} (of --camera-index or --view) and {frame} (of a "
            "sequence or of --watch; {frame:4} as 0007). Missing folders are created. Or a movie: .mp4 .webm .gif "
            ".apng, and .webp of a sequence",
        .is_required = true,
        .letter = 'o'};
    const Option watch = {"watch", "Output", "", "Draw again whenever a file of the model changes, until interrupted",
                          apps::Form::flag};
    const Option stats = {"stats", "Output", "",
                          "Print what the engine counted: lighting evaluations, triangles, pixels, overdraw",
                          apps::Form::flag};
    const Option partial = {"keep-partial", "Output", "",
                            "Write the picture even if it is interrupted, the rest in the background color",
                            apps::Form::flag};
    return {"render",
            "Draw models to picture files",
            render_footer,
            {{"MODEL", models_help}},
            apps::joined({{picture, watch},
                          apps::input_options(),
                          apps::picture_options(),
                          sequence_options(),
                          {stats, partial, apps::shader_option()},
                          reference_options(),
                          apps::common_options()})};
}

/// A picture in a pipe: one, whole, and nothing else beside it.
void check_standard_output(const Run& run, std::size_t pictures) {
    for (const char* const other : {"json", "stats", "watch", "ref", "reference"})
        if (run.given.has(other))
            throw Error(ErrorCode::usage, "-o - and --" + std::string(other) + " exclude each other");
    if (pictures > 1)
        throw Error(ErrorCode::usage, "only one picture can go to standard output", {},
                    "--as-one puts models into one");
    if (isatty(STDOUT_FILENO))
        throw Error(ErrorCode::usage, "standard output is a terminal", {}, "pipe the picture on, or write -o FILE");
}

/// The name of a picture on standard output, which says its format.
std::string standard_output_name(const Run& run) {
    const std::string& output = run.picture.output;
    const std::string format = output == "-" ? picture_format(run) : output.substr(0, output.size() - 2);
    return "standard output." + (format.empty() ? "png" : format);
}

PictureResult draw_to_standard_output(const PictureRequest& request, Context& context) {
    std::vector<std::byte> file;
    const PictureResult result = render_picture(request, file, context);
    print_data({reinterpret_cast<const char*>(file.data()), file.size()});
    return result;
}

/// Draws all once. @param watched  what they were made of; null: unused
int draw_all(const Run& run, int frame, apps::WatchedFiles* watched) {
    check_picture_name(run);
    const auto started = apps::WatchedFiles::Time::clock::now();
    std::vector<InputRequest> requests = picture_requests(run, frame);
    *run.files = {.of = requests.size()};
    const bool is_piped = is_standard_output(run.picture.output);
    if (is_piped) check_standard_output(run, requests.size());
    for (InputRequest& input : requests) {
        input.picture.keep_partial = run.given.has("keep-partial");
        if (is_piped) input.picture.output = standard_output_name(run);
    }
    check_requests(requests);
    References references(run, requests);
    std::vector<PictureRow> rows;
    int worst = 0;
    for (const InputRequest& input : requests) {
        const PictureRequest& request = input.picture;
        PictureRow& row = rows.emplace_back();
        row.result = {.file = request.input, .output = request.output};
        if (CancelOnInterrupt::happened()) {
            row.error = Error(ErrorCode::failed, "cancelled").with_file(request.input);
            continue;
        }
        const auto began = apps::WatchedFiles::Time::clock::now();
        const auto watch = [&](const std::vector<std::string>& files) {
            if (watched) watched->add(files, began);
        };
        if (watched && watched->count() == 0) watched->begin(request.input);
        watch({request.input});
        watch(request.load.joined);
        for (const std::string& shader : {request.settings.lighting_name, request.settings.vertex_name})
            if (watched && !shader.empty()) watched->add({shader}, started);
        const int code = run_input(run, input, row, [&](Context& c) {
            try {
                row.result = is_piped ? draw_to_standard_output(request, c) : render_picture(request, c);
                if (request.keep_partial && c.cancelled()) CancelOnInterrupt::words_are_said();  // by a remark
            } catch (...) {
                watch(c.files());
                throw;
            }
            watch(c.files());
            references.check(rows.size() - 1, row, c);
        });
        if (code == 0) print_note(summary(row.result), run.loudness);
        if (code == 0 && run.given.has("stats") && !run.is_json) print_text(stats_text(row.result));
        worst = std::max({worst, code, references.print_failure(row)});
    }
    references.finish(rows);
    if (run.is_json) print_data(to_json(rows));
    return worst;
}

int run_render(const Run& run) {
    if (asks_sequence(run)) return run_sequence(run);
    if (run.given.has("keep-partial")) CancelOnInterrupt::let_finish();
    if (!run.given.has("watch")) return draw_all(run, 1, nullptr);
    apps::WatchedFiles watched(SIZE_MAX);
    for (int frame = 1;; ++frame) {
        const int code = draw_all(run, frame, &watched);
        if (CancelOnInterrupt::happened()) return code;
        const std::size_t count = watched.count();
        if (frame == 1)
            print_message(
                "watching " + counted(count, "file") + ": pictures are drawn again when one changes, until Ctrl+C",
                run.loudness);
        CancelOnInterrupt::stand_by();
        const std::string changed = watched.wait();
        print_message(one_line(changed, 160) + " has changed: drawing again", run.loudness);
    }
}

}  // namespace

const Verb render_verb = {render_command, run_render};

}  // namespace rakelight::cli
