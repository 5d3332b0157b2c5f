// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/save_primitive.h"

#include <algorithm>

namespace rakelight::io::gltf {
namespace {

constexpr const char* draco_name = "KHR_draco_mesh_compression";
constexpr std::uint32_t any_components = components(1) | components(2) | components(3) | components(4) | components(16);
constexpr std::uint32_t any_type = float_or_small | unsigned_types;

bool same_indices(const Mesh& a, const Mesh& b) {
    return a.indices == b.indices || std::equal(a.indices.begin(), a.indices.end(), b.indices.begin(), b.indices.end());
}

void erase_extension(OrderedJson& owner, const char* name) {
    const auto extensions = owner.find("extensions");
    if (extensions == owner.end()) return;
    extensions->erase(name);
    if (extensions->empty()) owner.erase("extensions");
}

}  // namespace

std::vector<std::uint32_t> copied_vertices(const Mesh& before, const Mesh& after) {
    const std::size_t old_count = before.positions.size();
    std::vector<std::uint32_t> copied(after.positions.size() - old_count, 0);
    for (std::size_t c = 0; c < after.indices.size(); ++c)
        if (after.indices[c] >= old_count) copied[after.indices[c] - old_count] = before.indices[c];
    return copied;
}

ComponentType PrimitiveEditor::index_type(const Value& source) const {
    if (!source.has("indices")) return ComponentType::u16;
    return accessors_.description(source.required_index("indices"), {"indices", components(1), unsigned_types}, source)
        .type;
}

void PrimitiveEditor::extend(OrderedJson& owner, const Value& source, VertexData& vertices, bool is_target,
                             std::span<const std::uint32_t> copied) {
    for (auto& [name, accessor] : owner.items()) {
        if (!is_target && (name == "NORMAL" || name == "TANGENT")) continue;  // made anew
        const std::uint32_t old = source.required_index(name.c_str());
        const Elements elements = is_target
                                      ? accessors_.elements(old, {"a morph target", any_components, any_type}, source)
                                      : *vertices.elements(name, any_components, any_type);
        accessors_.document().context().memory().check((elements.count + copied.size()) * 64, "splitting vertices");
        // The parts of root_ move when accessors are added: the old one is copied first.
        const OrderedJson model = root_["accessors"][old];
        accessor = data_.extended(elements, copied, model);
    }
}

PrimitiveEdit PrimitiveEditor::edit(OrderedJson& json, const Value& source, const Mesh& before, const Mesh& after) {
    PrimitiveEdit result;
    const std::vector<std::uint32_t> copied = copied_vertices(before, after);
    OrderedJson& attributes = json["attributes"];
    result.unpacked = bool(source.extension(draco_name));

    // 1. the other attributes and the morph targets
    const Value targets = source.list("targets");
    if (!copied.empty() || result.unpacked) {
        VertexData vertices(accessors_, cache_, source);
        const auto positions = vertices.elements("POSITION", any_components, any_type);
        if (!positions || positions->count != before.positions.size())
            source.fail("the file changed while it was worked on");
        extend(attributes, source.object("attributes"), vertices, false, copied);
        if (!copied.empty())
            for (std::size_t t = 0; t < targets.size(); ++t)
                extend(json["targets"][t], targets.element(t), vertices, true, copied);
    }

    // 2. normals and tangents
    attributes["NORMAL"] = data_.normals(after.normals);
    if (!after.tangents.empty()) {
        attributes["TANGENT"] = data_.tangents(after.tangents);
    } else if (attributes.contains("TANGENT")) {
        result.tangents_removed = true;
        attributes.erase("TANGENT");
        for (std::size_t t = 0; t < targets.size(); ++t) json["targets"][t].erase("TANGENT");  // offsets from nothing
    }
    for (std::size_t t = 0; t < targets.size(); ++t)
        result.keeps_target_normals = result.keeps_target_normals || targets.element(t).has("NORMAL");

    // 3. corners; strips and fans become lists, since their corners cannot be told apart
    if (!same_indices(before, after) || result.unpacked) {
        json["indices"] = data_.indices(after.indices, index_type(source));
        json.erase("mode");
    }
    if (result.unpacked) erase_extension(json, draco_name);
    return result;
}

}  // namespace rakelight::io::gltf
