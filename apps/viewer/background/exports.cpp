// SPDX-License-Identifier: Apache-2.0
#include "exports.h"

#include <cstdio>

#include <rakelight/render/render.h>
#include <rakelight/tools/smooth_file.h>

#include "../document/display_path.h"
#include "../document/gather.h"
#include "../document/materials.h"
#include "../document/save.h"
#include "../motion/record.h"

namespace rakelight::viewer {

Exports::Exports(const Start& start, std::function<void()> wake, UiState& ui)
    : ui_(ui), writer_(std::move(wake), start.threads, start.max_memory, start.everything) {}

/// @param work  gives what is to be said when it is done
void Exports::write(const std::string& title, std::function<std::string(Context&)> work) {
    const auto run = [this, work = std::move(work)](Context& context) -> Background::Finish {
        try {
            return [this, text = work(context)] { ui_.say(with_not_begun(text)); };
        } catch (const Error& error) {
            if (context.cancelled()) throw;
            has_lost_file_ = true;
            std::fprintf(stderr, "rakelight: error: %s\n",
                         error.what());  // the window may close before it is read there
            throw;
        }
    };
    writer_.queue(title, run, [this](const Error& error) {
        ui_.report(error);
        ui_.message.fail(with_not_begun(ui_.message.text()));
    });
}

/// After a cancel: how much was not even begun.
std::string Exports::with_not_begun(const std::string& text) {
    const std::size_t count = std::exchange(not_begun_, 0);
    if (count == 0) return text;
    return text + "; " + std::to_string(count) + " more not begun";
}

/// Files are of one picture: which of two.
std::string Exports::shown_half() const {
    if (ui_.split == Split::none) return {};
    return ui_.active == 0 ? " (picture A alone)" : " (picture B alone)";
}

void Exports::give_up() {
    if (!writer_.is_running()) return;
    has_lost_file_ = true;
    std::fprintf(stderr, "rakelight: error: ended before all files were written\n");
}

void Exports::write_picture(const Shown& shown, bool is_transparent) {
    PictureRequest request = request_of(shown.look, shown.width, shown.height);
    if (is_transparent) request.settings.background = {0, 0, 0, 0};
    if (shown.look.channel) request.settings.channels = shown.look.channel, request.channel_files = channel_files_png;
    write("screenshot", [shown, request, which = shown_half()](Context& context) {
        PictureRequest named = request;
        named.output = free_name(shown.model->file, "", ".png");
        const PictureResult result =
            render_picture(with_edits(shown.model->scene, shown.look.materials, context), named, context);
        return "wrote " + short_path(result.channel_files.empty() ? result.output : result.channel_files.back()) +
               which;
    });
}

void Exports::save_scene(const Shown& shown) {
    write("save", [shown, which = shown_half()](Context&) {
        const std::string path = free_world_name(shown.model->file), missing = not_saved(shown.look);
        const WorldFile world = world_of(shown.look, *shown.model, shown.width, shown.height, path);
        const std::size_t copies = save_with_files(world, path);
        const std::string with = copies == 0   ? ""
                                 : copies == 1 ? " with a copy of a file"
                                               : " with copies of " + std::to_string(copies) + " files";
        return "wrote " + short_path(path) + which + with + (missing.empty() ? "" : "; not in it: " + missing);
    });
}

void Exports::save_seamless(const Shown& shown) {
    const PictureRequest& request = shown.look.request;
    SmoothFileOptions options{.load = request.load};
    options.attributes.crease_angle_rad = request.prepare.crease_angle_rad;
    options.attributes.creases = request.prepare.creases;
    options.attributes.weight = request.prepare.weight;
    options.border_distance = request.prepare.border_distance;
    write("save seamless", [file = shown.model->file, options](Context& context) {
        return with_short_paths(summary(smooth_file(file, free_seamless_name(file), options, context)));
    });
}

void Exports::record(const Shown& shown) {
    write("record", [shown, count = ui_.record_frames](Context& context) {
        const std::string folder = free_name(shown.model->file, "-turn", "");
        const Turn turn = record_turn(shown.model, shown.look, shown.width, shown.height, count, folder, context);
        return to_text(turn, short_path(folder)) + (shown.look.channel ? ", in colors: channels are not recorded" : "");
    });
}

std::optional<std::string> Exports::command_line(const Shown& shown) {
    try {
        std::string line = command_line_of(shown.look, *shown.model, shown.width, shown.height);
        const std::string missing = not_on_command_line(shown.look, *shown.model);
        ui_.say(missing.empty()
                    ? "copied the command line"
                    : "copied the command line, but for " + missing + ": save the scene to keep these (Ctrl+S)");
        return line;
    } catch (const Error& error) {
        ui_.report(error);
        return {};
    }
}

}  // namespace rakelight::viewer
