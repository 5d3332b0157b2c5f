// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/vertex_data.h"

#include <numeric>

#include "base/format_text.h"

namespace rakelight::io::gltf {
namespace {

/// The largest value of a type is forbidden: some systems take it as the end of a strip.
std::uint32_t restart_value(ComponentType type) {
    return type == ComponentType::u8 ? 0xFFu : type == ComponentType::u16 ? 0xFFFFu : 0xFFFFFFFFu;
}

void check_corners(const std::vector<std::uint32_t>& corners, std::uint64_t vertices, std::uint32_t restart,
                   const Value& primitive) {
    for (std::size_t i = 0; i < corners.size(); ++i)
        if (corners[i] >= vertices)
            primitive.fail(corners[i] == restart
                               ? format_text("index {} at corner {} is the primitive restart value, which glTF forbids",
                                             restart, i)
                               : format_text("index {} at corner {} exceeds {} vertices", corners[i], i, vertices));
}

}  // namespace

VertexData::VertexData(Accessors& accessors, BlockCache& cache, const Value& primitive)
    : accessors_(accessors), cache_(cache), primitive_(primitive), attributes_(primitive.object("attributes")) {
    const Value packed = primitive.extension("KHR_draco_mesh_compression");
    if (!packed) return;
    packed_attributes_ = packed.object("attributes");
    const Region region = accessors_.buffers().view(packed.required_index("bufferView"), primitive_);
    draco_ = decode_draco(region.bytes, primitive_, document().context());
    count_ = draco_->vertex_count();
}

void VertexData::check_count(std::uint64_t count, const std::string& semantic) {
    if (!count_) count_ = count;
    if (*count_ != count)
        primitive_.fail(format_text("{} has {} elements, but the primitive has {} vertices", semantic, count, *count_));
    if (count >= no_index) primitive_.fail(std::to_string(count) + " vertices are more than indices can address");
}

std::optional<Elements> VertexData::find(const Value& owner, const std::string& semantic, const Expected& expected) {
    if (!owner.has(semantic.c_str())) return std::nullopt;
    const std::uint32_t accessor = owner.required_index(semantic.c_str());
    const bool is_packed = draco_ && packed_attributes_.has(semantic.c_str());
    const Elements found = is_packed ? draco_->attribute(packed_attributes_.required_index(semantic.c_str()),
                                                         accessors_.description(accessor, expected, primitive_),
                                                         primitive_, document().context())
                                     : accessors_.elements(accessor, expected, primitive_);
    check_count(found.count, semantic);
    return found;
}

std::optional<Elements> VertexData::elements(const std::string& semantic, std::uint32_t component_counts,
                                             std::uint32_t types) {
    return find(attributes_, semantic, {semantic.c_str(), component_counts, types});
}

template <class T, class Make>
Block<T> VertexData::block(std::map<std::uint32_t, Block<T>>& cache, const Value& owner, const std::string& semantic,
                           std::uint32_t component_counts, Make make) {
    if (!owner.has(semantic.c_str())) return {};
    const std::uint32_t accessor = owner.required_index(semantic.c_str());
    if (!draco_)
        if (const auto known = cache.find(accessor); known != cache.end()) {
            check_count(known->second.size(), semantic);
            return known->second;
        }
    const auto found = find(owner, semantic, {semantic.c_str(), component_counts, float_or_small});
    MemoryCharge charge(document().context().memory(), found->count * sizeof(T), "vertex data");
    Block<T> made(make(*found), std::move(charge));
    if (!draco_) cache.emplace(accessor, made);
    return made;
}

Block<vec2> VertexData::vec2s(const std::string& semantic) {
    return block(cache_.vec2s, attributes_, semantic, components(2), to_vec2);
}
Block<vec3> VertexData::vec3s(const std::string& semantic) {
    return block(cache_.vec3s, attributes_, semantic, components(3), to_vec3);
}

Block<vec4> VertexData::tangents() {
    return block(cache_.tangents, attributes_, "TANGENT", components(4),
                 [](const Elements& e) { return to_vec4(e, 1); });
}

Block<vec4> VertexData::colors() {
    return block(cache_.colors, attributes_, "COLOR_0", components(3) | components(4), [this](Elements e) {
        if (e.type != ComponentType::f32 && !e.normalized) {
            e.normalized = true;
            document().remark(Remark::guessed, primitive_.place(),
                              "integer vertex colors that are not marked as normalized are read as 0..1");
        }
        return to_vec4(e, 1);
    });
}

void VertexData::read_array(const std::string& name, Mesh& mesh) {
    std::optional<Elements> found;
    try {
        found = elements(name, components(1) | components(2) | components(3) | components(4),
                         float_or_small | unsigned_types);
    } catch (const Error& error) {  // no picture needs them but one that asks for them
        if (error.code() != ErrorCode::bad_file) throw;
        return document().remark(Remark::dropped, primitive_.place(),
                                 "the numbers " + one_line(name, 40) + " are left out: " + error.reason());
    }
    if (!found || found->count == 0) return;
    const std::uint32_t accessor = attributes_.required_index(name.c_str());
    const auto known = draco_ ? cache_.scalars.end() : cache_.scalars.find(accessor);
    if (known != cache_.scalars.end()) {
        mesh.arrays.push_back({name, found->components, known->second});
        return;
    }
    MemoryCharge charge(document().context().memory(), found->count * found->components * sizeof(float), "vertex data");
    Block<float> values(to_scalars(*found), std::move(charge));
    if (!draco_) cache_.scalars.emplace(accessor, values);
    mesh.arrays.push_back({name, found->components, std::move(values)});
}

double VertexData::position_step() {
    const char* const name = "POSITION";
    const bool is_packed = draco_ && packed_attributes_.has(name);
    const double packed = is_packed ? draco_->step(packed_attributes_.required_index(name)) : 0;
    if (packed > 0) return packed;
    const Expected expected{name, components(3), float_or_small};
    const std::uint32_t accessor = attributes_.required_index(name);
    const Elements described = accessors_.description(accessor, expected, primitive_);
    if (is_packed || described.type == ComponentType::f32) return step_of(described);
    const auto [step, is_new] = cache_.steps.emplace(accessor, 0);
    if (is_new) step->second = step_of(accessors_.elements(accessor, expected, primitive_));
    return step->second;
}

Block<vec3> VertexData::offsets(const Value& target, const std::string& semantic) {
    if (!target.has(semantic.c_str())) return {};
    const std::uint32_t accessor = target.required_index(semantic.c_str());
    if (const auto known = cache_.vec3s.find(accessor); known != cache_.vec3s.end()) {
        check_count(known->second.size(), semantic);
        return known->second;
    }
    const Elements found = accessors_.elements(accessor, {"a morph target", components(3), float_or_small}, primitive_);
    check_count(found.count, "the morph target's " + semantic);
    MemoryCharge charge(document().context().memory(), found.count * sizeof(vec3), "morph targets");
    return cache_.vec3s.emplace(accessor, Block<vec3>(to_vec3(found), std::move(charge))).first->second;
}

std::vector<std::uint32_t> VertexData::corners(MemoryCharge& charge) {
    if (draco_) {
        std::vector<std::uint32_t> unpacked = draco_->indices();
        charge.grow(unpacked.size() * sizeof(std::uint32_t), "indices");
        return unpacked;
    }
    if (!primitive_.has("indices")) {
        charge.grow(vertex_count() * sizeof(std::uint32_t), "indices");
        std::vector<std::uint32_t> each_once(static_cast<std::size_t>(vertex_count()));
        std::iota(each_once.begin(), each_once.end(), 0u);
        return each_once;
    }
    const Elements elements = accessors_.elements(primitive_.required_index("indices"),
                                                  {"indices", components(1), unsigned_types}, primitive_);
    charge.grow(elements.count * sizeof(std::uint32_t), "indices");
    std::vector<std::uint32_t> read = to_integers(elements);
    check_corners(read, vertex_count(), restart_value(elements.type), primitive_);
    return read;
}

}  // namespace rakelight::io::gltf
