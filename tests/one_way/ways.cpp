// SPDX-License-Identifier: Apache-2.0
#include "one_way/ways.h"

#include <stdexcept>
#include <thread>

#include <rakelight/math/linear.h>
#include <rakelight/render/picture.h>
#include <rakelight/render/sequence.h>
#include <rakelight/render/shot.h>

#include "../../apps/viewer/background/load_model.h"
#include "io/files/file.h"
#include "io/pictures/image_io.h"

namespace rakelight::test {
namespace {

Shown shown(const Pixels& pixels) {
    Shown out{pixels.width, pixels.height, {}};
    const std::size_t channels = std::size_t(pixels.channels);
    for (std::size_t i = 0; i + channels <= pixels.bytes.size(); i += channels) {
        const auto at = [&](std::size_t c) { return std::to_integer<std::uint32_t>(pixels.bytes[i + c]); };
        out.codes.push_back((channels == 4 ? at(3) << 24 : 0xff000000u) | at(0) | at(1) << 8 | at(2) << 16);
    }
    return out;
}

}  // namespace

Shown by_picture(const PictureRequest& asked, std::optional<double> time_s, Context& context) {
    PictureRequest request = asked;
    if (!request.motion.time_s) request.motion.time_s = time_s;
    Pixels pixels;
    render_picture(request, pixels, context);
    return shown(pixels);
}

std::vector<Shown> by_sequence(PictureRequest request, double step_s, std::size_t count, const std::string& folder,
                               Context& context) {
    request.output = folder + "/{frame}.png";
    render_sequence({.picture = request, .frames = {0, std::int64_t(count) - 1, 1}, .fps = 1 / step_s}, context);
    std::vector<Shown> all;
    for (std::size_t i = 0; i < count; ++i) {
        const auto bytes = io::read_file(folder + "/" + std::to_string(i) + ".png", context);
        all.push_back(shown(io::decode_image(*bytes, context)));
    }
    return all;
}

Shown BySession::draw(const PictureRequest& asked, std::optional<double> time_s, Context& context) {
    PictureRequest request = asked;
    if (!request.motion.time_s) request.motion.time_s = time_s;
    request.settings.shader_time_s = request.motion.time_s.value_or(0);
    if (!loaded_) loaded_ = std::make_shared<const Scene>(load(request.input, request.load, context));
    Session& session = sessions_.try_emplace(request.engine, request.engine).first->second;
    const std::vector<ClipTime> clips = clips_of(*loaded_, request.motion);
    const ShotOptions options{.is_view = true};
    Shot shot;
    if (asked_ == asked) {
        decided_->motion = request.motion, decided_->settings.shader_time_s = request.settings.shader_time_s;
        const Scene& shown = session.show(loaded_, *decided_, clips, context);
        const double aspect = double(request.settings.width) / double(request.settings.height);
        const Camera camera = choose_camera(shown, decided_->view, aspect, decided_->settings.visibility, context);
        shot = plan_shot(shown, *decided_, camera, options, context);
    } else {
        decided_ = request;
        shot = decide(session, loaded_, *decided_, clips, {}, options, context);
        asked_ = asked;
    }
    Frame frame;
    session.render(shot, frame, context);
    return {frame.window.width, frame.window.height, to_srgb8(frame, request.tone, shot.behind)};
}

ByViewer::ByViewer(const std::string& file, Context& context) {
    viewer::Start start{.settings = {{.key = "look", .words = {"plain"}}}, .load = {.allow_shaders = true}};
    start.takes = [](std::string_view) { return true; };
    model_ = viewer::load_model(file, start, context);
}

Shown ByViewer::draw(const PictureRequest& request, std::optional<double> time_s) {
    viewer::Look look = viewer::first_look(*model_);
    look.request = request;
    if (!look.request.motion.time_s) look.request.motion.time_s = time_s;
    const RenderSettings& s = request.settings;
    painter_.paint({.model = model_, .look = look, .width = s.width, .height = s.height, .number = ++number_});
    for (;;) {
        if (const auto painting = painter_.take(); painting && painting->is_final)
            return {painting->width, painting->height, painting->codes};
        if (const auto fault = painter_.take_fault()) throw fault->error;
        std::this_thread::yield();
    }
}

}  // namespace rakelight::test
