// SPDX-License-Identifier: Apache-2.0
// Facade: smooth, render, save.
#include <algorithm>

#include <rakelight/picture.h>

#include "engines/check_settings.h"
#include "math/linear.h"
#include "prepare/prepare.h"
#include "render/drawable.h"
#include "render/height_maps.h"
#include "render/picture_files.h"
#include "render/picture_steps.h"
#include "render/view.h"
#include "scene/scene_tools.h"

namespace rakelight {
namespace {

double aspect_of(const RenderSettings& s) { return double(s.width) / double(s.height); }

/// The camera placed in the world, so that an engine needs no node for it.
Camera in_world(const Scene& scene, Camera camera, double aspect) {
    camera.to_world = camera_to_world(scene, camera, world_matrices(scene));
    camera.node = none;
    return adapt_to_aspect(std::move(camera), aspect);
}

/// @param scene, camera  valid, the camera placed in the world
Frame draw(Scene scene, const Camera& camera, const RenderSettings& settings, Context& context) {
    check_drawable(scene);
    if (scene.lights.empty() && !is_lit_by_environment(scene)) scene.lights = default_lights(camera.to_world);
    const std::unique_ptr<Engine> engine = make_engine("soft");
    const PrepareOptions prepare{
        .clockwise_fronts = settings.front_face == FrontFace::clockwise,
        .bump = settings.bump,
        .displacement = {.is_on = settings.bump == Bump::displacement, .relief = settings.relief}};
    scene = with_height_maps(std::move(scene), settings, context);
    engine->prepare(valid::prepare_scene(std::move(scene), prepare, context), context);
    Frame frame;
    engine->render(camera, settings, frame, context);
    return frame;
}

}  // namespace

Scene smooth(const Scene& scene, const AttributeOptions& options, Context& context) {
    validate(scene);
    return smooth_scene(scene, {.attributes = options, .only_missing = false}, context);
}

Frame render(const Scene& scene, const Camera& camera, const RenderSettings& settings, Context& context) {
    check_settings(settings);
    validate(scene);
    check_camera(camera, scene.nodes.size(), CameraUse::in_scene);
    return valid::render(scene, camera, settings, context);
}

Frame valid::render(const Scene& scene, const Camera& camera, const RenderSettings& settings, Context& context) {
    return draw(scene, in_world(scene, camera, aspect_of(settings)), settings, context);
}

Frame render(const Scene& scene, const RenderSettings& settings, Context& context) {
    check_settings(settings);
    validate(scene);
    return draw(scene, valid::choose_camera(scene, {}, aspect_of(settings), context), settings, context);
}

void save(const Frame& frame, const std::string& path, const ToneSettings& tone) {
    const Window& w = frame.window;
    if (w.width > 0 && w.height > 0 && frame.color.size() != std::size_t(w.width) * std::size_t(w.height))
        throw Error(ErrorCode::usage, "the frame has " + std::to_string(frame.color.size()) + " colors for " +
                                          std::to_string(w.width) + " x " + std::to_string(w.height) + " pixels")
            .with_file(path);
    const bool transparent = std::any_of(frame.color.begin(), frame.color.end(), [](const vec4& c) { return c.w < 1; });
    const PixelFormat format = format_for(path, transparent);
    PictureFiles files(path, frame.window.width, frame.window.height, format, {});
    PictureSink sink(format, tone);
    const std::size_t width = std::size_t(frame.window.width);
    for (int y = 0; y < frame.window.height; ++y) {
        const Window row{0, y, frame.window.width, 1};
        sink.begin(frame.window.width, frame.window.height, row, 0);
        sink.tile({.area = row, .color = {frame.color.data() + std::size_t(y) * width, width}});
        files.write(sink, 1);
    }
    files.finish();
}

}  // namespace rakelight
