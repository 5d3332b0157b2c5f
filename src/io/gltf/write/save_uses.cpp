// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/write/save_uses.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>
#include <string_view>

#include <nlohmann/json.hpp>

#include "io/gltf/write/save_storage.h"

namespace rakelight::io::gltf {
namespace {

const OrderedJson nothing = OrderedJson::array();

const OrderedJson& member(const OrderedJson& owner, const char* name) {
    if (!owner.is_object()) return nothing;
    const auto found = owner.find(name);
    return found == owner.end() ? nothing : *found;
}

const OrderedJson& list(const OrderedJson& owner, const char* name) {
    const OrderedJson& found = member(owner, name);
    return found.is_array() ? found : nothing;
}

/// A number of the file that is a count or an index. Parts that are not drawn were never checked: nothing is taken on
/// trust.
std::optional<std::uint64_t> whole(const OrderedJson& value) {
    if (value.is_number_unsigned()) return value.get<std::uint64_t>();
    const double x = value.is_number() ? value.get<double>() : -1;
    if (!(x >= 0 && x <= 9007199254740992.0) || std::floor(x) != x) return std::nullopt;
    return std::uint64_t(x);
}

std::optional<std::uint64_t> whole(const OrderedJson& owner, const char* name) { return whole(member(owner, name)); }

std::uint64_t whole_or(const OrderedJson& owner, const char* name, std::uint64_t fallback) {
    return owner.is_object() && owner.contains(name) ? whole(owner, name).value_or(~0ull) : fallback;
}

/// Extensions whose references to accessors are known here, or that have none.
bool is_known_extension(std::string_view name) {
    for (const std::string_view family :
         {"KHR_materials_", "KHR_texture_", "EXT_texture_", "MSFT_texture_", "KHR_lights_", "KHR_xmp"})
        if (name.starts_with(family)) return true;
    static constexpr std::array<std::string_view, 7> known = {
        "KHR_mesh_quantization",   "KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression",
        "EXT_mesh_gpu_instancing", "KHR_animation_pointer",      "KHR_node_visibility"};
    return std::find(known.begin(), known.end(), name) != known.end();
}

/// Some object of the file holds an extension that is not known, whether or not the file lists it; without recursion.
bool has_unlisted_extension(const OrderedJson& tree) {
    std::vector<const OrderedJson*> waiting{&tree};
    while (!waiting.empty()) {
        const OrderedJson& at = *waiting.back();
        waiting.pop_back();
        if (!at.is_object() && !at.is_array()) continue;
        for (const auto& [name, value] : at.items()) {
            if (at.is_object() && name == "extras") continue;
            if (at.is_object() && name == "extensions" && value.is_object())
                for (const auto& [extension, unused] : value.items())
                    if (!is_known_extension(extension)) return true;
            waiting.push_back(&value);
        }
    }
    return false;
}

std::uint32_t width_of(const OrderedJson& accessor) {
    static const std::map<std::string, std::uint32_t, std::less<>> widths = {
        {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}, {"MAT4", 16}};
    const OrderedJson& type = member(accessor, "type");
    const auto found = type.is_string() ? widths.find(type.get_ref<const std::string&>()) : widths.end();
    return found == widths.end() ? 0 : found->second;
}

std::uint32_t element_bytes(const OrderedJson& accessor) {
    const std::uint64_t type = whole(accessor, "componentType").value_or(0);
    if (type < 5120 || type > 5126 || type == 5124) return 0;
    return width_of(accessor) * size_of(ComponentType(type));
}

bool is_compressed(const OrderedJson& view) {
    const OrderedJson& extensions = member(view, "extensions");
    return extensions.is_object() && !extensions.empty();
}

/// Marks the views that anything but the elements of accessors lies in.
std::vector<bool> other_views(const OrderedJson& tree) {
    std::vector<bool> marked(list(tree, "bufferViews").size(), false);
    const auto mark = [&](const OrderedJson& owner) {
        if (const auto view = whole(owner, "bufferView"); view && *view < marked.size())
            marked[std::size_t(*view)] = true;
    };
    for (const OrderedJson& image : list(tree, "images")) mark(image);
    for (const OrderedJson& accessor : list(tree, "accessors"))
        for (const char* part : {"indices", "values"}) mark(member(member(accessor, "sparse"), part));
    for (const OrderedJson& mesh : list(tree, "meshes"))
        for (const OrderedJson& primitive : list(mesh, "primitives"))
            for (const OrderedJson& extension : member(primitive, "extensions")) mark(extension);
    return marked;
}

/// Views of buffer 0 that no other view overlaps, compressed data counted.
std::vector<bool> lone_views(const OrderedJson& tree) {
    struct Span {
        std::uint64_t begin, end;
        std::size_t view;
    };
    const OrderedJson& views = list(tree, "bufferViews");
    std::vector<Span> spans;
    std::vector<bool> alone(views.size(), false);
    const auto add = [&](const OrderedJson& place, std::size_t view) {
        if (whole(place, "buffer") != 0u) return false;
        const std::uint64_t begin = whole_or(place, "byteOffset", 0), length = whole_or(place, "byteLength", 0);
        spans.push_back({begin, length > ~begin ? ~0ull : begin + length, view});
        return true;
    };
    for (std::size_t v = 0; v < views.size(); ++v) {
        alone[v] = add(views[v], v) && !is_compressed(views[v]);
        for (const OrderedJson& extension : member(views[v], "extensions")) add(extension, v);
    }
    std::sort(spans.begin(), spans.end(), [](const Span& a, const Span& b) { return a.begin < b.begin; });
    std::size_t reaching = 0;  // of the spans so far, the one that ends last
    for (std::size_t i = 1; i < spans.size(); ++i) {
        if (spans[i].begin < spans[reaching].end) alone[spans[i].view] = alone[spans[reaching].view] = false;
        if (spans[i].end > spans[reaching].end) reaching = i;
    }
    return alone;
}

}  // namespace

AccessorUses::AccessorUses(const OrderedJson& tree)
    : counts_(list(tree, "accessors").size(), 0), are_all_known_(!has_unlisted_extension(tree)) {
    for (const OrderedJson& name : list(tree, "extensionsUsed"))
        are_all_known_ = are_all_known_ && name.is_string() && is_known_extension(name.get_ref<const std::string&>());
    for (const OrderedJson& mesh : list(tree, "meshes"))
        for (const OrderedJson& primitive : list(mesh, "primitives")) {
            add(primitive, "indices");
            add_members(primitive, "attributes");
            for (const OrderedJson& target : list(primitive, "targets"))
                for (const OrderedJson& value : target)
                    if (const auto index = whole(value); index && *index < counts_.size())
                        ++counts_[std::size_t(*index)];
        }
    for (const OrderedJson& skin : list(tree, "skins")) add(skin, "inverseBindMatrices");
    for (const OrderedJson& animation : list(tree, "animations"))
        for (const OrderedJson& sampler : list(animation, "samplers")) add(sampler, "input"), add(sampler, "output");
    for (const OrderedJson& node : list(tree, "nodes"))
        add_members(member(member(node, "extensions"), "EXT_mesh_gpu_instancing"), "attributes");
}

void AccessorUses::add(const OrderedJson& owner, const char* name) {
    if (const auto index = whole(owner, name); index && *index < counts_.size()) ++counts_[std::size_t(*index)];
}

void AccessorUses::add_members(const OrderedJson& owner, const char* name) {
    for (const OrderedJson& value : member(owner, name))
        if (const auto index = whole(value); index && *index < counts_.size()) ++counts_[std::size_t(*index)];
}

OwnArrays::OwnArrays(const OrderedJson& tree, const AccessorUses& uses, std::span<std::byte> binary)
    : arrays_(uses.accessors()), binary_(binary) {
    if (!uses.are_all_known() || binary.empty()) return;
    find_arrays(tree);
    keep_apart(tree, uses);
}

void OwnArrays::find_arrays(const OrderedJson& tree) {
    const OrderedJson &accessors = list(tree, "accessors"), &views = list(tree, "bufferViews");
    for (std::size_t a = 0; a < arrays_.size(); ++a) {
        const auto view = whole(accessors[a], "bufferView");
        if (!view || *view >= views.size()) continue;
        const OrderedJson& v = views[std::size_t(*view)];
        const std::uint64_t size = element_bytes(accessors[a]), count = whole_or(accessors[a], "count", 0),
                            stride = whole_or(v, "byteStride", size);
        const std::uint64_t from = whole_or(v, "byteOffset", 0), at = whole_or(accessors[a], "byteOffset", 0);
        Array& array = arrays_[a];
        array.view = std::size_t(*view);
        array.begin = std::min<std::uint64_t>(from, binary_.size());
        array.end = binary_.size();  // what cannot be made out counts as everything
        const bool is_sound = size > 0 && count > 0 && stride >= size && stride <= 1024 && from <= binary_.size() &&
                              at <= binary_.size() - from && binary_.size() - from - at >= size &&
                              (count - 1) <= (binary_.size() - from - at - size) / stride;
        if (!is_sound) continue;
        array.begin = from + at;
        array.end = array.begin + (count - 1) * stride + size;
        array.stride = std::uint32_t(stride);
    }
}

void OwnArrays::keep_apart(const OrderedJson& tree, const AccessorUses& uses) {
    const std::vector<bool> alone = lone_views(tree), others = other_views(tree);
    std::vector<std::vector<std::size_t>> in_view(alone.size());
    for (std::size_t a = 0; a < arrays_.size(); ++a)
        if (arrays_[a].end > arrays_[a].begin) in_view[arrays_[a].view].push_back(a);
    std::vector<bool> is_own(arrays_.size(), false);
    for (std::size_t v = 0; v < in_view.size(); ++v) {
        if (!alone[v] || others[v]) continue;
        std::vector<std::size_t>& list = in_view[v];
        std::sort(list.begin(), list.end(),
                  [&](std::size_t a, std::size_t b) { return arrays_[a].begin < arrays_[b].begin; });
        std::uint64_t reached = 0;
        for (std::size_t i = 0; i < list.size(); ++i) {
            const Array& array = arrays_[list[i]];
            bool apart = array.begin >= reached && (i + 1 == list.size() || array.end <= arrays_[list[i + 1]].begin);
            reached = std::max(reached, array.end);
            if (!apart && list.size() <= 16) {  // interleaved: each has its own bytes in every stride
                apart = true;
                for (const std::size_t other : list) {
                    const Array& b = arrays_[other];
                    if (other == list[i] || b.end <= array.begin || array.end <= b.begin) continue;
                    const std::uint32_t size = element_bytes(tree["accessors"][list[i]]),
                                        theirs = element_bytes(tree["accessors"][other]);
                    const std::uint64_t shift =
                        array.stride == 0 ? 0 : (b.begin + array.stride - array.begin % array.stride) % array.stride;
                    apart = apart && array.stride > 0 && b.stride == array.stride && shift >= size &&
                            shift + theirs <= array.stride;
                }
            }
            is_own[list[i]] = apart && array.stride > 0;
        }
    }
    for (std::size_t a = 0; a < arrays_.size(); ++a)
        if (!is_own[a] || uses.count(a) != 1 || tree["accessors"][a].contains("sparse"))
            arrays_[a].end = arrays_[a].begin;
}

bool OwnArrays::replace(OrderedJson& tree, std::size_t accessor, std::span<const float> numbers, std::uint32_t width,
                        ComponentType type) {
    if (accessor >= arrays_.size() || arrays_[accessor].end == arrays_[accessor].begin) return false;
    const Array& array = arrays_[accessor];
    OrderedJson& json = tree["accessors"][accessor];
    const bool is_normalized = member(json, "normalized") == OrderedJson(true);
    if (width_of(json) != width || whole(json, "componentType") != std::uint64_t(type) ||
        whole(json, "count") != numbers.size() / width || is_normalized != (type != ComponentType::f32))
        return false;
    const std::uint32_t size = width * size_of(type);
    const std::vector<std::byte> bytes = stored_bytes(numbers, width, type, size);
    for (std::size_t i = 0; i < numbers.size() / width; ++i)
        std::memcpy(binary_.data() + array.begin + i * array.stride, bytes.data() + i * size, size);
    for (const char* name : {"min", "max"}) {
        if (!json.contains(name)) continue;
        const double scale = type == ComponentType::f32 ? 1 : 0.5 / half_step(type);
        OrderedJson bounds = OrderedJson::array();
        for (std::size_t c = 0; c < width; ++c) {
            float bound = numbers[c];
            for (std::size_t i = c; i < numbers.size(); i += width)
                bound = std::string_view(name) == "min" ? std::min(bound, numbers[i]) : std::max(bound, numbers[i]);
            if (type == ComponentType::f32)
                bounds.push_back(bound);
            else
                bounds.push_back(int(std::floor(double(stored_value(bound, type)) * scale + 0.5)));
        }
        json[name] = std::move(bounds);
    }
    return true;
}

std::optional<std::uint64_t> whole_number(const OrderedJson& owner, const char* name) { return whole(owner, name); }

std::vector<bool> live_views(const OrderedJson& tree, const AccessorUses& uses) {
    std::vector<bool> is_live = other_views(tree);
    for (std::size_t a = 0; a < uses.accessors(); ++a) {
        const auto view = whole(tree["accessors"][a], "bufferView");
        if (view && *view < is_live.size() && uses.count(a) > 0) is_live[std::size_t(*view)] = true;
    }
    return is_live;
}

std::uint64_t unused_bytes(const OrderedJson& tree, const AccessorUses& before, const AccessorUses& now) {
    const OrderedJson &accessors = list(tree, "accessors"), &views = list(tree, "bufferViews");
    std::vector<bool> in_use = other_views(tree), was_used(views.size(), false);
    const auto view_of = [&](std::size_t a) { return whole(accessors[a], "bufferView").value_or(views.size()); };
    for (std::size_t a = 0; a < accessors.size(); ++a) {
        const std::uint64_t v = view_of(a);
        if (v >= views.size()) continue;
        if (now.count(a) > 0) in_use[std::size_t(v)] = true;
        if (before.count(a) > 0) was_used[std::size_t(v)] = true;
    }
    std::uint64_t bytes = 0;
    for (std::size_t a = 0; a < accessors.size(); ++a)  // in views of which other parts are in use
        if (const std::uint64_t v = view_of(a);
            v < views.size() && in_use[std::size_t(v)] && before.count(a) > 0 && now.count(a) == 0)
            bytes += std::min(whole_or(accessors[a], "count", 0), std::uint64_t(1) << 32) * element_bytes(accessors[a]);
    for (std::size_t v = 0; v < views.size(); ++v) {
        if (in_use[v] || !was_used[v]) continue;
        const OrderedJson* packed = nullptr;
        for (const OrderedJson& extension : member(views[v], "extensions"))
            if (whole(extension, "byteLength")) packed = &extension;
        bytes += std::min(whole_or(packed ? *packed : views[v], "byteLength", 0), std::uint64_t(1) << 40);
    }
    return bytes;
}

}  // namespace rakelight::io::gltf
