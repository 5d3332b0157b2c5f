// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/write/save_primitive.h"

#include <algorithm>
#include <map>
#include <string_view>

#include <nlohmann/json.hpp>

#include "io/gltf/write/save_meshopt.h"

namespace rakelight::io::gltf {
namespace {

constexpr const char* draco_name = "KHR_draco_mesh_compression";
constexpr std::uint32_t any_components = components(1) | components(2) | components(3) | components(4) | components(16);
constexpr std::uint32_t any_type = float_or_small | unsigned_types;

void erase_extension(OrderedJson& owner, const char* name) {
    const auto extensions = owner.find("extensions");
    if (extensions == owner.end()) return;
    extensions->erase(name);
    if (extensions->empty()) owner.erase("extensions");
}

}  // namespace

ComponentType PrimitiveEditor::index_type(const Value& source) const {
    if (!source.has("indices")) return ComponentType::u16;
    return accessors_.description(source.required_index("indices"), {"indices", components(1), unsigned_types}, source)
        .type;
}

/// @param target  what a morph target becomes, or null: `owner` holds the attributes of the primitive itself
void PrimitiveEditor::extend(OrderedJson& owner, const Value& source, VertexData& vertices,
                             std::span<const std::uint32_t> copied, const MorphTarget* target) {
    for (auto& [name, accessor] : owner.items()) {
        const bool made_anew = name == "NORMAL"    ? !target || !target->normals.empty()
                               : name == "TANGENT" ? !target || !target->tangents.empty()
                                                   : false;
        if (made_anew) continue;
        const std::uint32_t old = source.required_index(name.c_str());
        const Elements elements = target
                                      ? accessors_.elements(old, {"a morph target", any_components, any_type}, source)
                                      : *vertices.elements(name, any_components, any_type);
        accessors_.document().context().memory().check((elements.count + copied.size()) * 64, "splitting vertices");
        // The parts of root_ move when accessors are added: the old one is copied first.
        const OrderedJson model = root_["accessors"][old];
        data_.compress_as(compression_of(old));
        accessor = data_.extended(elements, copied, model);
    }
}

void PrimitiveEditor::put_offsets(OrderedJson& json, const char* name, const Block<vec3>& offsets, bool may_overwrite) {
    if (offsets.empty()) return;
    const std::span<const float> numbers{&offsets[0].x, 3 * offsets.size()};
    const auto old = json.find(name);
    const bool is_done = may_overwrite && old != json.end() &&
                         own_.replace(root_, old->get<std::size_t>(), numbers, 3, ComponentType::f32);
    if (is_done) return;
    data_.compress_as(old == json.end() ? std::string() : compression_of(*old));
    json[name] = data_.directions(numbers, 3, ComponentType::f32);
}

void PrimitiveEditor::put_target(OrderedJson& json, const MorphTarget& target, bool may_overwrite) {
    put_offsets(json, "NORMAL", target.normals, may_overwrite);
    put_offsets(json, "TANGENT", target.tangents, may_overwrite);
}

void PrimitiveEditor::put(OrderedJson& attributes, Direction direction, std::span<const float> numbers,
                          ComponentType type, bool may_overwrite) {
    const char* const name = name_of(direction);
    const std::uint32_t width = width_of(direction);
    const auto old = attributes.find(name);
    if (may_overwrite && old != attributes.end() && own_.replace(root_, old->get<std::size_t>(), numbers, width, type))
        return;
    data_.compress_as(old == attributes.end() ? std::string() : compression_of(*old));
    attributes[name] = data_.directions(numbers, width, type);
}

/// The meshopt extension of an accessor's view, or "".
/// @param accessor  the number of one, or anything: attributes that are not read were never checked
std::string PrimitiveEditor::compression_of(const OrderedJson& accessor) const {
    const auto part = [&](const char* list, const OrderedJson& number) -> const OrderedJson* {
        const auto found = root_.find(list);
        const bool is_there = found != root_.end() && found->is_array() && number.is_number_unsigned() &&
                              number.get<std::uint64_t>() < found->size();
        return is_there ? &(*found)[number.get<std::size_t>()] : nullptr;
    };
    const OrderedJson* json = part("accessors", accessor);
    const OrderedJson* view =
        json && json->contains("bufferView") ? part("bufferViews", (*json)["bufferView"]) : nullptr;
    return view ? meshopt_extension(*view) : std::string();
}

/// Whether an attribute that was compressed no longer is. An ordered object searches names linearly, so they are
/// sorted once: the cost of many attributes stays that of reading them.
bool PrimitiveEditor::is_plain_now(const OrderedJson& before, const OrderedJson& now) const {
    std::map<std::string_view, const OrderedJson*> accessors;
    for (const auto& [name, accessor] : now.get_ref<const OrderedJson::object_t&>()) accessors.emplace(name, &accessor);
    for (const auto& [name, accessor] : before.get_ref<const OrderedJson::object_t&>()) {
        const auto found = accessors.find(name);
        if (found != accessors.end() && *found->second != accessor && !compression_of(accessor).empty() &&
            compression_of(*found->second).empty())
            return true;
    }
    return false;
}

PrimitiveEdit PrimitiveEditor::edit(OrderedJson& json, const Value& source, const Mesh& before, const Mesh& after,
                                    const PrimitiveChange& change, bool may_overwrite) {
    PrimitiveEdit result;
    const OrderedJson old = json;
    const std::vector<std::uint32_t>& copied = change.copied;
    const std::vector<MorphTarget>& fresh = change.targets;
    OrderedJson& attributes = json["attributes"];
    result.unpacked = bool(source.extension(draco_name));

    // 1. the other attributes and the morph targets
    const Value targets = source.list("targets");
    if (fresh.size() != targets.size() || before.targets.size() != targets.size())
        source.fail("the file changed while it was being processed");
    if (!copied.empty() || result.unpacked) {
        VertexData vertices(accessors_, cache_, source);
        const auto positions = vertices.elements("POSITION", any_components, any_type);
        if (!positions || positions->count != before.positions.size())
            source.fail("the file changed while it was being processed");
        extend(attributes, source.object("attributes"), vertices, copied, nullptr);
        if (!copied.empty())
            for (std::size_t t = 0; t < targets.size(); ++t)
                extend(json["targets"][t], targets.element(t), vertices, copied, &fresh[t]);
    }

    // 2. normals and tangents
    const auto put_new = [&](Direction direction, const auto& block) {
        put(attributes, direction, {&block[0].x, block.size() * width_of(direction)}, change.types[direction],
            may_overwrite);
    };
    put_new(Direction::normal, after.normals);
    if (!after.tangents.empty()) {
        put_new(Direction::tangent, after.tangents);
    } else if (change.tangents_removed) {
        attributes.erase(name_of(Direction::tangent));
        for (std::size_t t = 0; t < targets.size(); ++t)  // offsets from nothing
            json["targets"][t].erase(name_of(Direction::tangent));
    }
    if (!after.bitangents.empty()) put_new(Direction::bitangent, after.bitangents);
    for (std::size_t t = 0; t < targets.size(); ++t) put_target(json["targets"][t], fresh[t], may_overwrite);

    // 3. corners
    if (change.corners || result.unpacked) {
        data_.compress_as(compression_of(old.value("indices", OrderedJson())));
        json["indices"] = data_.indices(after.indices, index_type(source));
        json.erase("mode");
    }
    if (result.unpacked) erase_extension(json, draco_name);
    result.plain = is_plain_now(old["attributes"], json["attributes"]);  // `attributes` moved when members were added
    return result;
}

}  // namespace rakelight::io::gltf
