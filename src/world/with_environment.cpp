// SPDX-License-Identifier: Apache-2.0
// Applies the environment of a request.
#include <rakelight/math/linear.h>

#include "base/format_text.h"
#include "io/files/file.h"
#include "io/pictures/image_io.h"
#include "world/scene_of_request.h"

namespace rakelight {
namespace {

/// Intensity of the built-in studio, so that a white surface lit by it and its key light (studio_lights()) does not
/// exceed 1.
constexpr double beside_key = 0.75;

/// Decoded once as a check, so that it is not ignored silently; the engine decodes it again.
ImageHandle environment_file(const std::string& path, Context& context) {
    try {
        const io::Bytes bytes = io::read_file(path, context);
        const Pixels pixels = io::decode_image(*bytes, context);
        if (pixels.width != 2 * pixels.height)
            context.report().add(
                Remark::warning, path, {},
                format_text("the environment is {} x {} pixels: equirectangular pictures are twice as wide as high",
                            pixels.width, pixels.height));
    } catch (const Error& error) {
        throw error.with_file(path);
    }
    return io::image_from_file(path, path, path);
}

}  // namespace

Scene with_environment(Scene scene, const PictureRequest& request, Context& context) {
    const bool is_wanted = !request.hdri_file.empty() || request.hdri_ambient.value_or(false) ||
                           request.hdri_skybox.value_or(false) || request.studio_lights;
    const bool is_turned = request.hdri_intensity || request.hdri_rotation_rad;
    const bool is_changed =
        scene.environment && (request.hdri_ambient || request.hdri_skybox || is_turned || request.view.world_up);
    if (!is_wanted && !is_changed) {
        if (is_turned)
            context.report().add(Remark::warning, request.input, {},
                                 "'hdri-intensity' and 'hdri-rotation' have no effect: the scene has no environment",
                                 {"hdri-intensity", "hdri-rotation"});
        return scene;
    }
    Environment environment = scene.environment.value_or(Environment{.is_light = false, .is_background = false});
    if (!request.hdri_file.empty()) environment.image = environment_file(request.hdri_file, context);
    const bool is_file_alone = !request.hdri_file.empty() && !scene.environment && !request.hdri_skybox.value_or(false);
    environment.is_light =
        request.hdri_ambient.value_or(environment.is_light || request.studio_lights || is_file_alone);
    environment.is_background = request.hdri_skybox.value_or(environment.is_background);
    const bool is_studio = request.studio_lights && !scene.environment && request.hdri_file.empty();
    environment.intensity =
        float(request.hdri_intensity.value_or(is_studio ? beside_key : double(environment.intensity)));
    if (request.view.world_up) environment.up = normalize_or(*request.view.world_up, environment.up);
    environment.rotation_rad = request.hdri_rotation_rad.value_or(environment.rotation_rad);
    const bool is_unseen = !environment.is_light && !environment.is_background;
    if (is_unseen && is_wanted)
        context.report().add(Remark::warning, request.hdri_file, {},
                             "nothing shows the environment: 'hdri-ambient' lights by it, 'hdri-skybox' shows it",
                             {"hdri-ambient", "hdri-skybox"});
    scene.environment.reset();
    if (!is_unseen) scene.environment = std::move(environment);
    return scene;
}

bool is_lit_by_environment(const Scene& scene) { return scene.environment && scene.environment->is_light; }

}  // namespace rakelight
