// SPDX-License-Identifier: Apache-2.0
// Meshopt codecs of the library. Callers check the sizes first.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace rakelight::io::gltf {

enum class MeshoptMode : std::uint8_t { attributes, triangles, indices };
enum class MeshoptFilter : std::uint8_t { none, octahedral, quaternion, exponential };

struct MeshoptJob {
    MeshoptMode mode{};
    MeshoptFilter filter{};
    std::size_t count = 0, stride = 0;
    std::span<const std::byte> data;
    std::span<std::byte> out;  ///< [count * stride]
};

/// Unpacks and filters. @return 0, or the code of the library: the data is broken or of a newer version
/// @throws Error bad_file: there is no such library
int unpack_meshopt(const MeshoptJob& job);

}  // namespace rakelight::io::gltf
