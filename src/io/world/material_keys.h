// SPDX-License-Identifier: Apache-2.0
// The keys of [[material]] and what each does to a material.
#pragma once
#include <functional>
#include <span>

#include "io/world/world_keys.h"

namespace rakelight::io::world {

/// What a key acts on.
struct MaterialChange {
    Material& material;
    const WorldValue& value;
    TextureUse picture;  ///< of a key that names a file

    float number(std::size_t i = 0) const { return float(value.numbers[i]); }
    vec3 color() const { return {number(0), number(1), number(2)}; }
    const std::string& word() const { return value.words[0]; }
    bool is_on() const { return value.numbers[0] != 0; }
};

/// Which materials have what a key sets; others are converted first.
enum class Of { all, classical, metallic_roughness };

struct MaterialKey {
    WorldKey key;
    Of of;
    std::function<void(MaterialChange&)> set;
};

/// The keys of the section.
std::vector<WorldKey> material_keys();

/// All but name and model.
const std::vector<MaterialKey>& material_setters();
const MaterialKey* find_material_key(std::string_view name);

}  // namespace rakelight::io::world
