// SPDX-License-Identifier: Apache-2.0
#include "scene_input.h"

#include <algorithm>
#include <map>
#include <numeric>

#include <rakelight/base/report.h>
#include <rakelight/scene/validate.h>

#include "base/format_text.h"
#include "io/gltf/accessors.h"
#include "io/gltf/influences.h"

namespace rakelight::web {
namespace {

using io::gltf::ComponentType;
using io::gltf::Direction;
using io::gltf::Elements;

Elements elements_of(const ArrayInput& array) {
    return {.data = array.bytes.data(),
            .count = array.count,
            .stride = array.components * io::gltf::size_of(array.type),
            .components = array.components,
            .type = array.type,
            .normalized = array.is_normalized};
}

/// The arrays as blocks, each made once.
class Blocks {
public:
    explicit Blocks(const std::vector<ArrayInput>& arrays) : arrays_(arrays) {}
    const ArrayInput& array(std::uint32_t number) const { return arrays_.at(number); }
    Block<vec2> vec2s(std::uint32_t number) { return made(vec2s_, number, io::gltf::to_vec2); }
    Block<vec3> vec3s(std::uint32_t number) { return made(vec3s_, number, io::gltf::to_vec3); }
    Block<vec4> vec4s(std::uint32_t number) {
        return made(vec4s_, number, [](const Elements& e) { return io::gltf::to_vec4(e, 1); });
    }

private:
    template <class T, class Make>
    Block<T> made(std::map<std::uint32_t, Block<T>>& known, std::uint32_t number, Make make) {
        Block<T>& block = known[number];
        if (block.empty()) block = make(elements_of(array(number)));
        return block;
    }
    const std::vector<ArrayInput>& arrays_;
    std::map<std::uint32_t, Block<vec2>> vec2s_;
    std::map<std::uint32_t, Block<vec3>> vec3s_;
    std::map<std::uint32_t, Block<vec4>> vec4s_;
};

/// What glTF allows an array to be.
struct Shape {
    const char* name;
    std::uint32_t types;  ///< bits of component types
    std::uint32_t components;
    bool is_of_vertices = true;  ///< one element for each
};

Shape shape_of(Semantic semantic) {
    switch (semantic) {
        case Semantic::position:
            return {"POSITION", io::gltf::float_or_small, 3};
        case Semantic::normal:
            return {io::gltf::name_of(Direction::normal), io::gltf::float_or_small, 3};
        case Semantic::tangent:
            return {io::gltf::name_of(Direction::tangent), io::gltf::float_or_small, 4};
        case Semantic::bitangent:
            return {io::gltf::name_of(Direction::bitangent), io::gltf::float_or_small, 3};
        case Semantic::texcoord:
            return {"TEXCOORD", io::gltf::float_or_small, 2};
        case Semantic::joints:
            return {"JOINTS", io::gltf::unsigned_types, 4};
        case Semantic::weights:
            return {"WEIGHTS", io::gltf::float_or_small, 4};
        default:
            return {"indices", io::gltf::unsigned_types, 1, false};
    }
}

/// Integers as weights mean normalized ones alone.
std::vector<float> to_weights(const ArrayInput& array) {
    Elements weights = elements_of(array);
    weights.normalized = true;
    return io::gltf::to_scalars(weights);
}

/// Makes the mesh of one primitive.
class MeshMaker {
public:
    MeshMaker(const PrimitiveInput& primitive, Blocks& blocks, Context& context)
        : primitive_(primitive), blocks_(blocks), context_(context) {}

    /// @return without indices: the primitive is to be left out
    Mesh make(io::gltf::StoredDirections& stored) {
        if (primitive_.mode > std::uint32_t(io::gltf::PrimitiveMode::triangle_fan))
            fail(format_text("mode {} is unknown", primitive_.mode));
        mesh_.name = primitive_.name;
        mesh_.source_mesh = primitive_.mesh, mesh_.source_primitive = primitive_.primitive;
        mesh_.topology = io::gltf::topology_of(mode());
        mesh_.material = primitive_.material;
        for (const std::string& name : primitive_.targets) targets_.push_back({.name = name});
        stored.targets.resize(targets_.size());
        for (const AttributeInput& a : primitive_.attributes)
            if (a.semantic == Semantic::position && a.target == no_target) take_positions(a.array);
        if (mesh_.positions.empty()) {
            remark("a primitive without vertices is left out");
            return {};
        }
        for (const AttributeInput& a : primitive_.attributes)
            a.target == no_target ? take(a, stored.own) : offset(a, stored);
        finish();
        return std::move(mesh_);
    }

private:
    std::string place() const { return place_of(primitive_.name, primitive_.primitive); }
    io::gltf::PrimitiveMode mode() const { return io::gltf::PrimitiveMode(primitive_.mode); }
    void remark(const char* text) { context_.report().add(Remark::dropped, {}, place(), text); }
    [[noreturn]] void fail(const std::string& reason) { throw Error(ErrorCode::bad_file, reason, place()); }

    void take_positions(std::uint32_t array) {
        Shape shape = shape_of(Semantic::position);
        shape.is_of_vertices = false;  // these say how many there are
        check(blocks_.array(array), shape);
        mesh_.positions = blocks_.vec3s(array);
        mesh_.position_step = io::gltf::step_of(elements_of(blocks_.array(array)));
    }

    /// @throws Error bad_file: a type that glTF does not allow; another count than the positions have
    void check(const ArrayInput& array, const Shape& shape) {
        if (shape.is_of_vertices && array.count != mesh_.positions.size())
            fail(format_text("{} has {} elements, but the primitive has {} vertices", shape.name, array.count,
                             mesh_.positions.size()));
        if (array.count == 0) return;
        if (!(shape.types & io::gltf::type_bit(array.type)))
            fail(format_text("{} cannot have components of type {}", shape.name, int(array.type)));
        if (array.components != shape.components)
            fail(format_text("{} cannot have {} components", shape.name, array.components));
    }

    static void store(io::gltf::DirectionTypes& types, Direction direction, const ArrayInput& array) {
        types[direction] = io::gltf::direction_type(array.type, array.is_normalized);
    }

    void take(const AttributeInput& a, io::gltf::DirectionTypes& types) {
        const ArrayInput& array = blocks_.array(a.array);
        check(array, shape_of(a.semantic));
        switch (a.semantic) {
            case Semantic::position:
                break;
            case Semantic::normal:
                store(types, Direction::normal, array);
                mesh_.normals = blocks_.vec3s(a.array);
                break;
            case Semantic::tangent:
                store(types, Direction::tangent, array);
                mesh_.tangents = blocks_.vec4s(a.array);
                break;
            case Semantic::bitangent:
                store(types, Direction::bitangent, array);
                mesh_.arrays.push_back({io::gltf::name_of(Direction::bitangent), array.components,
                                        io::gltf::to_scalars(elements_of(array))});
                break;
            case Semantic::texcoord:
                if (a.set >= mesh_.texcoords.size()) mesh_.texcoords.resize(a.set + 1);
                mesh_.texcoords[a.set] = blocks_.vec2s(a.array);
                break;
            case Semantic::joints:
                influence_set(a.set).joints = io::gltf::to_integers(elements_of(array));
                break;
            case Semantic::weights:
                influence_set(a.set).weights = to_weights(array);
                break;
            case Semantic::indices:
                corners_ = io::gltf::to_integers(elements_of(array));
                break;
        }
    }

    io::gltf::InfluenceSet& influence_set(std::uint32_t number) {
        if (number >= sets_.size()) sets_.resize(number + 1);
        return sets_[number];
    }

    void offset(const AttributeInput& a, io::gltf::StoredDirections& stored) {
        const ArrayInput& array = blocks_.array(a.array);
        if (a.target >= targets_.size()) fail("an array of a morph target that is not there");
        if (a.semantic > Semantic::tangent)
            return remark("morph targets of other arrays than positions, normals and tangents are not used");
        check(array, {"the morph target", io::gltf::float_or_small, 3});
        MorphTarget& target = targets_[a.target];
        const Block<vec3> offsets = blocks_.vec3s(a.array);
        if (a.semantic == Semantic::position) target.positions = offsets;
        if (a.semantic == Semantic::normal) {
            store(stored.targets[a.target], Direction::normal, array);
            target.normals = offsets;
        }
        if (a.semantic == Semantic::tangent) {
            store(stored.targets[a.target], Direction::tangent, array);
            target.tangents = offsets;
        }
    }

    void finish() {
        for (Block<vec2>& texcoords : mesh_.texcoords)
            if (texcoords.empty()) texcoords = std::vector<vec2>(mesh_.positions.size());
        if (!targets_.empty()) mesh_.targets = std::move(targets_);
        take_influences();
        if (!has_indices()) {
            corners_.resize(mesh_.positions.size());
            std::iota(corners_.begin(), corners_.end(), 0u);
        }
        for (std::size_t c = 0; c < corners_.size(); ++c)
            if (corners_[c] >= mesh_.positions.size())
                fail(format_text("index {} at corner {} exceeds {} vertices", corners_[c], c, mesh_.positions.size()));
        mesh_.indices = io::gltf::expand(mode(), std::move(corners_)).indices;
        if (mesh_.indices.empty()) remark("a primitive without corners is left out");
    }

    bool has_indices() const {
        return std::ranges::any_of(primitive_.attributes,
                                   [](const AttributeInput& a) { return a.semantic == Semantic::indices; });
    }

    void take_influences() {
        if (sets_.empty()) return;
        for (const io::gltf::InfluenceSet& s : sets_)
            if (s.joints.size() != 4 * mesh_.positions.size() || s.weights.size() != s.joints.size())
                fail("JOINTS and WEIGHTS must come together, with four for each vertex");
        io::gltf::InfluenceFaults faults;
        io::gltf::Influences influences = io::gltf::strongest_influences(sets_, faults, context_);
        mesh_.influences = std::move(influences.first), mesh_.more_influences = std::move(influences.next);
    }

    const PrimitiveInput& primitive_;
    Blocks& blocks_;
    Context& context_;
    Mesh mesh_;
    std::vector<MorphTarget> targets_;
    std::vector<io::gltf::InfluenceSet> sets_;
    std::vector<std::uint32_t> corners_;
};

Skin skin_of(const SkinInput& input) {
    std::vector<dmat4> inverse_bind(input.joints.size());
    for (std::size_t j = 0; j < inverse_bind.size(); ++j)
        for (std::size_t k = 0; k < 16; ++k) inverse_bind[j][k / 4][k % 4] = input.inverse_bind.at(16 * j + k);
    return {.joints = input.joints, .inverse_bind = std::move(inverse_bind)};
}

Transform transform_of(const NodeInput& input) {
    const std::array<double, 16>& n = input.place;
    Transform transform;
    if (input.is_matrix) {
        dmat4 matrix;
        for (std::size_t k = 0; k < 16; ++k) matrix[k / 4][k % 4] = n[k];
        transform.matrix = matrix;
        return transform;
    }
    transform.translation = {n[0], n[1], n[2]};
    transform.rotation = {n[3], n[4], n[5], n[6]};
    transform.scale = {n[7], n[8], n[9]};
    return transform;
}

}  // namespace

std::string place_of(const std::string& mesh_name, std::uint32_t primitive) {
    return format_text("mesh '{}', primitive {}", one_line(mesh_name, 60), primitive);
}

InputScene make_scene(const DocumentInput& input, Context& context) {
    InputScene made;
    Scene& scene = made.scene;
    Blocks blocks(input.arrays);
    std::map<std::uint32_t, std::vector<std::uint32_t>> meshes;  // of the document -> of the scene
    for (const PrimitiveInput& primitive : input.primitives) {
        io::gltf::StoredDirections stored;
        Mesh mesh = MeshMaker(primitive, blocks, context).make(stored);
        if (mesh.indices.empty()) continue;
        meshes[primitive.mesh].push_back(std::uint32_t(scene.meshes.size()));
        scene.meshes.push_back(std::move(mesh));
        made.stored.push_back(std::move(stored));
    }
    scene.materials = input.materials;
    scene.textures.push_back({.image = ImageHandle(std::make_shared<const EncodedImage>())});
    for (const SkinInput& skin : input.skins) scene.skins.push_back(skin_of(skin));
    for (const NodeInput& node : input.nodes) {
        Node& out = scene.nodes.emplace_back();
        out.parent = node.parent;
        out.source_node = node.source_node;
        out.local = transform_of(node);
        const auto shown = meshes.find(node.mesh);
        if (shown == meshes.end()) continue;
        out.meshes = shown->second;
        const std::size_t targets = scene.meshes[out.meshes[0]].targets.size();
        for (const std::uint32_t m : out.meshes)
            if (scene.meshes[m].targets.size() != targets)
                throw Error(ErrorCode::bad_file, "its primitives have different numbers of morph targets",
                            place_of(scene.meshes[m].name, scene.meshes[m].source_primitive));
        if (targets > 0) out.morph_weights = std::vector<float>(targets);
        std::uint32_t used = 0;
        for (const std::uint32_t m : out.meshes) used = std::max(used, io::gltf::joints_used(scene.meshes[m]));
        if (used == 0 || node.skin == no_index) continue;
        if (node.skin >= scene.skins.size() || used > scene.skins[node.skin].joints.size())
            throw Error(ErrorCode::bad_file, "its skin has too few joints for it",
                        format_text("mesh '{}'", one_line(scene.meshes[out.meshes[0]].name, 60)));
        out.skin = node.skin;
    }
    validate(scene);
    return made;
}

}  // namespace rakelight::web
