// SPDX-License-Identifier: Apache-2.0
#include "shading/environment.h"

#include "image/decode.h"

namespace rakelight::shading {
namespace {

EnvironmentImages images_of(const ImageHandle& image, Context& context) {
    EnvironmentImages out;
    out.sky = make_mip_chain(image ? decode(*image, context) : studio_panorama(), ColorSpace::srgb, context);
    out.light = make_environment_light(out.sky, context);
    return out;
}

}  // namespace

bool uses_environment(const Scene& scene) {
    return scene.environment && (scene.environment->is_light || scene.environment->is_background);
}

void load_environment(const Scene& scene, const std::function<void(const EnvironmentImages&)>& pack, Context& context) {
    const ImageHandle& image = scene.environment->image;
    try {
        pack(images_of(image, context));
    } catch (const Error& error) {
        context.throw_if_cancelled();
        context.report().add(Remark::warning, image ? image->file : scene.source,
                             image ? image->name : "the built-in studio", "environment left out: " + error.reason());
    }
}

}  // namespace rakelight::shading
