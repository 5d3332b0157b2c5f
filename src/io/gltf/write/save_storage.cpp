// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/write/save_storage.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string_view>

#include "base/format_text.h"
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

Value primitive_of(const Document& document, const Mesh& mesh) {
    const Value owner = document.element(mesh_kind, mesh.source_mesh, document.root());
    return owner.list("primitives")
        .element(mesh.source_primitive, format_text("{}, primitive {}", owner.place(), mesh.source_primitive));
}

DirectionStorage::DirectionStorage(const Accessors& accessors, const Scene& scene) : accessors_(accessors) {
    bool any_small = false;
    for (const Mesh& mesh : scene.meshes) {
        if (mesh.topology != Topology::triangles) continue;
        const bool small_normals = stored(mesh, "NORMAL") == ComponentType::i8,
                   small_tangents = stored(mesh, "TANGENT") == ComponentType::i8;
        small_normals_ = small_normals_ && small_normals;
        small_tangents_ = small_tangents_ && (small_tangents || mesh.tangents.empty());
        any_small = any_small || small_normals || small_tangents;
    }
    if (any_small && !are_turned_alike(scene)) small_normals_ = small_tangents_ = false;
}

static ComponentType stored_in(const Accessors& accessors, const Value& attributes, const char* semantic) {
    if (!attributes.has(semantic)) return ComponentType::f32;
    const Elements e = accessors.description(attributes.required_index(semantic),
                                             {semantic, components(3) | components(4), float_or_small}, attributes);
    const bool is_signed = e.type == ComponentType::i8 || e.type == ComponentType::i16;
    return is_signed && e.normalized ? e.type : ComponentType::f32;
}

ComponentType DirectionStorage::stored(const Mesh& mesh, const char* semantic) const {
    return stored_in(accessors_, primitive_of(accessors_.document(), mesh).object("attributes"), semantic);
}

ComponentType DirectionStorage::stored(const Mesh& mesh, std::uint32_t target, const char* semantic) const {
    return stored_in(accessors_, primitive_of(accessors_.document(), mesh).list("targets").element(target), semantic);
}

ComponentType DirectionStorage::wanted(const Mesh& mesh, const char* semantic) const {
    const ComponentType type = stored(mesh, semantic);
    const bool may_be_small = std::string_view(semantic) == "NORMAL" ? small_normals_ : small_tangents_;
    return type == ComponentType::i8 && !may_be_small ? ComponentType::f32 : type;
}

bool DirectionStorage::is_kept(const Mesh& mesh, const char* semantic) const {
    const ComponentType type = stored(mesh, semantic);
    return type != ComponentType::f32 && type == wanted(mesh, semantic);
}

}  // namespace rakelight::io::gltf
