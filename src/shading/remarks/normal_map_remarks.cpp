// SPDX-License-Identifier: Apache-2.0
#include "shading/remarks/normal_map_remarks.h"

#include <cstdio>

namespace rakelight::shading {
namespace {

std::string described(const NormalMapCheck& c) {
    char text[160];
    std::snprintf(text, sizeof text,
                  "%llu of %llu texels of the normal map (%.2g %%) point into the surface: blue is below one half",
                  static_cast<unsigned long long>(c.below), static_cast<unsigned long long>(c.texels),
                  100.0 * double(c.below) / double(c.texels));
    return text;
}

}  // namespace

/// Whether the map is to be looked at.
bool NormalMapRemarks::begin(const Material& material, const TextureUse& use, const LoadedTexture& texture) {
    const EncodedImage& image = *scene_.textures[use.texture].image;
    place_ = !image.place.empty() ? image.place : material.name.empty() ? image.name : material.name;
    is_of_world_ = !image.place.empty();
    return texture.check && seen_.insert(&image).second;
}

void NormalMapRemarks::look_at_heights(const Material& material, const TextureUse& use, const LoadedTexture& texture) {
    if (begin(material, use, texture) && texture.check->looks_like_normals())
        say(Remark::warning,
            is_of_world_ ? "the height map looks like a normal map; 'normal_texture' takes it as one"
                         : "the height map looks like a normal map; 'texture-normal' takes it as one",
            {"texture-normal"});
}

void NormalMapRemarks::look_at(const Material& material, const TextureUse& use, const LoadedTexture& texture) {
    if (!begin(material, use, texture)) return;
    const NormalMapCheck& check = *texture.check;
    if (check.looks_like_heights())
        return say(Remark::warning,
                   is_of_world_ ? "the normal map looks like a height map: it is gray; 'height_texture' takes it as one"
                                : "the normal map looks like a height map: it is gray; 'height-map' takes it as one",
                   {"height-map"});
    if (check.below > 0)
        say(check.below * 1000 >= check.texels ? Remark::warning : Remark::note, described(check).c_str());
    if (!material.green_down && check.green.is_down())
        say(Remark::warning, "the normal map looks green-down; 'normal-map-green' down turns it", {"normal-map-green"});
    if (material.green_down && check.green.is_up())
        say(Remark::warning, "the normal map looks green-up; the material takes it for green-down");
    if (check.looks_srgb())
        say(Remark::warning, "the normal map looks sRGB-encoded; it is read as plain numbers, as all normal maps are");
    else if (texture.is_tagged_srgb)
        say(Remark::warning, "the normal map is tagged sRGB; it is read as plain numbers, as all normal maps are");
}

}  // namespace rakelight::shading
