// SPDX-License-Identifier: Apache-2.0
// What pointers of KHR_animation_pointer say of materials, lights and cameras, one row each: reader and writer use the rows.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <rakelight/scene/animated_properties.h>
#include <rakelight/scene/scene.h>

namespace rakelight::io::gltf {

struct PointerRow {
    AnimationPath path;     ///< material, light or camera
    std::string place;      ///< in the element: "pbrMetallicRoughness/baseColorFactor"
    std::string property;   ///< of animated_properties()
    std::uint32_t width;    ///< numbers a key
    std::string extension;  ///< of the material, that `place` begins with; or empty
    std::string texture;    ///< the textureInfo whose KHR_texture_transform it is of, in the element; or empty
    std::optional<Projection> projection = {};  ///< of cameras: whose it is
};

std::span<const PointerRow> pointer_rows();
/// Null: there is none.
const PointerRow* row_at(AnimationPath path, std::string_view place);
/// @param projection  of a camera  @return null: glTF cannot store it
const PointerRow* row_of(AnimationPath path, std::string_view property, std::optional<Projection> projection = {});

/// In front of the number of an element: "/materials/".
const char* pointer_prefix(AnimationPath path);

}  // namespace rakelight::io::gltf
