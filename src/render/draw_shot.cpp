// SPDX-License-Identifier: Apache-2.0
#include "render/draw_shot.h"

#include <rakelight/base/report.h>
#include <rakelight/scene/scene_queries.h>

#include <algorithm>
#include <cstdio>

#include "engines/empty_pixel.h"
#include "render/engines.h"
#include "render/output/overlay.h"
#include "render/prepared_scene.h"
#include "render/stopwatch.h"
#include "scene/drawn_vertices.h"
#include "scene/placement.h"

namespace rakelight {
namespace {

std::uint64_t count_objects(const Scene& scene) {
    return std::uint64_t(
        std::count_if(scene.nodes.begin(), scene.nodes.end(), [](const Node& n) { return !n.meshes.empty(); }));
}

/// What was drawn, and by which engine.
void describe_drawn(const Session& session, const Window& window, const ExtremePixels& extremes,
                    PictureResult& result) {
    result.engine = session.engine().name(), result.isa = engine_isa(result.engine);
    result.width = window.width, result.height = window.height;
    result.black_pixels = extremes.black(), result.white_pixels = extremes.white();
}

/// What the engine has got for the shot.
void describe_scene(const Session& session, const Shot& shot, const ChannelRange* range, PictureResult& result) {
    const Scene& scene = session.engine().scene();
    result.triangles = triangle_count(scene);
    result.objects = count_objects(scene);
    result.channel_range = range ? *range : channel_range_of(world_bounds(scene), shot.camera);
}

/// The overlay of the picture, if any.
std::optional<Overlay> overlay_of(const PictureRequest& request, const ChannelRange& range, Session& session,
                                  const Shot& shot, Context& context) {
    if (!request.has_overlays()) return {};
    const std::shared_ptr<const PreparedScene> prepared = session.prepared_for(shot, context);
    const Camera camera = camera_in_world(prepared->scene, shot.camera, aspect_of(shot.settings));
    return Overlay(request, prepared->posed(context), camera,
                   range.low == range.high ? Bounds{} : Bounds{range.low, range.high});
}

void warn_of_partial(double done, const std::string& output, Report& report) {
    char text[120] = "the picture was cancelled: some of its samples are missing";
    if (done < 1)
        std::snprintf(text, sizeof text,
                      "the picture was cancelled: %.1f %% of its pixels are there, the rest is the background",
                      100 * done);
    report.add(Remark::warning, output, "", text);
}

/// @return whether the picture is whole; else it was cancelled and is kept
bool render(Session& session, const Shot& shot, bool keeps_partial, PictureSink& sink, RenderStats& stats,
            Context& context) {
    if (keeps_partial) sink.expect_gaps(empty_pixel(shot.settings));
    try {
        stats = session.render(shot, sink, context);
        context.throw_if_cancelled();
        return true;
    } catch (const Error&) {
        if (!keeps_partial || !context.cancelled() || sink.done() == 0) throw;
        return false;
    }
}

}  // namespace

void draw_shot(Session& session, Shot shot, const PictureRequest& request, PictureTarget& target,
               const ChannelRange* range, PictureResult& result, Context& context) {
    Stopwatch watch;
    session.warm_up(shot, context);
    describe_scene(session, shot, range, result);
    const std::optional<Overlay> overlay = overlay_of(request, result.channel_range, session, shot, context);
    const bool keeps_depth = overlay && overlay->needs_depth(),
               hides_depth = keeps_depth && !(shot.settings.channels & channel_depth);
    target.open(shot.settings, result.channel_range, context);
    if (keeps_depth) shot.settings.channels |= channel_depth;
    result.prepare_ms += watch.lap_ms();

    double written_ms = 0;
    PictureSink sink(target.format(shot.settings), ToneCurve(request.tone, shot.behind));
    const auto deliver = [&](int rows) {
        const Stopwatch delivery;
        if (overlay) overlay->draw(sink.color_rows(rows), context);
        if (overlay && target.needs_linear()) overlay->draw(sink.linear_rows(rows), context);
        target.write(sink, rows);
        written_ms += delivery.ms();
    };
    if (!target.takes_whole()) sink.keep_strips(target.needs_linear(), deliver);
    if (keeps_depth) sink.keep_depth(hides_depth);
    ExtremePixels extremes;
    sink.count_in(&extremes);
    if (!render(session, shot, request.keep_partial, sink, result.stats, context)) {
        result.done = sink.done();
        warn_of_partial(result.done, request.output, context.report());
        sink.finish_partial();
    }
    const Window window = whole_window(shot.settings);
    if (target.takes_whole()) deliver(window.height);
    result.render_ms += watch.lap_ms() - written_ms;
    context.progress("write", 0);
    result.channel_files = target.finish();
    result.write_ms += written_ms + watch.lap_ms();
    describe_drawn(session, window, extremes, result);
    result.threads = context.threads();
}

}  // namespace rakelight
