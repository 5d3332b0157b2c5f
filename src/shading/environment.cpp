// SPDX-License-Identifier: Apache-2.0
#include "shading/environment.h"

#include "image/decode.h"
#include "shading/lights/environment_axes.h"
#include "shading/lights/studio_light.h"

namespace rakelight::shading {
namespace {

MipChain sky_of(const ImageHandle& image, Context& context) {
    return make_mip_chain(image ? decode(*image, context) : studio_panorama(), ColorSpace::srgb, context);
}

EnvironmentImages images_of(const ImageHandle& image, bool with_sky, Context& context) {
    EnvironmentImages out;
    if (image || with_sky) out.sky = sky_of(image, context);
    out.light = image ? make_environment_light(out.sky, context) : studio_light(context);
    if (!with_sky) out.sky = {};
    return out;
}

EnvironmentFactors factors_of(const std::array<vec3, 9>& irradiance, const Environment& environment) {
    EnvironmentFactors out{};
    for (std::size_t i = 0; i < 9; ++i)
        for (std::size_t c = 0; c < 3; ++c) out.irradiance[i][c] = irradiance[i][c];
    const std::array<dvec3, 3> axes = environment_axes(environment);
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t i = 0; i < 3; ++i) out.turn[k][i] = float(axes[k][i]);
    out.intensity = environment.intensity;
    return out;
}

}  // namespace

MipChain sky_of(const Environment& environment, Context& context) { return sky_of(environment.image, context); }

bool uses_environment(const Scene& scene) {
    return scene.environment && (scene.environment->is_light || scene.environment->is_background);
}

std::optional<UsedEnvironment> EnvironmentCache::update(const Scene& scene, const EnvironmentPacker& packer,
                                                        bool follows_rays, Context& context) {
    const ImageHandle image = uses_environment(scene) ? scene.environment->image : nullptr;
    if (packed_ && (!uses_environment(scene) || image_ != image)) packed_ = nullptr;
    if (!uses_environment(scene)) return {};
    const bool needs_sky = follows_rays || scene.environment->is_background;
    if (!packed_ || (needs_sky && !has_sky_)) try {
            packed_ = nullptr;
            const EnvironmentImages images = images_of(image, needs_sky, context);
            packed_ = packer.pack(images, image, context);
            has_sky_ = needs_sky;
            irradiance_ = images.light.irradiance;
            image_ = image;
        } catch (const Error& error) {
            context.throw_if_cancelled();
            context.report().add(Remark::warning, image ? image->file : scene.source,
                                 image ? image->name : "the built-in studio",
                                 "environment left out: " + error.reason());
            return {};
        }
    return UsedEnvironment{packed_, factors_of(irradiance_, *scene.environment)};
}

}  // namespace rakelight::shading
