// SPDX-License-Identifier: Apache-2.0
// Every row of the material tables: written as GLB and read again, and set by its key of a world file. Where glTF keeps
// a row is stated here a second time, from the specifications: a new row needs a line here, a writer and a reader.
#include "scene/materials/material_table.h"

#include <rakelight/io/world.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <stdexcept>
#include <string_view>

#include "io/gltf/write/glb_writer.h"
#include "io/pictures/image_io.h"
#include "io/world/material_keys.h"
#include "support/scene_builder.h"
#include "unit/io/gltf/gltf_support.h"
#include "unit/io/pictures/image_io_support.h"

namespace rakelight {
namespace {

using namespace test;
using Json = GltfFile::Json;

/// Where glTF keeps a row: a JSON pointer within the material; empty: nowhere.
struct Expected {
    const char *row, *place;
};

// glTF 2.0, section 3.9, and the Khronos extensions by the name of each
constexpr Expected texture_places[] = {
    {"base_color", "/pbrMetallicRoughness/baseColorTexture"},
    {"normal", "/normalTexture"},
    {"height", ""},
    {"opacity", ""},
    {"occlusion", "/occlusionTexture"},
    {"emission", "/emissiveTexture"},
    {"specular", ""},  // of classical materials
    {"metallic_roughness", "/pbrMetallicRoughness/metallicRoughnessTexture"},
    {"specular_strength", "/extensions/KHR_materials_specular/specularTexture"},
    {"specular_color", "/extensions/KHR_materials_specular/specularColorTexture"},
    {"anisotropy", "/extensions/KHR_materials_anisotropy/anisotropyTexture"},
    {"clearcoat", "/extensions/KHR_materials_clearcoat/clearcoatTexture"},
    {"clearcoat_roughness", "/extensions/KHR_materials_clearcoat/clearcoatRoughnessTexture"},
    {"clearcoat_normal", "/extensions/KHR_materials_clearcoat/clearcoatNormalTexture"},
    {"sheen_color", "/extensions/KHR_materials_sheen/sheenColorTexture"},
    {"sheen_roughness", "/extensions/KHR_materials_sheen/sheenRoughnessTexture"},
    {"transmission", "/extensions/KHR_materials_transmission/transmissionTexture"},
    {"thickness", "/extensions/KHR_materials_volume/thicknessTexture"},
    {"iridescence", "/extensions/KHR_materials_iridescence/iridescenceTexture"},
    {"iridescence_thickness", "/extensions/KHR_materials_iridescence/iridescenceThicknessTexture"},
};
constexpr std::string_view srgb_roles[] = {"base_color", "emission", "specular", "specular_color", "sheen_color"};

constexpr Expected parameter_places[] = {
    {"metallic", "/pbrMetallicRoughness/metallicFactor"},
    {"roughness", "/pbrMetallicRoughness/roughnessFactor"},
    {"ior", "/extensions/KHR_materials_ior/ior"},
    {"specular_factor", "/extensions/KHR_materials_specular/specularFactor"},
    {"specular_color", "/extensions/KHR_materials_specular/specularColorFactor"},
    {"anisotropy", "/extensions/KHR_materials_anisotropy/anisotropyStrength"},
    {"anisotropy_rotation_deg", "/extensions/KHR_materials_anisotropy/anisotropyRotation"},
    {"clearcoat", "/extensions/KHR_materials_clearcoat/clearcoatFactor"},
    {"clearcoat_roughness", "/extensions/KHR_materials_clearcoat/clearcoatRoughnessFactor"},
    {"clearcoat_normal_scale", "/extensions/KHR_materials_clearcoat/clearcoatNormalTexture/scale"},
    {"sheen_color", "/extensions/KHR_materials_sheen/sheenColorFactor"},
    {"sheen_roughness", "/extensions/KHR_materials_sheen/sheenRoughnessFactor"},
    {"transmission", "/extensions/KHR_materials_transmission/transmissionFactor"},
    {"thickness", "/extensions/KHR_materials_volume/thicknessFactor"},
    {"attenuation_distance", "/extensions/KHR_materials_volume/attenuationDistance"},
    {"attenuation_color", "/extensions/KHR_materials_volume/attenuationColor"},
    {"dispersion", "/extensions/KHR_materials_dispersion/dispersion"},
    {"iridescence", "/extensions/KHR_materials_iridescence/iridescenceFactor"},
    {"iridescence_ior", "/extensions/KHR_materials_iridescence/iridescenceIor"},
    {"iridescence_thickness_min_nm", "/extensions/KHR_materials_iridescence/iridescenceThicknessMinimum"},
    {"iridescence_thickness_max_nm", "/extensions/KHR_materials_iridescence/iridescenceThicknessMaximum"},
};

std::string place_of(std::span<const Expected> places, std::string_view row) {
    for (const Expected& expected : places)
        if (row == expected.row) return expected.place;
    ADD_FAILURE() << "'" << row << "' is new in the table: add its place in glTF to this test";
    return {};
}

// Shares of a row's range. Neither gives the default of any row.
constexpr float base_share = 0.25f, changed_share = 0.7f;

/// In the units of world files; of a number only x counts.
vec3 value_at(const MaterialParameter& p, float share) {
    if (p.number) return {float(p.low + double(share) * (p.high - p.low)), 0, 0};
    const float greatest = p.gltf_range == MaterialParameter::Range::unit ? 1.0f : 3.0f;
    return greatest * share * vec3{1, 0.75f, 0.5f};
}

/// The same in the units of the material.
vec3 stored_at(const MaterialParameter& p, float share) {
    const vec3 value = value_at(p, share);
    return p.kind == MaterialParameter::Kind::angle ? vec3{float(radians(double(value.x))), 0, 0} : value;
}

vec3 get(const Material& m, const MaterialParameter& p) {
    return p.color ? m.metallic_roughness.*p.color : vec3{m.metallic_roughness.*p.number, 0, 0};
}
void set(Material& m, const MaterialParameter& p, vec3 value) {
    if (p.color)
        m.metallic_roughness.*p.color = value;
    else
        m.metallic_roughness.*p.number = value.x;
}

void expect_near(vec3 got, vec3 wanted, const std::string& what) {
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(got[i], wanted[i], 1e-5f * (1 + std::abs(wanted[i]))) << what << ", component " << i;
}

vec3 vector_of(const Json& json) {
    if (json.is_number()) return {json.get<float>(), 0, 0};
    return {json.at(0).get<float>(), json.at(1).get<float>(), json.at(2).get<float>()};
}

/// Materials on squares, written as a GLB file and read again. Each role has a texture of its own.
class MaterialRows : public testing::Test {
protected:
    MaterialRows() {
        for (const TextureRole& role : texture_roles()) {
            const std::string file = folder_.file(std::string(role.name) + ".png");
            const auto color = [&](int, int) { return std::array{10 + int(role.number), 20, 30}; };
            io::write_image(file, rgb_pixels(1, 1, color));
            auto bytes = std::make_shared<const std::vector<std::byte>>(bytes_of_file(file));
            add_texture(source_, io::image_from_bytes(role.name, "", std::move(bytes), "image/png"));
        }
    }

    /// The texture of a role, with a set of coordinates and a transform that are not the default.
    static TextureUse use_of(const TextureRole& role) {
        const auto n = std::uint32_t(role.number);
        const float x = 1 + float(n);
        return {n, 1 + n % 7, {{0.125f * x, -0.25f * x}, {1 + 0.5f * x, 2}, 0.1f * x}};
    }

    /// Without textures. All numbers are set, since a layer of strength 0 is not written.
    static Material plain(const char* name) {
        Material m;
        m.name = name;
        for (const MaterialParameter& p : metallic_roughness_parameters()) set(m, p, stored_at(p, base_share));
        return m;
    }
    static Material textured(const char* name) {
        Material m = plain(name);
        for (const TextureRole& role : texture_roles()) role.in(m) = use_of(role);
        return m;
    }

    void add(Material material) {
        Mesh mesh = square_mesh(std::uint32_t(source_.materials.size()));
        mesh.texcoords.resize(8, Block<vec2>(mesh.texcoords[0]));
        add_object(source_, std::move(mesh));
        source_.materials.push_back(std::move(material));
    }
    void write_and_read() {
        const std::string path = folder_.file("out.glb");
        io::write_glb(source_, path, context_);
        const std::vector<std::byte> bytes = bytes_of_file(path);
        std::uint32_t length = 0;
        std::memcpy(&length, bytes.data() + 12, 4);
        const auto* json = reinterpret_cast<const char*>(bytes.data() + 20);
        tree_ = Json::parse(json, json + length);
        loaded_ = io::gltf_reader.read(path, {}, context_);
    }
    const Material& loaded(std::string_view name) const {
        for (const Material& m : loaded_.materials)
            if (m.name == name) return m;
        throw std::runtime_error("no such material was loaded");
    }

    /// What stands at a place of a written material; null, and a failure, where nothing does.
    const Json* written_at(std::string_view material, const std::string& place) const {
        const Json::json_pointer pointer(place);
        if (place.starts_with("/extensions/")) {
            const std::string name = place.substr(12, place.find('/', 12) - 12);
            EXPECT_NE(tree_.at("extensionsUsed").dump().find('"' + name + '"'), std::string::npos) << name;
        }
        for (const Json& m : tree_.at("materials"))
            if (!place.empty() && m.at("name") == material && m.contains(pointer)) return &m.at(pointer);
        ADD_FAILURE() << "nothing stands at '" << place << "' of material " << material;
        return nullptr;
    }

    void expect_loaded(const TextureUse& got, const TextureRole& role) const {
        const TextureUse wanted = use_of(role);
        ASSERT_TRUE(bool(got)) << role.name << " is lost";
        EXPECT_EQ(got.texcoord_set, wanted.texcoord_set) << role.name;
        EXPECT_EQ(got.transform, wanted.transform) << role.name;
        const EncodedImage& image = *loaded_.textures.at(got.texture).image;
        EXPECT_EQ(*image.bytes, *source_.textures.at(wanted.texture).image->bytes) << role.name << ": another picture";
    }

    void expect_written(const Json& texture, const TextureRole& role) const {
        const TextureUse wanted = use_of(role);
        const TextureTransform& t = wanted.transform;
        const Json& source = tree_.at("textures").at(texture.at("index").get<std::size_t>()).at("source");
        EXPECT_EQ(tree_.at("images").at(source.get<std::size_t>()).at("name"), role.name);
        EXPECT_EQ(texture.at("texCoord"), wanted.texcoord_set) << role.name;
        const Json transform = {
            {"offset", {t.offset.x, t.offset.y}}, {"rotation", t.rotation_rad}, {"scale", {t.scale.x, t.scale.y}}};
        EXPECT_EQ(texture.at("extensions").at("KHR_texture_transform"), transform) << role.name;
    }

    TemporaryFolder folder_;
    Context context_{{.threads = 1}};
    Scene source_, loaded_;  ///< textures of `source_`: by the number of the role
    Json tree_;
};

/// A material after one key of [[material]].
Material changed_by(const std::string& key, const std::string& value, const TextureUse& picture = {}) {
    const WorldFile world =
        parse_world("[[primitive]]\ntype = 'teapot'\n[[material]]\nname = 'm'\n" + key + " = " + value + "\n");
    Material m;
    for (const WorldValue& entry : world.materials.at(0).values) {
        io::world::MaterialChange change{m, entry, picture};
        io::world::find_material_key(entry.key)->set(change);
    }
    return m;
}

TEST_F(MaterialRows, AreAllListedHereWithTheirColorSpaces) {
    EXPECT_EQ(std::size(texture_places), texture_roles().size());
    EXPECT_EQ(std::size(parameter_places), metallic_roughness_parameters().size());
    for (const TextureRole& role : texture_roles()) {
        const bool is_color = std::ranges::count(srgb_roles, std::string_view(role.name)) > 0;
        EXPECT_EQ(role.space, is_color ? ColorSpace::srgb : ColorSpace::linear) << role.name;
    }
    for (const MaterialParameter& p : metallic_roughness_parameters())
        for (const float share : {base_share, changed_share})
            EXPECT_NE(stored_at(p, share), get(Material{}, p)) << p.key << ": the default proves nothing";
}

TEST_F(MaterialRows, NumbersStandInGltfWhereTheSpecificationsSayAndComeBackAlone) {
    for (const MaterialParameter& p : metallic_roughness_parameters()) {
        Material m = textured(p.key);
        set(m, p, stored_at(p, changed_share));
        add(std::move(m));
    }
    write_and_read();
    for (const MaterialParameter& changed : metallic_roughness_parameters()) {
        if (const Json* value = written_at(changed.key, place_of(parameter_places, changed.key)))
            expect_near(vector_of(*value), stored_at(changed, changed_share), changed.key);
        for (const MaterialParameter& p : metallic_roughness_parameters())
            expect_near(get(loaded(changed.key), p), stored_at(p, &p == &changed ? changed_share : base_share),
                        std::string(p.key) + " of the material with another " + changed.key);
    }
    EXPECT_FALSE(is_said(context_, Remark::changed, "")) << "none is out of range";
}

TEST_F(MaterialRows, TexturesStandInGltfWhereTheSpecificationsSayAndComeBackInTheirRoleAlone) {
    for (const TextureRole& role : texture_roles()) {
        Material m = plain(role.name);
        role.in(m) = use_of(role);
        add(std::move(m));
    }
    write_and_read();
    for (const TextureRole& role : texture_roles()) {
        const std::string place = place_of(texture_places, role.name);
        const bool is_classical = role.model == MaterialModel::classical;  // of which these materials have nothing
        if (place.empty())
            EXPECT_TRUE(is_classical || is_said(context_, Remark::dropped, role.name)) << role.name;
        else if (const Json* texture = written_at(role.name, place))
            expect_written(*texture, role);
        for (const TextureRole& other : texture_roles())
            if (&other == &role && !place.empty())
                expect_loaded(role.in(loaded(role.name)), role);
            else
                EXPECT_FALSE(bool(other.in(loaded(role.name)))) << role.name << " came back as " << other.name;
    }
}

TEST_F(MaterialRows, AllTexturesOfOneMaterialComeBackEachInItsRole) {
    add(textured("all"));
    write_and_read();
    for (const TextureRole& role : texture_roles())
        if (!place_of(texture_places, role.name).empty()) expect_loaded(role.in(loaded("all")), role);
}

TEST_F(MaterialRows, NumbersAreSetByTheirKeysOfWorldFilesAndChangeNoOther) {
    for (const MaterialParameter& set_one : metallic_roughness_parameters()) {
        const vec3 v = value_at(set_one, changed_share);
        std::string text = std::to_string(v.x);
        if (set_one.color) text = "[" + text + ", " + std::to_string(v.y) + ", " + std::to_string(v.z) + "]";
        const Material m = changed_by(set_one.key, text);
        for (const MaterialParameter& p : metallic_roughness_parameters())
            expect_near(get(m, p), &p == &set_one ? stored_at(p, changed_share) : get(Material{}, p),
                        std::string(p.key) + " after " + set_one.key);
    }
}

TEST_F(MaterialRows, TexturesAreSetByTheirKeysOfWorldFilesInTheirRoleAlone) {
    for (const TextureRole& role : texture_roles()) {
        const Material m = changed_by(role.key, "'t.png'", use_of(role));
        for (const TextureRole& other : texture_roles())
            EXPECT_EQ(other.in(m).texture, &other == &role ? use_of(role).texture : no_index) << role.key << other.name;
    }
}

}  // namespace
}  // namespace rakelight
