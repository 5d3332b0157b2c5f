// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/nodes.h"

#include <algorithm>
#include <cmath>

#include <rakelight_internal/base/text.h>

#include "base/format_text.h"
#include "io/gltf/transform.h"
#include "scene/charge_arrays.h"

namespace rakelight::io::gltf {
namespace {

/// What a node holds for each of its meshes.
constexpr std::uint64_t bytes_per_placement = sizeof(std::uint32_t) + 16;

std::vector<std::uint32_t> indices_of(const Value& list) {
    std::vector<std::uint32_t> result(list.size());
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = list.index_at(i);
    return result;
}

}  // namespace

std::vector<Nodes::Waiting> Nodes::roots() {
    const Value& root = document().root();
    roots_from_ = root;
    std::vector<Waiting> result;
    if (document().count(scene_kind) > 0 || root.has("scene")) {
        const std::uint32_t chosen = root.index("scene");
        const Value scene = document().element(scene_kind, chosen == no_index ? 0 : chosen, root);
        for (const std::uint32_t node : indices_of(scene.list("nodes"))) result.push_back({node, no_index});
        roots_from_ = scene;
        return result;
    }
    const std::size_t count = document().count(node_kind);
    std::vector<bool> is_child(count, false);
    for (std::uint32_t n = 0; n < count; ++n) {
        const Value node = document().element(node_kind, n, root);
        for (const std::uint32_t child : indices_of(node.list("children")))
            if (child < count) is_child[child] = true;
    }
    for (std::uint32_t n = 0; n < count; ++n)
        if (!is_child[n]) result.push_back({n, no_index});
    if (count > 0) document().remark(Remark::guessed, {}, "the file has no scene; all its root nodes are shown");
    return result;
}

void Nodes::read() {
    scene_of_.assign(document().count(node_kind), no_index);
    std::vector<Waiting> stack = roots();
    std::reverse(stack.begin(), stack.end());
    while (!stack.empty()) {
        const Waiting next = stack.back();
        stack.pop_back();
        place(next, stack);
    }
    say_what_other_scenes_show();
}

void Nodes::say_what_other_scenes_show() const {
    const Value& root = document().root();
    std::uint64_t unplaced = 0;  // nodes with meshes
    std::vector<bool> is_seen(scene_of_.size(), false);
    std::vector<std::uint32_t> stack;
    const auto add = [&](const Value& list) {
        for (const std::uint32_t node : indices_of(list))
            if (node < is_seen.size() && !is_seen[node]) is_seen[node] = true, stack.push_back(node);
    };
    try {
        for (std::uint32_t s = 0; s < document().count(scene_kind); ++s)
            add(document().element(scene_kind, s, root).list("nodes"));
        while (!stack.empty()) {
            const std::uint32_t number = stack.back();
            const Value node = document().element(node_kind, number, root);
            stack.pop_back();
            unplaced += scene_of_[number] == no_index && node.has("mesh");
            add(node.list("children"));
        }
    } catch (const Error&) {  // what is not read may be broken
    }
    if (unplaced > 0)
        document().remark(Remark::dropped, {},
                          format_text("only the default scene is read: {} with a mesh {} in other scenes alone",
                                      counted(unplaced, "node"), unplaced == 1 ? "is" : "are"));
}

void Nodes::place(const Waiting& waiting, std::vector<Waiting>& stack) {
    const Value from = waiting.parent == no_index
                           ? roots_from_
                           : document().element(node_kind, scene_.nodes[waiting.parent].source_node, roots_from_);
    const Value source = document().element(node_kind, waiting.file, from);
    if (scene_of_[waiting.file] != no_index)
        throw Error(ErrorCode::bad_file,
                    "it is placed twice: the node hierarchy has a cycle or a node with two parents", source.place());
    MemoryCharge& charge = document().scene_charge();
    charge.grow(sizeof(Node) + bytes_beside_node, "nodes");
    const auto index = std::uint32_t(scene_.nodes.size());
    scene_of_[waiting.file] = index;
    placed_.push_back({waiting.file, index});
    Node node;
    node.name = Document::name_of(source, node_kind, waiting.file);
    node.parent = waiting.parent;
    node.local = read_transform(document(), source);
    node.source_node = waiting.file;
    scene_.nodes.push_back(std::move(node));
    attach_mesh(source, index);
    const std::vector<std::uint32_t> children = indices_of(source.list("children"));
    charge.grow(children.size() * (sizeof(Waiting) + sizeof(std::uint32_t)), "nodes");
    for (auto child = children.rbegin(); child != children.rend(); ++child) stack.push_back({*child, index});
}

void Nodes::attach_mesh(const Value& source, std::uint32_t node) {
    const std::uint32_t mesh = source.index("mesh");
    if (mesh == no_index) return;
    const LoadedMesh& loaded = meshes_.load(mesh, source);
    document().scene_charge().grow(loaded.meshes.size() * bytes_per_placement, "placed meshes");
    scene_.nodes[node].meshes = loaded.meshes;
    scene_.nodes[node].morph_weights = loaded.default_weights;
    if (std::vector<float> own = source.reals("weights"); own.size() != loaded.default_weights.size()) {
        if (!own.empty())
            document().remark(Remark::dropped, source.place(),
                              "its number of morph weights is not that of its mesh's targets");
    } else if (!own.empty()) {
        MemoryCharge charge(document().context().memory(), own.size() * sizeof(float), "morph weights");
        scene_.nodes[node].morph_weights = {std::move(own), std::move(charge)};
    }
    if (const Value instancing = source.extension("EXT_mesh_gpu_instancing")) add_instances(source, instancing, node);
}

/// EXT_mesh_gpu_instancing: each instance becomes a child that shares the meshes; the node itself then holds none.
void Nodes::add_instances(const Value& source, const Value& extension, std::uint32_t node) {
    const Value attributes = extension.object("attributes");
    std::optional<std::uint64_t> count;
    MemoryCharge arrays(document().context().memory());
    const auto read = [&](const char* name, std::uint32_t width) {
        std::vector<float> values;
        const std::uint32_t accessor = attributes.index(name);
        if (accessor == no_index) return values;
        const Elements elements = accessors_.elements(accessor, {name, components(width), float_or_small}, source);
        if (count.value_or(elements.count) != elements.count)
            source.fail("its instance attributes have different counts");
        count = elements.count;
        arrays.grow(elements.count * width * sizeof(float), "instances");
        values = to_scalars(elements);
        if (!std::all_of(values.begin(), values.end(), [](float v) { return std::isfinite(v); }))
            source.fail(std::string("its instances have a ") + name + " that is not finite");
        return values;
    };
    const std::vector<float> t = read("TRANSLATION", 3), r = read("ROTATION", 4), s = read("SCALE", 3);
    if (!count) return;
    const Node group = scene_.nodes[node];
    scene_.nodes[node].meshes.clear();
    scene_.nodes[node].morph_weights = {};
    const std::uint64_t each =
        sizeof(Node) + bytes_beside_node + 64 + group.name.size() + group.meshes.size() * bytes_per_placement;
    if (*count > (1ull << 40) / each) source.fail(std::to_string(*count) + " instances are too many");
    document().scene_charge().grow(*count * each, "instances");
    scene_.nodes.reserve(scene_.nodes.size() + *count);  // many: doubling would take three times what was charged
    for (std::size_t i = 0; i < *count; ++i) {
        Node instance;
        instance.name = format_text("{} instance {}", group.name, i);
        instance.parent = node;
        instance.meshes = group.meshes;
        instance.morph_weights = group.morph_weights;
        instance.source_node = group.source_node;
        if (!t.empty()) instance.local.translation = {t[3 * i], t[3 * i + 1], t[3 * i + 2]};
        if (!r.empty()) instance.local.rotation = {r[4 * i], r[4 * i + 1], r[4 * i + 2], r[4 * i + 3]};
        if (!s.empty()) instance.local.scale = {s[3 * i], s[3 * i + 1], s[3 * i + 2]};
        scene_.nodes.push_back(std::move(instance));
    }
}

}  // namespace rakelight::io::gltf
