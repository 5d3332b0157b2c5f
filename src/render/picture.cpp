// SPDX-License-Identifier: Apache-2.0
// Single pictures: load -> decide (clips, look, camera, lights) -> draw to a target (engine, tone curve, overlays, files).
#include <cstdio>
#include <new>
#include <utility>

#include <rakelight/scene/validate.h>

#include "render/check_request.h"
#include "render/draw_shot.h"
#include "render/picture.h"
#include "render/remarks/too_dark_or_bright.h"
#include "render/stopwatch.h"

namespace rakelight {
namespace {

/// @param draw  with a session of the engine that is requested; errors get the name of the model
template <class Draw>
PictureResult drawn_by(const PictureRequest& request, const Draw& draw) {
    try {
        Session session(request.engine);
        return draw(session);
    } catch (const std::bad_alloc&) {
        throw Error(ErrorCode::failed, "out of memory").with_file(request.input);
    } catch (const Error& error) {
        throw error.with_file(request.input);
    }
}

/// What the scales of PNG channels mean.
std::string text_of(const ChannelRange& r) {
    char text[240];
    std::snprintf(text, sizeof text,
                  "PNG channels: depth from %.6g m (white) to %.6g m (dark gray), position from %.6g,%.6g,%.6g to "
                  "%.6g,%.6g,%.6g m (0 to 1 in red, green, blue)",
                  r.depth_low, r.depth_high, r.low.x, r.low.y, r.low.z, r.high.x, r.high.y, r.high.z);
    return text;
}

/// What is seen in the picture.
void remark_on(const PictureRequest& request, const Scene& drawn, const PictureResult& result, Context& context) {
    if (request.settings.channels && (request.channel_files & channel_files_png))
        context.report().add(Remark::note, request.input, "", text_of(result.channel_range));
    const bool is_whole = result.done == 1 && request.settings.colors && !context.cancelled();
    if (is_whole &&
        result.stats.pixels_shaded + result.stats.pixels_marked == 0)  // blended surfaces cover nothing, but are seen
        context.report().add(Remark::warning, request.input, "", "no pixel of the picture shows the model");
    remark_extremes(drawn, request, result, context.report());
}

/// One picture, from its scene to the remarks about it.
class Drawing {
public:
    Drawing(Session& session, PictureRequest& request, PictureTarget& target, Context& context)
        : session_(session), request_(request), target_(target), context_(context) {
        if (request.motion.time_s) request.settings.shader_time_s = *request.motion.time_s;
        context.progress("prepare", 0);
    }
    ShotOptions options() const { return {.is_linear = target_.is_linear()}; }
    PictureResult draw(Shot shot) {
        PictureResult result{.file = request_.input, .output = request_.output, .prepare_ms = watch_.lap_ms()};
        context_.progress("render", 0);
        draw_shot(session_, std::move(shot), request_, target_, nullptr, result, context_);
        remark_on(request_, session_.engine().scene(), result, context_);
        return result;
    }

private:
    Session& session_;
    PictureRequest& request_;
    PictureTarget& target_;
    Context& context_;
    Stopwatch watch_;
};

}  // namespace

PictureResult draw_picture(Session& session, Scene loaded, PictureRequest& request, PictureTarget& target,
                           const ChangeScene& change, Context& context) {
    Drawing drawing(session, request, target, context);
    return drawing.draw(decide_single(session, std::move(loaded), request, change, drawing.options(), context));
}

PictureResult draw_moment(Scene moment, const PictureRequest& asked, PictureRequest& request, PictureTarget& target,
                          Context& context) {
    return drawn_by(request, [&](Session& session) {
        Drawing drawing(session, request, target, context);
        return drawing.draw(decide_moment(session, std::move(moment), asked, request, drawing.options(), context));
    });
}

namespace {

PictureResult load_and_draw(PictureRequest request, PictureTarget& target, const ChangeScene& change,
                            Context& context) {
    return drawn_by(request, [&](Session& session) {
        const Stopwatch watch;
        Scene loaded = load(request.input, request.load, context);
        const double load_ms = watch.ms();
        PictureResult result = draw_picture(session, std::move(loaded), request, target, change, context);
        result.load_ms = load_ms;
        return result;
    });
}

}  // namespace

PictureResult render_picture(const PictureRequest& request, Context& context) {
    check_request(request);
    FileTarget target(request);
    return load_and_draw(request, target, {}, context);
}

PictureResult render_picture(const Scene& scene, const PictureRequest& asked, Context& context) {
    check_request(asked);
    return drawn_by(asked, [&](Session& session) {
        validate(scene);
        PictureRequest request = asked;
        FileTarget target(request);
        return draw_picture(session, scene, request, target, {}, context);
    });
}

PictureResult render_changed(const PictureRequest& request, const ChangeScene& change, std::vector<std::byte>& file,
                             Context& context) {
    check_request(request);
    const bool is_in_layers = request.channel_files == channel_files_layers && is_exr(request.output);
    if (request.settings.channels != 0 && !is_in_layers)
        throw Error(ErrorCode::usage, "is for pictures in files: data channels are written to files beside them", {},
                    "write the picture to a file, or as exr with 'channel-files' layers")
            .about("channels", {"channel-files"});
    FileTarget target(request, &file);
    return load_and_draw(request, target, change, context);
}

PictureResult render_picture(const PictureRequest& request, std::vector<std::byte>& file, Context& context) {
    return render_changed(request, {}, file, context);
}

PictureResult render_picture(const PictureRequest& asked, Pixels& color, Context& context) {
    PictureRequest request = asked;
    request.output.clear();
    request.settings.channels = 0;
    check_drawing(request);
    PixelsTarget target(color);
    return load_and_draw(std::move(request), target, {}, context);
}

}  // namespace rakelight
