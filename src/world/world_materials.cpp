// SPDX-License-Identifier: Apache-2.0
// [[material]] of world files: changes to the models' materials, and new materials.
#include <algorithm>
#include <charconv>
#include <map>

#include <rakelight/base/report.h>
#include <rakelight/scene/words.h>

#include "io/files/file.h"
#include "io/pictures/image_io.h"
#include "io/world/material_keys.h"
#include "scene/materials/material_conversion.h"
#include "scene/materials/material_table.h"
#include "world/change_material.h"
#include "world/load_world.h"
#include "world/own_materials.h"

namespace rakelight {
namespace {

using namespace io::world;

void convert(Material& m, Of of) {
    if (m.model == MaterialModel::unlit || of == Of::all) return;
    m = of == Of::classical ? classical_from_metallic_roughness(m) : as_metallic_roughness(m);
}

class MaterialWork {
public:
    MaterialWork(Scene& scene, const std::string& path, const LoadOptions& options, Context& context)
        : scene_(scene), path_(path), options_(options), context_(context) {}

    void change(Material& m, const WorldMaterial& by) {
        change_material(m, by.values, [this](const WorldValue& value) { return picture(value); });
    }

    /// Checks the pictures of an unused [[material]].
    void check(const WorldMaterial& unused) {
        for (const WorldValue& value : unused.values)
            if (find_material_key(value.key)->key.kind == Kind::file) checked(value);
    }

private:
    /// The texture of a file, created once, but separately for normal and height maps, so that remarks on them have the
    /// right place.
    TextureUse picture(const WorldValue& value) {
        const std::string& name = value.words[0];
        const bool is_looked_at = value.key == "normal_texture" || value.key == "height_texture";
        const auto [known, is_new] =
            textures_.emplace(std::pair(name, is_looked_at ? value.key : ""), std::uint32_t(scene_.textures.size()));
        if (is_new)
            scene_.textures.push_back(
                {name, io::image_from_file(name, path_, checked(value), to_text(value.place)), {}});
        TextureUse use;
        use.texture = known->second;
        return use;
    }

    std::string checked(const WorldValue& value) {
        return checked_picture(path_, value.words[0], value.place, options_, context_);
    }

    Scene& scene_;
    const std::string& path_;
    const LoadOptions& options_;
    Context& context_;
    std::map<std::pair<std::string, std::string>, std::uint32_t> textures_;  ///< file and, of some, key
};

/// The initial material of the world: white, not metallic.
Material new_material(const WorldMaterial& from) {
    Material m;
    m.name = from.name;
    m.metallic_roughness.metallic = 0;
    m.metallic_roughness.roughness = 0.5f;
    for (const WorldValue& value : from.values)
        if (find_material_key(value.key)->of == Of::classical) m.model = MaterialModel::classical;
    return m;
}

/// Material colors are linear and at most 1; numbers like 255 are display values.
void warn_of_display_colors(const WorldMaterial& from, const std::string& path, Report& report) {
    for (const WorldValue& value : from.values) {
        const bool is_color = find_material_key(value.key)->key.kind == Kind::color && value.key != "emission";
        if (is_color && *std::max_element(value.numbers.begin(), value.numbers.end()) > 1)
            report.add(Remark::warning, path, to_text(value.place),
                       "'" + value.key + "' is more than 1: colors of materials are linear, 0 to 1, or '#rrggbb'");
    }
}

/// A [[material]] and the materials it changed.
struct Changed {
    const WorldMaterial* by;
    std::vector<std::uint32_t> materials;
};

/// A texture has no effect if its factor is 0, which is the default unless [[material]] sets it.
/// @param scene  after all of them
void warn_of_idle_pictures(const Scene& scene, const Changed& changed, const std::string& path, Report& report) {
    if (changed.materials.empty()) return;
    const auto is_idle = [&](const TextureFactor& factor) {
        return factor.key && std::all_of(changed.materials.begin(), changed.materials.end(),
                                         [&](std::uint32_t i) { return factor.is_zero(scene.materials[i]); });
    };
    for (const WorldValue& value : changed.by->values)
        for (const TextureRole& role : texture_roles()) {
            if (value.key != role.key) continue;
            const TextureFactor& why = is_idle(role.layer) ? role.layer : role.factor;
            if (is_idle(why))
                report.add(Remark::warning, path, to_text(value.place),
                           "'" + value.key + "' has no effect: '" + why.key + "' is 0");
        }
}

/// @param covered a part whose such materials are replaced by one of the world; null: none
std::string why_unused(const WorldMaterial& from, const LoadedPart* covered, const Scene& scene) {
    const std::string name = one_line(from.name, 40);
    if (covered)
        return "[[material]] '" + name + "' has no effect: all of '" + one_line(covered->name, 40) + "' is of '" +
               one_line(covered->material, 40) + "'";
    std::vector<std::string_view> names;
    for (const Material& m : scene.materials) names.push_back(m.name);
    const std::string near = nearest_word(from.name, names);
    return "no model has a material named '" + name + "'" +
           (near.empty() ? "" : "; did you mean '" + one_line(near, 40) + "'?");
}

}  // namespace

Material as_metallic_roughness(const Material& material) {
    Material out = metallic_roughness_from_classical(material);
    if (material.model == MaterialModel::classical && out.metallic_roughness.specular == 0)
        out.metallic_roughness.specular = 1, out.metallic_roughness.specular_color = {1, 1, 1};
    return out;
}

void change_material(Material& material, std::span<const WorldValue> values,
                     const std::function<TextureUse(const WorldValue&)>& picture) {
    for (const WorldValue& value : values) convert(material, find_material_key(value.key)->of);
    for (const MaterialKey& key : material_setters())  // in the table's order
        for (const WorldValue& value : values)
            if (value.key == key.key.name && key.set) {
                MaterialChange change{material, value, key.key.kind == Kind::file ? picture(value) : TextureUse{}};
                key.set(change);
            }
}

std::string checked_picture(const std::string& path, const std::string& name, WorldPlace place,
                            const LoadOptions& options, Context& context, std::pair<int, int>* size) {
    try {
        std::string file = io::resolve_reference(path, name, options.allow_outside);
        const Pixels pixels = io::decode_image(*io::read_file(file, context), context);
        if (size) *size = {pixels.width, pixels.height};
        return file;
    } catch (const Error& error) {
        throw Error(error.code(), "'" + one_line(name, 80) + "': " + error.reason(), to_text(place), error.advice())
            .naming(error.related());
    }
}

namespace {

/// Changes the materials of models named in [[material]], and creates the world's materials.
void apply_to_models(Scene& scene, const WorldFile& world, const std::vector<LoadedPart>& parts, MaterialWork& work,
                     std::vector<Changed>& all_changed, const std::string& path, Report& report) {
    std::map<std::string, std::uint32_t> own;
    for (const WorldMaterial& from : world.materials) {
        if (!from.object.empty()) continue;
        bool is_used = false;
        std::vector<std::uint32_t>& changed = all_changed.emplace_back(Changed{&from, {}}).materials;
        const LoadedPart* covered = nullptr;  // has what is to be changed, but all of it is the world's own
        for (const LoadedPart& part : parts) {
            if (!from.model.empty() && from.model != part.name) continue;
            for (std::uint32_t i = part.first_material; i < part.end_material; ++i) {
                if (from.name != "*" && from.name != scene.materials[i].name) continue;
                work.change(scene.materials[i], from);
                changed.push_back(i);
                if (part.material.empty())
                    is_used = true;
                else
                    covered = &part;
            }
        }
        const bool is_asked_for =
            std::any_of(parts.begin(), parts.end(), [&](const LoadedPart& p) { return p.material == from.name; });
        if (is_asked_for && !own.contains(from.name)) {
            own.emplace(from.name, std::uint32_t(scene.materials.size()));
            Material made = new_material(from);
            work.change(made, from);
            changed.push_back(std::uint32_t(scene.materials.size()));
            scene.materials.push_back(std::move(made));
        }
        if (is_used || is_asked_for) continue;
        work.check(from);
        report.add(Remark::warning, path, to_text(from.place), why_unused(from, covered, scene));
    }
    for (const LoadedPart& part : parts)
        if (const auto material = own.find(part.material); material != own.end())
            for (std::uint32_t i = part.first_mesh; i < part.end_mesh; ++i) scene.meshes[i].material = material->second;
}

/// The nodes of a [[material]]'s object, by name or by index in their part.
std::vector<std::uint32_t> objects_of(const Scene& scene, const WorldMaterial& from,
                                      const std::vector<LoadedPart>& parts) {
    const std::string& wanted = from.object;
    std::uint32_t number = no_index;
    const auto [end, fault] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), number);
    const bool is_number = fault == std::errc() && end == wanted.data() + wanted.size();
    std::vector<std::uint32_t> nodes;
    for (const LoadedPart& part : parts) {
        if (!from.model.empty() && from.model != part.name) continue;
        const std::uint32_t first = part.first_node + 1;  // after the node that places the part
        for (std::uint32_t n = first; n < part.end_node; ++n)
            if (!scene.nodes[n].meshes.empty() && (is_number ? n - first == number : scene.nodes[n].name == wanted))
                nodes.push_back(n);
    }
    return nodes;
}

std::string why_unused(const WorldMaterial& from, const Scene& scene, const std::vector<std::uint32_t>& objects) {
    const std::string object = "'" + one_line(from.object, 40) + "'";
    if (!objects.empty()) return "the object " + object + " has no material named '" + one_line(from.name, 40) + "'";
    std::vector<std::string_view> names;
    for (const Node& node : scene.nodes)
        if (!node.meshes.empty()) names.push_back(node.name);
    const std::string near = nearest_word(from.object, names);
    return "no model has an object " + object + (near.empty() ? "" : "; did you mean '" + one_line(near, 40) + "'?");
}

/// Changes materials of single objects, which get their own copies.
void apply_to_objects(Scene& scene, const WorldFile& world, const std::vector<LoadedPart>& parts, MaterialWork& work,
                      std::vector<Changed>& all_changed, const std::string& path, Context& context) {
    OwnMaterials own(scene, context);
    for (const WorldMaterial& from : world.materials) {
        if (from.object.empty()) continue;
        context.throw_if_cancelled();
        std::vector<std::uint32_t>& changed = all_changed.emplace_back(Changed{&from, {}}).materials;
        const std::vector<std::uint32_t> objects = objects_of(scene, from, parts);
        for (const std::uint32_t node : objects)
            for (const std::uint32_t material : own.of(node, from.name)) {
                work.change(scene.materials[material], from);
                changed.push_back(material);
            }
        if (!changed.empty()) continue;
        work.check(from);
        context.report().add(Remark::warning, path, to_text(from.place), why_unused(from, scene, objects));
    }
    own.finish();
}

}  // namespace

void apply_materials(Scene& scene, const WorldFile& world, const std::vector<LoadedPart>& parts,
                     const std::string& path, const LoadOptions& options, Context& context) {
    if (world.materials.empty()) return;
    MaterialWork work(scene, path, options, context);
    std::vector<Changed> all_changed;
    all_changed.reserve(world.materials.size());
    for (const WorldMaterial& from : world.materials) warn_of_display_colors(from, path, context.report());
    apply_to_models(scene, world, parts, work, all_changed, path, context.report());
    apply_to_objects(scene, world, parts, work, all_changed, path, context);
    for (const Changed& changed : all_changed) warn_of_idle_pictures(scene, changed, path, context.report());
}

}  // namespace rakelight
