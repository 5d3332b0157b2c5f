// SPDX-License-Identifier: Apache-2.0
// The JSON of a glTF file as a tree that keeps the order of its names, for editing and writing back.
#pragma once
#include <cstddef>
#include <functional>
#include <span>
#include <string>

#include <nlohmann/json_fwd.hpp>

namespace rakelight::io::gltf {

using OrderedJson = nlohmann::ordered_json;

/// Parses text that parse_json() has accepted. Linear time whatever the number of names in an object; of a name that an
/// object holds twice the last value is kept, as the reader does. Integers stay integers, doubles keep their value.
/// @throws Error bad_file: not JSON, or nested deeper than the reader allows
OrderedJson parse_ordered(std::span<const std::byte> text);

/// The tree as text, indented as `model` is (not at all when that has no line breaks).
std::string to_text(const OrderedJson& tree, std::span<const std::byte> model);

/// Calls `visit(name, value)` for every member of every object in the tree; without recursion.
void for_each_member(OrderedJson& root, const std::function<void(const std::string&, OrderedJson&)>& visit);

inline constexpr const char* meshopt_names[] = {"EXT_meshopt_compression", "KHR_meshopt_compression"};
/// The name of the meshopt extension that a bufferView carries; empty without one.
std::string meshopt_extension(const OrderedJson& view);

}  // namespace rakelight::io::gltf
