// SPDX-License-Identifier: Apache-2.0
// The JSON of a glTF file as a tree that keeps the order of its names, for editing and writing back.
#pragma once
#include <cstddef>
#include <span>
#include <string>

#include <nlohmann/json.hpp>

namespace rakelight::io::gltf {

using OrderedJson = nlohmann::ordered_json;

/// Parses text that parse_json() has accepted. Linear time whatever the number of names in an object; of a name that an
/// object holds twice the last value is kept, as the reader does. Integers stay integers, doubles keep their value.
/// @throws Error bad_file: not JSON, or nested deeper than the reader allows
OrderedJson parse_ordered(std::span<const std::byte> text);

/// The tree as text, indented as `model` is (not at all when that has no line breaks).
std::string to_text(const OrderedJson& tree, std::span<const std::byte> model);

/// Calls `visit(name, value)` for every member of every object in the tree; without recursion.
template <class Visit>
void for_each_member(OrderedJson& root, Visit visit) {
    std::vector<OrderedJson*> waiting{&root};
    while (!waiting.empty()) {
        OrderedJson& at = *waiting.back();
        waiting.pop_back();
        if (at.is_object()) {
            for (auto& [name, value] : at.get_ref<OrderedJson::object_t&>()) {
                visit(name, value);
                waiting.push_back(&value);
            }
        } else if (at.is_array()) {
            for (OrderedJson& value : at) waiting.push_back(&value);
        }
    }
}

}  // namespace rakelight::io::gltf
