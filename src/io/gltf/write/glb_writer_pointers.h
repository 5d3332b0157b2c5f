// SPDX-License-Identifier: Apache-2.0
// Channels of materials, lights and cameras as pointers of glTF (KHR_animation_pointer).
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include <rakelight/scene/scene.h>

#include "io/gltf/motion/pointer_table.h"
#include "io/gltf/write/save_tree.h"

namespace rakelight::io::gltf {

/// What clips move of the materials of a scene, looked up once.
class MovedMaterials {
public:
    explicit MovedMaterials(const Scene& scene);
    bool is_moved(std::size_t material) const { return is_moved_[material]; }
    /// What emissiveFactor is divided by so that it is 1 at most, of the keys too; at least 1.
    float emission_strength(std::size_t material) const { return strength_[material]; }

private:
    std::vector<bool> is_moved_;   ///< [materials]
    std::vector<float> strength_;  ///< [materials]
};

struct WrittenPointer {
    std::string pointer;
    std::uint32_t width = 1;
    float divisor = 1;  ///< of the key values
};

/// After materials, lights and cameras were written.
class PointerWriter {
public:
    /// @param lights  [of the scene] their numbers in the file, or `no_index`
    PointerWriter(OrderedJson& root, const Scene& scene, const MovedMaterials& moved, std::vector<std::size_t> lights)
        : root_(root), scene_(scene), moved_(moved), lights_(std::move(lights)) {}

    /// Empty: glTF cannot store it, or what it would move was not written. Extensions of materials that it takes are made.
    std::vector<WrittenPointer> pointers_of(const AnimationChannel& channel);
    const std::vector<std::string>& extensions() const { return extensions_; }  ///< used, each once

private:
    std::vector<WrittenPointer> of_material(const AnimationChannel& channel);
    std::vector<WrittenPointer> of_light(const AnimationChannel& channel);
    std::vector<WrittenPointer> of_camera(const AnimationChannel& channel);
    bool make_parent(OrderedJson& element, const std::string& place);
    void used(const std::string& extension);

    OrderedJson& root_;
    const Scene& scene_;
    const MovedMaterials& moved_;
    std::vector<std::size_t> lights_;
    std::vector<std::string> extensions_;
};

}  // namespace rakelight::io::gltf
