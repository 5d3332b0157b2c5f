// SPDX-License-Identifier: Apache-2.0
// The tables of keys as a JSON schema.
#include <nlohmann/json.hpp>

#include <algorithm>

#include "io/world/world_keys.h"

namespace rakelight {
namespace {

using namespace io::world;
using json = nlohmann::ordered_json;

json number_of(const Range& r, const char* type) {
    json out = {{"type", type}};
    if (r.low > -1e29) out[r.is_open ? "exclusiveMinimum" : "minimum"] = r.low;
    if (r.high < 1e29) out[r.is_open ? "exclusiveMaximum" : "maximum"] = r.high;
    return out;
}

json list_of(const Range& r, int count, const char* type = "number") {
    return {{"type", "array"}, {"items", number_of(r, type)}, {"minItems", count}, {"maxItems", count}};
}

json table_of(const std::vector<WorldKey>& keys);

json type_of(const WorldKey& key) {
    switch (key.kind) {
        case Kind::text:
        case Kind::file:
            return {{"type", "string"}, {"minLength", 1}};
        case Kind::word:
            return {{"enum", key.words}};
        case Kind::flag:
            return {{"type", "boolean"}};
        case Kind::number:
            return number_of(key.range, "number");
        case Kind::integer:
            return number_of(key.range, "integer");
        case Kind::pair:
            return list_of(key.range, 2);
        case Kind::integers:
            return list_of(key.range, 2, "integer");
        case Kind::vector:
            return list_of(key.range, 3);
        case Kind::scale:
            return {{"oneOf", {number_of(key.range, "number"), list_of(key.range, 3)}}};
        case Kind::color:
            return {{"oneOf",
                     {list_of(from_0, 3),
                      {{"type", "string"}, {"pattern", "^(#[0-9a-fA-F]{3}|#[0-9a-fA-F]{6}|[A-Za-z]+)$"}}}}};
        case Kind::tables:
            return {{"type", "array"}, {"items", table_of(key.parts)}, {"minItems", 1}};
    }
    return {};
}

/// Of a list of tables: what its tables have may be missing beside them.
bool is_in_tables(const std::vector<WorldKey>& keys, std::string_view name) {
    return std::ranges::any_of(keys, [&](const WorldKey& key) {
        return std::ranges::any_of(key.parts, [&](const WorldKey& part) { return part.name == name; });
    });
}

json table_of(const std::vector<WorldKey>& keys) {
    json properties = json::object(), required = json::array();
    for (const WorldKey& key : keys) {
        json value = type_of(key);
        value["description"] = key.help;
        properties[key.name] = std::move(value);
        if (key.is_required && !is_in_tables(keys, key.name)) required.push_back(key.name);
    }
    json out = {{"type", "object"}, {"properties", properties}, {"additionalProperties", false}};
    if (!required.empty()) out["required"] = required;
    return out;
}

}  // namespace

std::string world_schema() {
    json properties = json::object();
    for (const WorldSection& s : sections()) {
        json table = table_of(s.keys);
        json whole = s.is_array ? json{{"type", "array"}, {"items", table}} : table;
        whole["description"] = s.help;
        properties[s.name] = std::move(whole);
    }
    const json scalar = {{"type", {"string", "number", "boolean"}}};
    properties["render"] = {
        {"description", "Options of the command line by name, without dashes before it; the command line wins"},
        {"type", "object"},
        {"additionalProperties", {{"oneOf", {scalar, {{"type", "array"}, {"items", scalar}, {"minItems", 1}}}}}}};
    const json schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                         {"title", "Rakelight world file (*.scene.toml)"},
                         {"type", "object"},
                         {"properties", properties},
                         {"additionalProperties", false}};
    return schema.dump(2) + "\n";
}

}  // namespace rakelight
