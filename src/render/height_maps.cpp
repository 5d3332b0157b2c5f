// SPDX-License-Identifier: Apache-2.0
#include "render/height_maps.h"

#include <rakelight/base/report.h>

#include <algorithm>
#include <cstdio>
#include <map>

#include "image/decode.h"
#include "image/maps/height_from_normals.h"
#include "scene/materials/material_conversion.h"

namespace rakelight {
namespace {

bool wants_heights(const Material& m, const RenderSettings& settings) {
    return reads_heights(bump_of(m, settings.bump)) && m.normal_texture && !m.height_texture;
}

ImageHandle as_image(Pixels pixels, const EncodedImage& from) {
    auto image = std::make_shared<EncodedImage>();
    image->name = from.name + " (heights)";
    image->file = from.file;
    image->decode = [pixels = std::move(pixels)](const EncodedImage&, Context& context) {
        MemoryCharge charge(context.memory(), pixels.bytes.size(), "height map");
        Pixels copy = pixels;
        copy.charge = share(std::move(charge));
        return copy;
    };
    return image;
}

std::string text_of(double depth) {
    char text[160];
    std::snprintf(text, sizeof text,
                  "height map computed from the normal map; its slopes give a depth of %.3g of the texture's width",
                  depth);
    return text;
}

/// If unrelated parts of a picture are side by side, as in atlases, their heights do not match at the borders: a step
/// in the texture would become one in the geometry.
constexpr const char* displaced =
    "displaced by heights computed from the normal map: the relative height of its parts is guessed, and borders of "
    "its texture may bulge; a height map or 'bump' occlusion avoids this";

/// One height map for each picture, whichever materials use it.
class Maker {
public:
    Maker(Scene& scene, const RenderSettings& settings, Context& context)
        : scene_(scene), settings_(settings), context_(context) {}

    void give(Material& m) {
        const Texture normal = scene_.textures[m.normal_texture.texture];
        const auto [made, is_new] = made_.try_emplace({m.normal_texture.texture, m.green_down}, no_index);
        if (is_new) made->second = make(normal, m);
        if (made->second == no_index) return;
        if (bump_of(m, settings_.bump) == Bump::displacement)
            context_.report().add(Remark::warning, scene_.source, m.name, displaced, {"bump"});
        m.height_texture = m.normal_texture;
        m.height_texture.texture = made->second;
    }

private:
    std::uint32_t make(const Texture& normal, const Material& m) {
        try {
            HeightsFromNormals made = heights_of(*normal.image, m.green_down);
            context_.report().add(Remark::guessed, scene_.source, m.name, text_of(made.depth));
            scene_.textures.push_back(
                {normal.name + " (heights)", as_image(std::move(made.heights), *normal.image), normal.sampler});
            return std::uint32_t(scene_.textures.size() - 1);
        } catch (const Error& error) {
            context_.throw_if_cancelled();
            context_.report().add(Remark::dropped, scene_.source, m.name,
                                  "no height map computed from the normal map: " + error.reason());
            return no_index;
        }
    }

    HeightsFromNormals heights_of(const EncodedImage& normals, bool green_down) {
        return heights_from_normals(decode(normals, context_), green_down, context_);
    }

    Scene& scene_;
    const RenderSettings& settings_;
    Context& context_;
    std::map<std::pair<std::uint32_t, bool>, std::uint32_t> made_;
};

/// A technique that finds no map changes nothing.
void warn_of_no_heights(const Scene& scene, const RenderSettings& settings, Report& report) {
    const auto has_heights = [](const Material& m) { return bool(m.height_texture); };
    if (settings.bump != Bump::automatic && reads_heights(settings.bump) &&
        std::none_of(scene.materials.begin(), scene.materials.end(), has_heights))
        report.add(Remark::warning, scene.source, {},
                   "no bumps: no material has a height map, or a normal map to compute one from");
    for (const Material& m : scene.materials)
        if (m.bump != Bump::automatic && reads_heights(m.bump) && !has_heights(m))
            report.add(Remark::warning, scene.source, m.name,
                       "no bumps: the material has no height map, or a normal map to compute one from");
}

}  // namespace

Scene with_height_maps(Scene scene, const RenderSettings& settings, Context& context) {
    Maker maker(scene, settings, context);
    for (Material& m : scene.materials)
        if (wants_heights(m, settings)) maker.give(m);
    warn_of_no_heights(scene, settings, context.report());
    return scene;
}

}  // namespace rakelight
