// SPDX-License-Identifier: Apache-2.0
// The pictures of a world's materials: each multiplies what glTF says, by the channel that it says.
#include <gtest/gtest.h>
#include <rakelight/render/picture.h>

#include <cmath>
#include <fstream>
#include <functional>

#include "math/linear.h"
#include "support/temporary_folder.h"
#include "support/thrown_error.h"

using namespace rakelight;
using namespace rakelight::test;

namespace {

/// One texel: red 0.2, green 0.4, blue 0.6, alpha 0.8 (bytes 51, 102, 153, 204).
constexpr unsigned char texel_png[] = {
    137, 80, 78, 71, 13, 10,  26,  10,  0,   0,   0, 13, 73, 72, 68, 82, 0,  0,   0,   1,  0,  0,  0,   1,
    8,   6,  0,  0,  0,  31,  21,  196, 137, 0,   0, 0,  13, 73, 68, 65, 84, 120, 218, 99, 48, 78, 155, 121,
    6,   0,  4,  1,  1,  255, 196, 228, 107, 228, 0, 0,  0,  0,  73, 69, 78, 68,  174, 66, 96, 130};

class WorldTextures : public testing::Test {
protected:
    void SetUp() override {
        std::ofstream(folder_ / "t.png", std::ios::binary)
            .write(reinterpret_cast<const char*>(texel_png), sizeof texel_png);
        std::ofstream(folder_ / "words.png") << "these are words";
    }

    /// A sphere of one material, whose keys start in line 6.
    Scene sphere(const std::string& keys) {
        std::ofstream(folder_ / "w.scene.toml")
            << "[[primitive]]\ntype = 'sphere'\nmaterial = 'm'\n[[material]]\nname = 'm'\n" + keys +
                   "\n[[light]]\ntype = 'directional'\ndirection = [-0.5, -0.4, -1]\n"
                   "[[light]]\ntype = 'ambient'\nambient = [0.3, 0.3, 0.3]\n";
        return load((folder_ / "w.scene.toml").string(), {}, context_);
    }
    Frame draw(const std::string& keys) {
        const Scene scene = smooth(sphere(keys), {}, context_);
        return render(scene, {.width = 48, .height = 48}, context_);
    }
    /// Greatest difference of the two pictures.
    float difference(const std::string& a, const std::string& b) {
        const Frame left = draw(a), right = draw(b);
        float greatest = 0;
        for (std::size_t i = 0; i < left.color.size(); ++i) {
            const vec4 d = left.color[i] - right.color[i];
            greatest = std::max({greatest, std::abs(d.x), std::abs(d.y), std::abs(d.z)});
        }
        return greatest;
    }

    TemporaryFolder folder_;
    Context context_{{.threads = 1}};
};

constexpr const char* layer_textures[] = {
    "metallic_roughness_texture", "specular_factor_texture", "specular_color_texture",
    "anisotropy_texture",         "clearcoat_texture",       "clearcoat_roughness_texture",
    "clearcoat_normal_texture",   "sheen_color_texture",     "sheen_roughness_texture"};

}  // namespace

TEST_F(WorldTextures, EachMultipliesItsFactorByTheChannelThatGltfNames) {
    const struct {
        const char *common, *by_texture, *by_factor;
    } cases[] = {
        {"metallic = 1", "metallic_roughness_texture = 't.png'\nroughness = 1", "metallic = 0.6\nroughness = 0.4"},
        {"roughness = 0.3", "specular_factor_texture = 't.png'", "specular_factor = 0.8"},
        {"roughness = 0.3", "specular_color_texture = 't.png'", "specular_color = '#336699'"},
        {"roughness = 0.3", "clearcoat = 1\nclearcoat_texture = 't.png'", "clearcoat = 0.2"},
        {"clearcoat = 1", "clearcoat_roughness = 1\nclearcoat_roughness_texture = 't.png'",
         "clearcoat_roughness = 0.4"},
        {"sheen_roughness = 0.5", "sheen_color = [1, 1, 1]\nsheen_color_texture = 't.png'", "sheen_color = '#336699'"},
        {"sheen_color = [1, 1, 1]", "sheen_roughness = 1\nsheen_roughness_texture = 't.png'", "sheen_roughness = 0.8"},
        // direction (2 0.2 - 1, 2 0.4 - 1) = (-0.6, -0.2)
        {"roughness = 0.3", "anisotropy = 1\nanisotropy_texture = 't.png'",
         "anisotropy = 0.6\nanisotropy_rotation_deg = 198.4349488"},
    };
    for (const auto& [common, by_texture, by_factor] : cases) {
        std::string factor_keys = std::string(common) + "\n" + by_factor;
        if (std::string(common) == "metallic = 1") factor_keys = by_factor;
        const std::string texture_keys = std::string(common) + "\n" + by_texture;
        EXPECT_LT(difference(texture_keys, factor_keys), 2e-5f) << by_texture;
        EXPECT_GT(difference(texture_keys, common), 1e-3f) << by_texture << " changes the picture";
    }
}

TEST_F(WorldTextures, TheNormalMapOfTheClearcoatBumpsTheCoatAlone) {
    const std::string coat = "roughness = 0.9\nclearcoat = 1\nclearcoat_roughness = 0.2\n";
    EXPECT_GT(difference(coat + "clearcoat_normal_texture = 't.png'", coat), 0.05f);
    EXPECT_EQ(difference("clearcoat_normal_texture = 't.png'", ""), 0);
    const MetallicRoughnessParameters p =
        sphere(coat + "clearcoat_normal_texture = 't.png'\nclearcoat_normal_scale = -2")
            .materials.back()
            .metallic_roughness;
    EXPECT_EQ(p.clearcoat_normal_scale, -2);
    EXPECT_TRUE(bool(p.clearcoat_normal_texture));
}

TEST_F(WorldTextures, AllArePlacedByTheKeysOfTheMaterial) {
    std::string keys = "texture_scale = [3, 4]\n";
    for (const char* name : layer_textures) keys += std::string(name) + " = 't.png'\n";
    const Scene scene = sphere(keys);
    const MetallicRoughnessParameters& p = scene.materials.back().metallic_roughness;
    for (const TextureUse* use : {&p.texture, &p.specular_texture, &p.specular_color_texture, &p.anisotropy_texture,
                                  &p.clearcoat_texture, &p.clearcoat_roughness_texture, &p.clearcoat_normal_texture,
                                  &p.sheen_color_texture, &p.sheen_roughness_texture}) {
        EXPECT_EQ(use->texture, 0u);
        EXPECT_EQ(use->transform.scale, (vec2{3, 4}));
    }
    EXPECT_EQ(scene.textures.size(), 1u);  // the file is read once
}

TEST_F(WorldTextures, AFaultOfAnyOfThemIsOneLineWithItsPlace) {
    const struct {
        const char *value, *words;
        ErrorCode code;
    } faults[] = {{" = 3", "a text in quotes, not a number", ErrorCode::bad_file},
                  {" = ['t.png']", "a text in quotes, not an array", ErrorCode::bad_file},
                  {" = true", "a text in quotes, not true or false", ErrorCode::bad_file},
                  {" = 'none.png'", "'none.png': ", ErrorCode::not_found},
                  {" = 'words.png'", "'words.png': is not a picture", ErrorCode::bad_file},
                  {" = '../t.png'", "'../t.png': ", ErrorCode::bad_file}};
    for (const char* name : layer_textures)
        for (const auto& [value, words, code] : faults) {
            const Error error = error_of([&] { sphere(std::string(name) + value); });
            EXPECT_EQ(error.place(), "line 6, column " + std::to_string(std::string(name).size() + 4)) << name << value;
            EXPECT_NE(error.reason().find(words), std::string::npos) << name << value << error.what();
            EXPECT_EQ(error.reason().find('\n'), std::string::npos);
            EXPECT_EQ(error.code(), code) << name << value;
        }
}

TEST_F(WorldTextures, NumbersOutOfRangeAndMisspeltKeysAreSaidWithTheirPlace) {
    EXPECT_EQ(error_of([&] { sphere("clearcoat_normal_scale = 200"); }).place(), "line 6, column 26");
    EXPECT_EQ(error_of([&] { sphere("clearcoat_normal_scale = 'a'"); }).place(), "line 6, column 26");
    EXPECT_EQ(error_of([&] { sphere("clearcoat_textur = 't.png'"); }).advice(), "did you mean 'clearcoat_texture'?");
    EXPECT_EQ(error_of([&] { sphere("shininess = 9\nsheen_color_texture = 't.png'"); }).place(), "line 7, column 23");
}

TEST_F(WorldTextures, AHeightMapInPlaceOfANormalMapIsSaidWithItsLineAndTheKeyItBelongsTo) {
    const auto save = [&](const char* name, const std::function<vec4(int)>& at) {
        Frame frame;
        frame.begin(16, 16, {}, 0);
        for (std::size_t i = 0; i < frame.color.size(); ++i) frame.color[i] = at(int(i % 16));
        rakelight::save(frame, (folder_ / name).string());
    };
    save("gray.png", [](int x) { return vec4{0.06f * float(x), 0.06f * float(x), 0.06f * float(x), 1}; });
    save("blue.png", [](int x) {
        return vec4{x % 2 ? 0.3f : 0.15f, 0.2159f, 0.95f, 1};
    });  // codes 149 or 108, 128, 249
    const auto said = [&](const std::string& keys) {
        Context context({.threads = 1});
        make_engine("soft")->prepare(sphere(keys), context);
        std::string all;
        for (const ReportEntry& e : context.report().entries()) all += e.place + ": " + e.message + "\n";
        return all;
    };
    EXPECT_EQ(
        said("color_texture = 'gray.png'\nnormal_texture = 'gray.png'"),
        "line 7, column 18: the normal map looks like a height map: it is gray; 'height_texture' takes it as one\n");
    EXPECT_EQ(said("color_texture = 'blue.png'\nroughness = 1\nheight_texture = 'blue.png'"),
              "line 8, column 18: the height map looks like a normal map; 'normal_texture' takes it as one\n");
    EXPECT_EQ(said("height_texture = 'gray.png'\nnormal_texture = 'blue.png'").find("looks like"), std::string::npos);
}

TEST_F(WorldTextures, OneOfWhatIsNotThereIsWarnedOf) {
    const struct {
        const char *keys, *words;
    } cases[] = {{"clearcoat_texture = 't.png'", "'clearcoat' is 0"},
                 {"clearcoat_normal_texture = 't.png'", "'clearcoat' is 0"},
                 {"clearcoat = 1\nclearcoat_roughness_texture = 't.png'", "'clearcoat_roughness' is 0"},
                 {"sheen_color_texture = 't.png'", "'sheen_color' is 0"},
                 {"sheen_color = [0, 1, 0]\nsheen_roughness_texture = 't.png'", "'sheen_roughness' is 0"},
                 {"anisotropy_texture = 't.png'", "'anisotropy' is 0"},
                 {"specular_texture = 't.png'", "'specular' is 0"},
                 {"emission_texture = 't.png'", "'emission' is 0"}};
    for (const auto& [keys, words] : cases) {
        const std::size_t before = context_.report().entries().size();
        sphere(keys);
        ASSERT_EQ(context_.report().entries().size(), before + 1) << keys;
        EXPECT_NE(context_.report().entries().back().message.find(words), std::string::npos) << keys;
    }
    const std::size_t before = context_.report().entries().size();
    sphere("anisotropy = 0.1\nanisotropy_texture = 't.png'\nclearcoat = 1\nclearcoat_normal_texture = 't.png'");
    EXPECT_EQ(context_.report().entries().size(), before);
}

TEST_F(WorldTextures, OneThatALaterMaterialEntryTurnsOnIsNotWarnedOf) {
    std::ofstream(folder_ / "o.mtl") << "newmtl gold\nKd 1 1 0\nKs 0 0 0\n";
    std::ofstream(folder_ / "o.obj") << "mtllib o.mtl\nusemtl gold\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n";
    const auto warnings = [&](const std::string& of_all, const std::string& of_gold) {
        std::ofstream(folder_ / "w.scene.toml") << "[[model]]\nfile = 'o.obj'\n[[material]]\nname = '*'\n"
                                                << of_all << "\n[[material]]\nname = 'gold'\n"
                                                << of_gold;
        Context context;
        load((folder_ / "w.scene.toml").string(), {}, context);
        std::size_t count = 0;
        for (const ReportEntry& e : context.report().entries())
            count += e.message.find("'specular' is 0") != std::string::npos;
        return count;
    };
    const std::string texture = "specular_texture = 't.png'\n", on = "specular = [1, 1, 1]\n",
                      off = "specular = [0, 0, 0]\n";
    EXPECT_EQ(warnings(texture, ""), 1u);
    EXPECT_EQ(warnings(texture, on), 0u);
    EXPECT_EQ(warnings(texture + on, off), 1u);
    EXPECT_EQ(warnings(on, texture), 0u);
}
