// SPDX-License-Identifier: Apache-2.0
// Textures, images and samplers, made when a material first asks.
#pragma once
#include <map>

#include <rakelight/scene/scene.h>

#include "io/gltf/buffers.h"

namespace rakelight::io::gltf {

class Textures {
public:
    Textures(const Document& document, Buffers& buffers, Scene& scene)
        : document_(document), buffers_(buffers), scene_(scene) {}

    /// A material's use of a texture: `owner`'s member `name` (a textureInfo object). A use whose image is missing,
    /// lies outside the model's folder or is of an unsupported kind is left out, with a remark; the picture is drawn
    /// without it.
    TextureUse use(const Value& owner, const char* name);

private:
    std::uint32_t load(std::uint32_t index, const Value& from);
    ImageHandle image(std::uint32_t index, const Value& from);
    ImageHandle image_in_view(std::uint32_t view, std::string name, const Value& image);
    ImageHandle image_in_file(const std::string& uri, std::string name, const Value& image);
    Sampler sampler(std::uint32_t index, const Value& from) const;
    const Document& document_;
    Buffers& buffers_;
    Scene& scene_;
    std::map<std::uint32_t, std::uint32_t> textures_;  // of the file -> of the scene, or none
    std::map<std::uint32_t, ImageHandle> images_;
    /// Images of one view, or of one file, are one picture: decoded once, under the name of the first.
    std::map<std::uint32_t, ImageHandle> views_;
    std::map<std::string, ImageHandle> files_;  ///< by path
};

}  // namespace rakelight::io::gltf
