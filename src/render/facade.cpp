// SPDX-License-Identifier: Apache-2.0
// Facade: smooth, render, save.
#include <algorithm>

#include <rakelight/picture.h>
#include <rakelight/session.h>

#include "engines/check_settings.h"
#include "prepare/prepare.h"
#include "render/picture_files.h"
#include "render/picture_steps.h"

namespace rakelight {
Scene smooth(const Scene& scene, const AttributeOptions& options, Context& context) {
    validate(scene);
    return smooth_scene(scene, {.attributes = options, .only_missing = false}, context);
}

Frame render(const Scene& scene, const Camera& camera, const RenderSettings& settings, Context& context) {
    check_settings(settings);
    Session session;
    session.set(scene);
    Frame frame;
    session.render(camera, settings, frame, context);
    return frame;
}

Frame render(const Scene& scene, const RenderSettings& settings, Context& context) {
    check_settings(settings);
    const double aspect = double(settings.width) / double(settings.height);
    return render(scene, choose_camera(scene, {}, aspect, context), settings, context);
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
