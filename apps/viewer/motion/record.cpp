// SPDX-License-Identifier: Apache-2.0
#include "record.h"

#include <cstdio>
#include <filesystem>

#include <rakelight/math/linear.h>
#include <rakelight/render/render.h>
#include <rakelight/render/shot.h>

#include "../view/studio.h"

namespace rakelight::viewer {
namespace {

namespace fs = std::filesystem;

void make_folder(const std::string& folder) {
    std::error_code fault;
    if (!fs::create_directory(folder, fault) && !fault) fault = std::make_error_code(std::errc::file_exists);
    if (fault) throw Error(ErrorCode::failed, "the folder cannot be made: " + fault.message()).with_file(folder);
}

}  // namespace

Look turned(const Look& look, const Model& model, int width, int height, double angle_rad) {
    if (angle_rad == 0) return look;
    Look out = look;
    go_around(moving_eye(out, model, width, height), angle_rad, look.world_up);
    carry_lights(out, camera_of(look, model, width, height), camera_of(out, model, width, height));
    return out;
}

Turn record_turn(const std::shared_ptr<const Model>& model, const Look& look, int width, int height, int count,
                 const std::string& folder, Context& context) {
    Turn turn{.count = count};
    make_folder(folder);
    Studio studio;
    try {
        for (; turn.written < count; ++turn.written) {
            const double done = double(turn.written) / count;
            context.throw_if_cancelled();
            context.set_progress_range(done, double(turn.written + 1) / count);
            context.progress("record", 0);
            const Look now = turned(look, *model, width, height, 2 * pi * done);
            const PictureRequest request = request_of(now, width, height);
            const Shot shot = studio.plan(model, now, request, camera_of(now, *model, width, height), context);
            Frame frame;
            studio.draw(shot, 0, frame, context);
            char name[32];
            std::snprintf(name, sizeof name, "%04d.png", turn.written + 1);
            save(frame, (fs::path(folder) / name).string(), request.tone, shot.behind);
        }
    } catch (const Error&) {
        std::error_code ignored;
        if (turn.written == 0) fs::remove(folder, ignored);
        if (!context.cancelled()) throw;
    }
    return turn;
}

std::string to_text(const Turn& turn, const std::string& folder) {
    const std::string count = std::to_string(turn.count);
    if (turn.written == turn.count) return "wrote " + count + " pictures to " + folder;
    if (turn.written == 0) return "cancelled: none of " + count + " pictures was made";
    return "cancelled: " + std::to_string(turn.written) + " of " + count + " pictures are in " + folder;
}

}  // namespace rakelight::viewer
