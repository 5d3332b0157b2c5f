// SPDX-License-Identifier: Apache-2.0
// How normals and tangents are stored: as float, or as integers that stand for -1..1 (KHR_mesh_quantization).
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <rakelight/scene/scene.h>

#include "io/gltf/elements.h"

namespace rakelight::io::gltf {

/// Half the distance of two codes, the most that storing a number moves it; 0 for float.
double half_step(ComponentType type);
/// `x` as it is read back. i8 and i16: the nearest code / 127 or / 32767, never -128 or -32768; f32: `x`.
float stored_value(float x, ComponentType type);
/// [elements * stride bytes] Elements of `width` numbers, each element at a multiple of `stride`.
std::vector<std::byte> stored_bytes(std::span<const float> numbers, std::uint32_t width, ComponentType type,
                                    std::uint32_t stride);

/// Normals and tangents as attributes of a primitive or, but for bitangents, of a morph target.
enum class Direction : std::uint8_t { normal, tangent, bitangent };
inline constexpr std::array all_directions{Direction::normal, Direction::tangent, Direction::bitangent};

/// The attribute's name. Bitangents have one with an underscore, as attributes have that glTF does not know.
const char* name_of(Direction direction);
/// Numbers of each vector; of offsets of morph targets always 3.
constexpr std::uint32_t width_of(Direction direction) { return direction == Direction::tangent ? 4 : 3; }

/// [Direction] i8, i16, or f32 for all else and where there is none.
struct DirectionTypes {
    std::array<ComponentType, 3> each{ComponentType::f32, ComponentType::f32, ComponentType::f32};
    ComponentType& operator[](Direction direction) { return each[std::size_t(direction)]; }
    ComponentType operator[](Direction direction) const { return each[std::size_t(direction)]; }
};

/// What a file says of elements, as one of DirectionTypes.
ComponentType direction_type(ComponentType type, bool is_normalized);

/// The types of a primitive's directions in the file.
struct StoredDirections {
    DirectionTypes own;
    std::vector<DirectionTypes> targets;  ///< [targets]
};

/// Which type the new normals and tangents of each primitive get, so that equal vectors at a border stay equal.
///
/// 16 bits are kept: a step is 0.002 degrees. 8 bits (a step is 0.5 degrees, which is visible) are kept where all that
/// meet have the same codes. That is so if all drawn primitives store 8 bits, and no object is rotated or scaled
/// relative to another. Else float.
class DirectionStorage {
public:
    /// @param scene  what was read  @param stored  [meshes]
    DirectionStorage(const Scene& scene, std::vector<StoredDirections> stored);

    const StoredDirections& stored(std::uint32_t mesh) const { return stored_[mesh]; }
    DirectionTypes wanted(std::uint32_t mesh) const;
    /// Both are the same integers: what was computed need only be within half a step of what is there.
    bool is_kept(std::uint32_t mesh, Direction direction) const;

private:
    std::vector<StoredDirections> stored_;
    bool small_normals_ = true, small_tangents_ = true;  ///< where 8 bits are stored, they may stay
};

}  // namespace rakelight::io::gltf
