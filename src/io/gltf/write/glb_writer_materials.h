// SPDX-License-Identifier: Apache-2.0
// Materials, textures, cameras and lights of a scene as glTF JSON.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/scene/scene.h>

#include "io/gltf/write/glb_writer_pointers.h"
#include "io/gltf/write/save_tree.h"

namespace rakelight::io::gltf {

/// Writes the lists "materials", "textures", "images" and "samplers"; what glTF cannot express goes into the report.
class MaterialWriter {
public:
    MaterialWriter(OrderedJson& root, const Scene& scene, const MovedMaterials& moved, Context& context)
        : root_(root), scene_(scene), moved_(moved), context_(context) {}

    /// All materials of the scene, in its order. Images are appended to `binary` with views of buffer 0.
    void write(std::vector<std::byte>& binary);
    const std::vector<std::string>& extensions() const { return extensions_; }  ///< used, each once

private:
    OrderedJson material(const Material& source, std::size_t number);
    void extension(OrderedJson& material, const char* name, OrderedJson value);
    OrderedJson extension_of(const char* name, const Material& m, bool is_moved);
    void extensions(OrderedJson& json, const Material& m, bool is_moved);
    OrderedJson use(const TextureUse& use);
    bool set_use(OrderedJson& owner, const char* name, const TextureUse& use);
    std::uint32_t texture(std::uint32_t number);
    std::uint32_t image(const EncodedImage& image, bool& is_webp);
    std::uint32_t sampler(const Sampler& sampler);
    void used(const char* extension);
    void lost(const std::string& place, const std::string& what);

    OrderedJson& root_;
    const Scene& scene_;
    const MovedMaterials& moved_;
    Context& context_;
    std::vector<std::byte>* binary_ = nullptr;
    std::map<std::uint32_t, std::uint32_t> textures_;  ///< by the scene's number; `none` where it cannot be written
    std::map<const EncodedImage*, std::pair<std::uint32_t, bool>> images_;
    std::map<std::string, std::uint32_t> samplers_;
    std::vector<std::string> extensions_;
};

/// A camera as glTF's object; the far plane is left out where it is infinite.
OrderedJson camera_json(const Camera& camera);

/// A light of KHR_lights_punctual. Classical ones become photometric: their diffuse color as color and intensity (times
/// pi, so that a white surface facing it looks the same), of the attenuation only what falls with the square.
OrderedJson light_json(const Light& light);

}  // namespace rakelight::io::gltf
