// SPDX-License-Identifier: Apache-2.0
// The whole way of one picture: load -> prepare -> camera and lights -> engine -> files, strip by strip.
#include <algorithm>
#include <cstdio>
#include <new>

#include "engines/check_settings.h"
#include "math/linear.h"
#include "render/drawable.h"
#include "render/engines.h"
#include "render/look.h"
#include "render/picture_files.h"
#include "render/picture_steps.h"
#include "render/prepared_scene.h"
#include "render/stopwatch.h"
#include "render/too_dark_or_bright.h"
#include "render/view.h"
#include "render/view_range.h"
#include "scene/light_cutoff.h"
#include "scene/scene_tools.h"

namespace rakelight {
namespace {

std::uint64_t count_objects(const Scene& scene) {
    return std::uint64_t(
        std::count_if(scene.nodes.begin(), scene.nodes.end(), [](const Node& n) { return !n.meshes.empty(); }));
}

/// What the scales of PNG channels mean.
std::string text_of(const ViewRange& r) {
    char text[240];
    std::snprintf(text, sizeof text,
                  "PNG channels: depth from %.6g m (white) to %.6g m (dark gray), position from %.6g,%.6g,%.6g to "
                  "%.6g,%.6g,%.6g m (0 to 1 in red, green, blue)",
                  r.depth_low, r.depth_high, r.low.x, r.low.y, r.low.z, r.high.x, r.high.y, r.high.z);
    return text;
}

/// What whoever gets the file has to know of its colors.
std::string comment_of(const RenderSettings& settings) {
    if (settings.method != RayMethod::path || !settings.paths.denoise) return {};
    return "rakelight: denoised by joint NL-means filtering (Rousselle, Manzi, Zwicker 2013)";
}

void note_drawn(const Window& window, const ExtremePixels& extremes, PictureResult& result) {
    result.width = window.width;
    result.height = window.height;
    result.black_pixels = extremes.black(), result.white_pixels = extremes.white();
}

}  // namespace

Scene with_lights(Scene scene, const PictureRequest& request, const Camera& camera) {
    scene.lights = chosen_lights(scene, request, camera);
    if (request.fog) scene.fog = *request.fog;
    return scene;
}

ReadyScene ready_scene(Scene scene, const PictureRequest& request, Context& context) {
    check_drawable(scene);
    warn_of_unknown_names(scene, request.settings, context.report());
    const double aspect = double(request.settings.width) / double(request.settings.height);
    const Camera camera = valid::choose_camera(scene, request.view, aspect, context);
    scene = with_lights(std::move(scene), request, camera);
    validate(scene);  // what the request has put into it
    if (request.light_cutoff > 0)
        context.report().add(Remark::note, scene.source, "",
                             said(cut_lights(scene.lights, request.light_cutoff), request.light_cutoff));
    ReadyScene ready{make_prepared(std::move(scene), request.prepare, request.settings, context), camera};
    ready.prepared->has_chosen_lights = true;
    return ready;
}

Window whole_window(const RenderSettings& s) {
    return s.window.width == 0 ? Window{0, 0, s.width, s.height} : s.window;
}

void draw_to_files(Session& session, const Camera& camera, const PictureRequest& request, PictureResult& result,
                   Context& context) {
    const RenderSettings& settings = request.settings;
    const Window window = whole_window(settings);
    const PixelFormat format = format_for(request.output, settings.background.w < 1);
    PictureFiles files(
        request.output, window.width, window.height, format,
        {settings.channels, request.channel_files, request.half_colors, result.view_range, comment_of(settings)},
        {window.x, window.y, settings.width, settings.height});
    double written_ms = 0;
    PictureSink sink(format, request.tone, files.needs_linear(), [&](int rows) {
        const Stopwatch watch;
        files.write(sink, rows);
        written_ms += watch.ms();
    });
    ExtremePixels extremes;
    sink.count_in(&extremes);
    if (request.keep_partial) sink.expect_gaps(settings.background);
    Stopwatch drawing;
    try {
        result.stats = session.render(camera, settings, sink, context);
        context.throw_if_cancelled();
    } catch (const Error&) {
        if (!request.keep_partial || !context.cancelled() || sink.done() == 0) throw;
        result.done = sink.done();
        char text[120] = "the picture was cancelled: it has not all of its samples";
        if (result.done < 1)
            std::snprintf(text, sizeof text,
                          "the picture was cancelled: %.1f %% of its pixels are there, the rest is the background",
                          100 * result.done);
        context.report().add(Remark::warning, request.output, "", text);
        sink.finish_partial();
    }
    result.render_ms += drawing.lap_ms() - written_ms;
    result.write_ms += written_ms;
    const Stopwatch watch;
    files.finish();
    result.write_ms += watch.ms();
    note_drawn(window, extremes, result);
    result.channel_files = files.channel_names();
}

PictureResult draw_picture(const PictureRequest& request, Session& session, Context& context) {
    Stopwatch watch;
    PictureRequest looked = request;
    Scene loaded = loaded_as_asked(looked, context);
    const double load_ms = watch.lap_ms();
    PictureResult result = draw_picture(std::move(loaded), looked, session, context);
    result.load_ms = load_ms;
    return result;
}

namespace {

/// As draw_to_files(), into memory.
void draw_to_memory(Session& session, const Camera& camera, const PictureRequest& request, PictureResult& result,
                    Pixels& color, Context& context) {
    const Window window = whole_window(request.settings);
    const PixelFormat format{Component::u8, request.settings.background.w < 1 ? 4 : 3};
    color = {window.width, window.height, format.channels, format.component, false, {}};
    color.charge = share(
        MemoryCharge(context.memory(), std::uint64_t(color.row_bytes()) * std::uint64_t(window.height), "the picture"));
    PictureSink sink(format, request.tone);
    ExtremePixels extremes;
    sink.count_in(&extremes);
    Stopwatch drawing;
    result.stats = session.render(camera, request.settings, sink, context);
    result.render_ms += drawing.lap_ms();
    context.throw_if_cancelled();
    color.bytes = sink.take_colors();
    note_drawn(window, extremes, result);
}

/// Prepares a scene that was loaded, draws it and looks at what was drawn.
/// @param draw  with the session, the camera and the result that it completes
template <class Draw>
PictureResult draw_loaded(Scene loaded, PictureRequest request, Session& session, Context& context, const Draw& draw) {
    PictureResult result{.file = request.input, .output = request.output};
    if (request.settings.method != RayMethod::path && request.settings.paths != PathSettings{})
        context.report().add(Remark::warning, request.input, "",
                             "seed, max-seconds, noise, clamp, denoise and light-sampling have no effect without the "
                             "method path",
                             {"method"});
    Stopwatch watch;
    context.progress("prepare", 0);
    auto [ready, camera] = ready_scene(std::move(loaded), request, context);
    result.view_range = view_range(ready->scene, camera);
    result.triangles = triangle_count(ready->scene);
    result.objects = count_objects(ready->scene);
    give(session, std::move(ready));
    result.prepare_ms = watch.lap_ms();

    context.progress("render", 0);
    adjust_to_picture(request, session, camera, context);
    draw(session, camera, request, result);
    if (request.settings.channels && (request.channel_files & channel_files_png))
        context.report().add(Remark::note, request.input, "", text_of(result.view_range));
    const bool is_whole = result.done == 1 && request.settings.colors && !context.cancelled();
    if (is_whole &&
        result.stats.pixels_shaded + result.stats.pixels_marked == 0)  // blended surfaces cover nothing, but are seen
        context.report().add(Remark::warning, request.input, "", "no pixel of the picture shows the model");
    remark_extremes(session.engine().scene(), request, result, context.report());
    return result;
}

}  // namespace

PictureResult draw_picture(Scene loaded, const PictureRequest& request, Session& session, Context& context) {
    return draw_loaded(std::move(loaded), request, session, context,
                       [&](Session& engine, const Camera& camera, const PictureRequest& looked, PictureResult& result) {
                           draw_to_files(engine, camera, looked, result, context);
                       });
}

namespace {

/// @param draw  with a session of the engine that is asked for
template <class Draw>
PictureResult picture_by(const PictureRequest& request, Context& context, const Draw& draw) {
    try {
        Session session(request.engine);
        PictureResult result = draw(session);
        result.engine = session.engine().name();
        result.isa = engine_isa(session.engine().name());
        result.threads = context.threads();
        return result;
    } catch (const std::bad_alloc&) {
        throw Error(ErrorCode::failed, "out of memory").with_file(request.input);
    } catch (const Error& error) {
        throw error.with_file(request.input);
    }
}

}  // namespace

PictureResult render_picture(const PictureRequest& request, Context& context) {
    check_request(request);
    return picture_by(request, context, [&](Session& session) { return draw_picture(request, session, context); });
}

PictureResult render_picture(const Scene& scene, const PictureRequest& request, Context& context) {
    check_request(request);
    return picture_by(request, context, [&](Session& session) {
        validate(scene);
        PictureRequest looked = request;
        Scene asked = looked_as_asked(scene, looked, context);
        return draw_picture(std::move(asked), looked, session, context);
    });
}

PictureResult render_picture(const PictureRequest& asked, Pixels& color, Context& context) {
    PictureRequest request = asked;
    request.output.clear();
    request.settings.channels = 0;
    check_drawing(request);
    return picture_by(request, context, [&](Session& session) {
        Scene loaded = loaded_as_asked(request, context);
        return draw_loaded(
            std::move(loaded), request, session, context,
            [&](Session& engine, const Camera& camera, const PictureRequest& looked, PictureResult& result) {
                draw_to_memory(engine, camera, looked, result, color, context);
            });
    });
}

}  // namespace rakelight
