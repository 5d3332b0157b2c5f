// SPDX-License-Identifier: Apache-2.0
// What a document of gltf-transform or an object of three.js holds, as npm/scene.js hands it over, and the scene that it is.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/scene/scene.h>

#include "io/gltf/elements.h"
#include "io/gltf/topology.h"
#include "io/gltf/write/save_storage.h"

namespace rakelight::web {

inline constexpr std::uint32_t no_target = no_index;

/// What an array of a primitive is.
enum class Semantic : std::uint8_t { position, normal, tangent, bitangent, texcoord, joints, weights, indices };

/// Elements as they are stored.
struct ArrayInput {
    std::vector<std::byte> bytes;
    std::uint64_t count = 0;
    std::uint32_t components = 1;
    io::gltf::ComponentType type{};
    bool is_normalized = false;
};

struct AttributeInput {
    Semantic semantic;
    std::uint32_t set = 0;  ///< the n of TEXCOORD_n, JOINTS_n, WEIGHTS_n
    std::uint32_t target = no_target;
    std::uint32_t array = 0;
};

struct PrimitiveInput {
    std::string name;  ///< of its mesh, for messages
    std::uint32_t mesh = 0, primitive = 0;
    std::uint32_t mode = 0;  ///< as in glTF
    std::uint32_t material = no_index;
    std::vector<std::string> targets;  ///< their names; targets of one name belong together over all meshes
    std::vector<AttributeInput> attributes;
};

struct NodeInput {
    std::uint32_t parent = no_index;  ///< before it
    std::uint32_t source_node = 0;    ///< instances of one node have its number
    std::uint32_t mesh = no_index, skin = no_index;
    bool is_matrix = false;
    std::array<double, 16> place{};  ///< a matrix by columns, or translation, rotation (x, y, z, w), scale
};

struct SkinInput {
    std::vector<std::uint32_t> joints;
    std::vector<double> inverse_bind;  ///< [joints * 16] by columns
};

struct DocumentInput {
    std::vector<ArrayInput> arrays;
    std::vector<Material> materials;  ///< their textures are number 0
    std::vector<PrimitiveInput> primitives;
    std::vector<NodeInput> nodes;
    std::vector<SkinInput> skins;
};

struct InputScene {
    Scene scene;                                     ///< valid
    std::vector<io::gltf::StoredDirections> stored;  ///< [meshes]
};

/// "mesh 'body', primitive 0"
std::string place_of(const std::string& mesh_name, std::uint32_t primitive);

/// By the conversions of the reader of glTF. Primitives without positions or corners are left out, with a remark.
/// @throws Error bad_file, with the place: counts that differ, indices that exceed the vertices, types that glTF does not allow
InputScene make_scene(const DocumentInput& input, Context& context);

}  // namespace rakelight::web
