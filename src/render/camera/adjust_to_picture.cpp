// SPDX-License-Identifier: Apache-2.0
// What the default look learns from a small picture of the model.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "engines/shader_text.h"
#include "math/color.h"
#include "math/functions.h"
#include "render/look.h"
#include "render/point_look.h"

namespace rakelight {
namespace {

constexpr int longer_side = 128;  ///< [px] of the small picture
/// Display values of the two backgrounds, and how far from the first the model's rim has to be on the average.
constexpr vec3 dark{0.19f, 0.195f, 0.21f}, light{0.85f, 0.855f, 0.86f};
constexpr double least_contrast = 0.16;
/// The brightest tenth of the model shall begin between these; else it is brought to the middle. [display, linear]
constexpr double lowest_bright = 0.1, highest_bright = 1, wanted_bright = 0.7;

double luminance(const vec4& c) { return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z; }

/// @param of  by its settings, at their size
Frame small_picture(const Shot& of, Session& session, Context& context) {
    Shot shot = of;
    RenderSettings& settings = shot.settings;
    const double scale = double(longer_side) / std::max({settings.width, settings.height, longer_side});
    settings.width = std::max(1, int(std::lround(settings.width * scale)));
    settings.height = std::max(1, int(std::lround(settings.height * scale)));
    settings.window = {};
    settings.channels = 0;
    drop_shaders(settings);  // engine soft draws it for the viewer
    settings.samples = 1;
    settings.shadows = false;
    settings.background = {0, 0, 0, 0};
    settings.ambient_occlusion = false;
    session.warm_up(shot, context);  // what it remarks on, textures that are broken, is reported once
    // What there is to remark on in drawing is remarked on by the picture itself, and progress is that picture's.
    Context quiet({.threads = context.threads(), .max_memory = context.memory().limit(), .parent = &context});
    Frame frame;
    session.render(shot, frame, quiet);
    return frame;
}

/// Mean distance, in display values, of the model's rim from a background.
double contrast_of_rim(const Frame& frame, double background) {
    const int width = frame.window.width, height = frame.window.height;
    const auto is_model = [&](int x, int y) {
        return frame.color[std::size_t(y) * std::size_t(width) + std::size_t(x)].w > 0.5f;
    };
    double sum = 0, count = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            if (!is_model(x, y)) continue;
            const bool is_inside = x > 0 && x + 1 < width && y > 0 && y + 1 < height && is_model(x - 1, y) &&
                                   is_model(x + 1, y) && is_model(x, y - 1) && is_model(x, y + 1);
            if (is_inside) continue;
            const double value = luminance(frame.color[std::size_t(y) * std::size_t(width) + std::size_t(x)]);
            sum += std::fabs(double(srgb_from_linear(float(std::clamp(value, 0.0, 1.0)))) - background), count += 1;
        }
    return count > 0 ? sum / count : 1;
}

/// Linear light that the brightest tenth of the model is above; 0 where there is no model.
double bright_of(const Frame& frame) {
    std::vector<float> values;
    for (const vec4& c : frame.color)
        if (c.w > 0.5f) values.push_back(std::max({c.x, c.y, c.z}));
    if (values.empty()) return 0;
    const auto at = values.begin() + std::ptrdiff_t(values.size() * 9 / 10);
    std::nth_element(values.begin(), at, values.end());
    return double(*at);
}

void expose(const Frame& frame, PictureRequest& request, Context& context) {
    const double bright = bright_of(frame);
    if (!(bright > 1e-9) || (bright >= lowest_bright && bright <= highest_bright)) return;
    const double ev = std::clamp(std::round(10 * math::log2(wanted_bright / bright)) / 10, -30.0, 30.0);
    request.tone.exposure_ev = float(ev);
    char text[120];
    std::snprintf(text, sizeof text, "the file's lights ask for an exposure of %+.1f, which is used; see 'exposure'",
                  ev);
    context.report().add(Remark::note, request.input, "", text, {"exposure"});
}

}  // namespace

void adjust_to_picture(PictureRequest& request, Session& session, const Shot& shot, Context& context) {
    if (request.look == Look::plain) return;
    (void)session.prepared_for(shot, context);  // as the picture needs it
    size_points(request, session, {shot.camera, request.settings, shot.lights}, context);
    if (request.engine == "trace" || !request.settings.colors) return;
    const bool may_expose = !request.lights && !request.default_lights && !request.studio_lights &&
                            !names(request, "exposure") && !names(request, "tone-mapping");
    if (names(request, "background") && !may_expose) return;
    Frame frame = small_picture({shot.camera, request.settings, shot.lights}, session, context);
    const Scene& scene = session.engine().scene();
    const bool is_physical =
        std::ranges::any_of(scene.lights, [](const Light& l) { return l.units == LightUnits::photometric; });
    const bool tones = !names(request, "background") && !(scene.environment && scene.environment->is_background);
    if (is_physical && may_expose) expose(frame, request, context);
    const float gain = float(math::exp2(double(request.tone.exposure_ev)));
    for (vec4& c : frame.color) c = {c.x * gain, c.y * gain, c.z * gain, c.w};
    if (!tones) return;
    const vec3 chosen = contrast_of_rim(frame, double(dark.y)) >= least_contrast ? dark : light;
    request.settings.background = {linear_from_srgb(chosen.x), linear_from_srgb(chosen.y), linear_from_srgb(chosen.z),
                                   request.settings.background.w};
}

}  // namespace rakelight
