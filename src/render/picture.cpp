// SPDX-License-Identifier: Apache-2.0
// The whole way of one picture: load -> prepare -> camera and lights -> engine -> files, strip by strip.
#include <algorithm>
#include <cstdio>
#include <new>

#include "engines/check_settings.h"
#include "engines/empty_pixel.h"
#include "math/linear.h"
#include "render/check_request.h"
#include "render/choose_camera.h"
#include "render/draw_to_memory.h"
#include "render/drawable.h"
#include "render/engines.h"
#include "render/lit_scenes.h"
#include "render/look.h"
#include "render/overlay.h"
#include "render/picture_files.h"
#include "render/picture_lights.h"
#include "render/picture_steps.h"
#include "render/prepared_scene.h"
#include "render/render_changed.h"
#include "render/stopwatch.h"
#include "render/too_dark_or_bright.h"
#include "scene/scene_tools.h"

namespace rakelight {
namespace {

std::uint64_t count_objects(const Scene& scene) {
    return std::uint64_t(
        std::count_if(scene.nodes.begin(), scene.nodes.end(), [](const Node& n) { return !n.meshes.empty(); }));
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

void note_drawn(const Window& window, const ExtremePixels& extremes, PictureResult& result) {
    result.width = window.width;
    result.height = window.height;
    result.black_pixels = extremes.black(), result.white_pixels = extremes.white();
}

}  // namespace

void count_parts(const Scene& prepared, PictureResult& result) {
    result.triangles = triangle_count(prepared);
    result.objects = count_objects(prepared);
}

ReadyScene ready_scene(Scene scene, const PictureRequest& request, Context& context, RadiosityReport* report) {
    check_drawable(scene);
    warn_of_unknown_names(scene, request.settings, context.report());
    const double aspect = double(request.settings.width) / double(request.settings.height);
    const Camera camera = valid::choose_camera(scene, request.view, aspect, request.settings.visibility, context);
    scene.lights = lights_of_picture(scene, request, camera, context.report());
    scene.fog = request.fog.value_or(scene.fog);
    validate(scene);  // what the request has put into it
    ReadyScene ready{.camera = camera, .lights = scene.lights};
    ready.prepared = make_prepared(std::move(scene), request.prepare, request.settings, context);
    PreparedScene& prepared = *ready.prepared;
    if (request.settings.method == RayMethod::radiosity) {
        prepared.bound.reset();  // other poses have other light
        Scene posed = prepared.posed(context);
        prepared.poses.reset(), prepared.posed_.forget();
        prepared.scene = lit_by_radiosity(std::move(posed), request.settings.radiosity, context, report);
    }
    return ready;
}

namespace {

/// The overlay of the picture, if any. Depths are then requested if it needs them.
/// @param range  what is shown; of a sequence by all of its pictures
std::optional<Overlay> overlay_of(const PictureRequest& request, const ChannelRange& range, Session& session,
                                  Shot& shot, Context& context) {
    if (!request.has_overlays()) return {};
    const std::shared_ptr<const PreparedScene> prepared = session.prepared_for(shot, context);
    const Bounds shown = range.low == range.high ? Bounds{} : Bounds{range.low, range.high};
    const Camera camera = camera_in_world(prepared->scene, shot.camera, aspect_of(shot.settings));
    Overlay overlay(request, prepared->posed(context), camera, shown);
    if (overlay.needs_depth()) shot.settings.channels |= channel_depth;
    return overlay;
}

void keep_depth_for(const std::optional<Overlay>& overlay, const RenderSettings& asked, PictureSink& sink) {
    if (overlay && overlay->needs_depth()) sink.keep_depth(!(asked.channels & channel_depth));
}

/// @param memory  where the colors' file goes; null: to its name
void draw_to_outputs(Session& session, const Shot& of, const PictureRequest& request, PictureResult& result,
                     std::vector<std::byte>* memory, Context& context) {
    Shot shot{of.camera, request.settings, of.lights};
    RenderSettings& settings = shot.settings;
    const Window window = whole_window(settings);
    const PixelFormat format = format_for(request.output, settings.background.w < 1);
    const vec4 behind = format.component == Component::u8 ? separate_background(settings, request.tone) : vec4{};
    const std::optional<Overlay> overlay = overlay_of(request, result.channel_range, session, shot, context);
    PictureFiles files(request.output, window.width, window.height, format,
                       {request.settings.channels, request.channel_files, request.half_colors, result.channel_range,
                        comment_of(settings), memory},
                       {window.x, window.y, settings.width, settings.height});
    double written_ms = 0;
    PictureSink sink(format, ToneCurve(request.tone, behind));
    sink.keep_strips(files.needs_linear(), [&](int rows) {
        const Stopwatch watch;
        if (overlay) overlay->draw(sink.color_rows(rows), context);
        if (overlay && files.needs_linear()) overlay->draw(sink.linear_rows(rows), context);
        files.write(sink, rows);
        written_ms += watch.ms();
    });
    keep_depth_for(overlay, request.settings, sink);
    ExtremePixels extremes;
    sink.count_in(&extremes);
    if (request.keep_partial) sink.expect_gaps(empty_pixel(settings));
    Stopwatch drawing;
    try {
        result.stats = session.render(shot, sink, context);
        context.throw_if_cancelled();
    } catch (const Error&) {
        if (!request.keep_partial || !context.cancelled() || sink.done() == 0) throw;
        result.done = sink.done();
        char text[120] = "the picture was cancelled: some of its samples are missing";
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
    context.progress("write", 0);
    files.finish();
    result.write_ms += watch.ms();
    note_drawn(window, extremes, result);
    result.channel_files = files.channel_names();
}

}  // namespace

void draw_to_files(Session& session, const Shot& shot, const PictureRequest& request, PictureResult& result,
                   Context& context) {
    draw_to_outputs(session, shot, request, result, nullptr, context);
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

void draw_to_memory(Session& session, const Shot& of, const PictureRequest& request, PictureResult& result,
                    Pixels& color, Context& context) {
    const Window window = whole_window(request.settings);
    const PixelFormat format{Component::u8, request.settings.background.w < 1 ? 4 : 3};
    color = {window.width, window.height, format.channels, format.component, false, {}};
    color.charge = share(
        MemoryCharge(context.memory(), std::uint64_t(color.row_bytes()) * std::uint64_t(window.height), "the picture"));
    Shot shot{of.camera, request.settings, of.lights};
    const vec4 behind = separate_background(shot.settings, request.tone);
    const std::optional<Overlay> overlay = overlay_of(request, result.channel_range, session, shot, context);
    PictureSink sink(format, ToneCurve(request.tone, behind));
    keep_depth_for(overlay, request.settings, sink);
    ExtremePixels extremes;
    sink.count_in(&extremes);
    Stopwatch drawing;
    result.stats = session.render(shot, sink, context);
    result.render_ms += drawing.lap_ms();
    context.throw_if_cancelled();
    if (overlay) overlay->draw(sink.color_rows(window.height), context);
    color.bytes = sink.take_colors();
    note_drawn(window, extremes, result);
}

namespace {

/// Prepares a loaded scene, draws it and checks the picture.
/// @param draw  with the session, the shot and the result that it completes
template <class Draw>
PictureResult draw_loaded(Scene loaded, PictureRequest request, Session& session, Context& context, const Draw& draw) {
    PictureResult result{.file = request.input, .output = request.output};
    if (request.motion.time_s) request.settings.shader_time_s = *request.motion.time_s;
    warn_of_unused(request, context.report());
    Stopwatch watch;
    context.progress("prepare", 0);
    ReadyScene ready = ready_scene(std::move(loaded), request, context);
    const Shot shot = ready.shot();
    result.channel_range = channel_range_of(world_bounds(ready.prepared->posed(context)), shot.camera);
    count_parts(ready.prepared->scene, result);
    give(session, std::move(ready.prepared));
    result.prepare_ms = watch.lap_ms();

    context.progress("render", 0);
    adjust_to_picture(request, session, shot, context);
    draw(session, shot, request, result);
    if (request.settings.channels && (request.channel_files & channel_files_png))
        context.report().add(Remark::note, request.input, "", text_of(result.channel_range));
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
                       [&](Session& engine, const Shot& shot, const PictureRequest& looked, PictureResult& result) {
                           draw_to_files(engine, shot, looked, result, context);
                       });
}

namespace {

/// @param draw  with a session of the engine that is requested
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

PictureResult render_changed(const PictureRequest& asked, const std::function<Scene(Scene)>& change,
                             std::vector<std::byte>& file, Context& context) {
    check_request(asked);
    const bool is_in_layers = asked.channel_files == channel_files_layers && is_exr(asked.output);
    if (asked.settings.channels != 0 && !is_in_layers)
        throw Error(ErrorCode::usage, "is for pictures in files: data channels are written to files beside them", {},
                    "write the picture to a file, or as exr with 'channel-files' layers")
            .about("channels", {"channel-files"});
    PictureRequest request = asked;
    return picture_by(request, context, [&](Session& session) {
        Scene loaded = change(loaded_as_asked(request, context));
        return draw_loaded(std::move(loaded), request, session, context,
                           [&](Session& engine, const Shot& shot, const PictureRequest& looked, PictureResult& result) {
                               draw_to_outputs(engine, shot, looked, result, &file, context);
                           });
    });
}

PictureResult render_picture(const PictureRequest& request, std::vector<std::byte>& file, Context& context) {
    return render_changed(
        request, [](Scene scene) { return scene; }, file, context);
}

PictureRequest draw_to_pixels(Scene loaded, const PictureRequest& request, Pixels& color, Context& context) {
    PictureRequest shown = request;
    picture_by(request, context, [&](Session& session) {
        return draw_loaded(std::move(loaded), request, session, context,
                           [&](Session& engine, const Shot& shot, const PictureRequest& looked, PictureResult& result) {
                               draw_to_memory(engine, shot, looked, result, color, context);
                               shown = looked;
                           });
    });
    return shown;
}

PictureResult render_picture(const PictureRequest& asked, Pixels& color, Context& context) {
    PictureRequest request = asked;
    request.output.clear();
    request.settings.channels = 0;
    check_drawing(request);
    return picture_by(request, context, [&](Session& session) {
        Scene loaded = loaded_as_asked(request, context);
        return draw_loaded(std::move(loaded), request, session, context,
                           [&](Session& engine, const Shot& shot, const PictureRequest& looked, PictureResult& result) {
                               draw_to_memory(engine, shot, looked, result, color, context);
                           });
    });
}

}  // namespace rakelight
