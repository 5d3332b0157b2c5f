// SPDX-License-Identifier: Apache-2.0
// How normals and tangents are stored: as float, or as integers that stand for -1..1 (KHR_mesh_quantization).
#pragma once
#include <cstddef>
#include <map>
#include <span>
#include <vector>

#include <rakelight/scene/scene.h>

#include "io/gltf/accessors.h"

namespace rakelight::io::gltf {

/// Half the distance of two codes, the most that storing a number moves it; 0 for float.
double half_step(ComponentType type);
/// `x` as it is read back. i8 and i16: the nearest code / 127 or / 32767, never -128 or -32768; f32: `x`.
float stored_value(float x, ComponentType type);
/// [elements * stride bytes] Elements of `width` numbers, each element at a multiple of `stride`.
std::vector<std::byte> stored_bytes(std::span<const float> numbers, std::uint32_t width, ComponentType type,
                                    std::uint32_t stride);

/// Which type the new normals and tangents of each primitive get, so that equal vectors at a border stay equal.
///
/// 16 bits are kept: a step is 0.002 degrees. 8 bits (a step is 0.5 degrees, which is visible) are kept where all that
/// meet have the same codes. That is so if all drawn primitives store 8 bits, and no object is rotated or scaled
/// relative to another. Else float.
class DirectionStorage {
public:
    DirectionStorage(const Accessors& accessors, const Scene& scene);

    /// @param semantic  "NORMAL" or "TANGENT"  @return i8, i16, or f32 for all else and where there is none
    ComponentType stored(const Mesh& mesh, const char* semantic) const;
    /// The same of a morph target's offsets.
    ComponentType stored(const Mesh& mesh, std::uint32_t target, const char* semantic) const;
    ComponentType wanted(const Mesh& mesh, const char* semantic) const;
    /// Both are the same integers: what was computed need only be within half a step of what is there.
    bool is_kept(const Mesh& mesh, const char* semantic) const;

private:
    const Accessors& accessors_;
    bool small_normals_ = true, small_tangents_ = true;  ///< where 8 bits are stored, they may stay
};

/// The primitive that a mesh was read from.
Value primitive_of(const Document& document, const Mesh& mesh);

}  // namespace rakelight::io::gltf
