// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/write/save_storage.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "math/linear.h"
#include "scene/placement.h"

namespace rakelight::io::gltf {
namespace {

double largest_code(ComponentType type) { return type == ComponentType::i8 ? 127 : 32767; }

int code_of(float x, ComponentType type) {
    const double largest = largest_code(type);
    return int(std::clamp(std::floor(double(x) * largest + 0.5), -largest, largest));
}

/// What a matrix does to normals, except for their length.
dmat3 turn_of(const dmat4& place) {
    const dmat3 linear = upper_left(place);
    dmat3 turn = cofactor(linear);
    double square = 0;
    for (int c = 0; c < 3; ++c) square += dot(turn[c], turn[c]);
    const double size = std::sqrt(square) * (determinant(linear) < 0 ? -1 : 1);
    for (int c = 0; c < 3 && size != 0; ++c) turn[c] = turn[c] * (1 / size);
    return turn;
}

/// No object is turned, mirrored or unevenly stretched against another.
bool are_turned_alike(const Scene& scene) {
    const std::vector<dmat4> world = world_matrices(scene);
    const dmat4* first = nullptr;
    for (std::size_t n = 0; n < world.size(); ++n) {
        if (scene.nodes[n].meshes.empty()) continue;
        if (!first) first = &world[n];
        const dmat3 a = turn_of(*first), b = turn_of(world[n]);
        for (int c = 0; c < 3; ++c) {
            const dvec3 d = a[c] - b[c];
            if (!(dot(d, d) <= 1e-12)) return false;
        }
    }
    return true;
}

}  // namespace

double half_step(ComponentType type) { return type == ComponentType::f32 ? 0 : 0.5 / largest_code(type); }

float stored_value(float x, ComponentType type) {
    return type == ComponentType::f32 ? x : float(code_of(x, type)) / float(largest_code(type));
}

std::vector<std::byte> stored_bytes(std::span<const float> numbers, std::uint32_t width, ComponentType type,
                                    std::uint32_t stride) {
    std::vector<std::byte> bytes(numbers.size() / width * stride);
    const std::size_t size = size_of(type);
    if (type == ComponentType::f32 && stride == width * size) {
        if (!bytes.empty()) std::memcpy(bytes.data(), numbers.data(), bytes.size());
        return bytes;
    }
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        std::byte* to = bytes.data() + i / width * stride + i % width * size;
        if (type == ComponentType::f32) {
            std::memcpy(to, &numbers[i], size);
        } else {  // the low bytes of the two's complement
            const int code = code_of(numbers[i], type);
            std::memcpy(to, &code, size);
        }
    }
    return bytes;
}

const char* name_of(Direction direction) {
    switch (direction) {
        case Direction::normal:
            return "NORMAL";
        case Direction::tangent:
            return "TANGENT";
        default:
            return "_BITANGENT";
    }
}

ComponentType direction_type(ComponentType type, bool is_normalized) {
    const bool is_signed = type == ComponentType::i8 || type == ComponentType::i16;
    return is_signed && is_normalized ? type : ComponentType::f32;
}

DirectionStorage::DirectionStorage(const Scene& scene, std::vector<StoredDirections> stored)
    : stored_(std::move(stored)) {
    bool any_small = false;
    for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
        const Mesh& mesh = scene.meshes[m];
        if (mesh.topology != Topology::triangles) continue;
        const DirectionTypes& types = stored_[m].own;
        const bool small_normals = types[Direction::normal] == ComponentType::i8,
                   small_tangents = types[Direction::tangent] == ComponentType::i8;
        small_normals_ = small_normals_ && small_normals;
        small_tangents_ = small_tangents_ && (small_tangents || mesh.tangents.empty());
        any_small = any_small || small_normals || small_tangents;
    }
    if (any_small && !are_turned_alike(scene)) small_normals_ = small_tangents_ = false;
}

DirectionTypes DirectionStorage::wanted(std::uint32_t mesh) const {
    DirectionTypes types = stored_[mesh].own;
    for (const Direction direction : all_directions) {
        const bool may_be_small = direction == Direction::normal ? small_normals_ : small_tangents_;
        if (types[direction] == ComponentType::i8 && !may_be_small) types[direction] = ComponentType::f32;
    }
    return types;
}

bool DirectionStorage::is_kept(std::uint32_t mesh, Direction direction) const {
    const ComponentType type = stored_[mesh].own[direction];
    return type != ComponentType::f32 && type == wanted(mesh)[direction];
}

}  // namespace rakelight::io::gltf
