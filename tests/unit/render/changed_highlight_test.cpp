// SPDX-License-Identifier: Apache-2.0
// Who gives classical parameters does not matter: a material that the world or the command line changes is drawn as one
// of the world's own with the same parameters.
#include <gtest/gtest.h>
#include <rakelight/io/world.h>
#include <rakelight/io/world_words.h>
#include <rakelight/render/picture.h>

#include <algorithm>
#include <cmath>

#include "support/temporary_folder.h"

using namespace rakelight;
using namespace rakelight::test;

namespace {

constexpr const char* classical_keys = "color = [0.5, 0.25, 0.1]\nspecular = [0.4, 0.3, 0.2]\nshininess = 8\n";
constexpr const char* by_all = "[[material]]\nname = '*'\n";

class ChangedHighlight : public testing::Test {
protected:
    /// A sphere, lit from the viewer, with these sections about materials.
    Scene sphere(const std::string& sections, bool has_own = false) {
        const std::string shape =
            has_own ? "[[primitive]]\ntype = 'sphere'\nmaterial = 'own'\n" : "[[primitive]]\ntype = 'sphere'\n";
        const std::string light = "[[light]]\ntype = 'directional'\ndirection = [-0.3, -0.4, -1]\n";
        return load(folder_.write("w.scene.toml", shape + sections + light), {}, context_);
    }
    Scene own(const std::string& keys) { return sphere("[[material]]\nname = 'own'\n" + keys, true); }
    Scene changed(const std::string& keys) { return sphere(by_all + keys); }
    Scene with_options(const Scene& scene, const std::vector<std::string>& arguments) {
        MaterialOverrides overrides;
        overrides.values = material_values(arguments);
        return override_materials(scene, overrides, context_);
    }

    Frame draw(const Scene& scene, RenderSettings settings) {
        settings.width = settings.height = 48;
        return render(smooth(scene, {}, context_), settings, context_);
    }
    /// Greatest difference of two pictures.
    float difference(const Scene& a, const Scene& b, const RenderSettings& settings = {}) {
        const Frame left = draw(a, settings), right = draw(b, settings);
        float greatest = 0;
        for (std::size_t i = 0; i < left.color.size(); ++i)
            for (std::size_t c = 0; c < 3; ++c)
                greatest = std::max(greatest, std::abs(left.color[i][c] - right.color[i][c]));
        return greatest;
    }

    TemporaryFolder folder_;
    Context context_{{.threads = 1}};
};

TEST_F(ChangedHighlight, OfTheWorldIsTheTextbooksAsThatOfItsOwnMaterials) {
    for (const char* lighting : {"", "lighting = 'phong'\n", "lighting = 'ward'\n", "lighting = 'pbr'\n"}) {
        const std::string keys = std::string(classical_keys) + lighting;
        EXPECT_EQ(difference(own(keys), changed(keys)), 0) << lighting;
    }
}

TEST_F(ChangedHighlight, OfTheCommandLineIsTheTextbooksToo) {
    const Scene by_option = with_options(sphere(""), {"color=0.5,0.25,0.1", "specular=0.4,0.3,0.2", "shininess=8"});
    EXPECT_EQ(difference(own(classical_keys), by_option), 0);
}

TEST_F(ChangedHighlight, InSeveralStepsIsTheSameAsInOne) {
    const Scene in_two = sphere(std::string(by_all) + "shininess = 8\n[[material]]\nname = '*'\nmodel = 'sphere'\n" +
                                "color = [0.5, 0.25, 0.1]\nspecular = [0.4, 0.3, 0.2]\n");
    EXPECT_EQ(difference(own(classical_keys), in_two), 0);
    const Scene by_both = with_options(changed("color = [0.5, 0.25, 0.1]\nshininess = 8\n"), {"specular=0.4,0.3,0.2"});
    EXPECT_EQ(difference(own(classical_keys), by_both), 0);
}

TEST_F(ChangedHighlight, IsNormalizedWhereTheMaterialOrThePictureSaysSo) {
    const std::string keys = std::string(classical_keys) + "specular_form = 'normalized'\n";
    EXPECT_EQ(difference(own(keys), changed(keys)), 0);
    EXPECT_GT(difference(own(classical_keys), changed(keys)), 0.3f);
    const Scene later = with_options(changed("specular_form = 'normalized'\nshininess = 8\n"),
                                     {"color=0.5,0.25,0.1", "specular=0.4,0.3,0.2"});
    EXPECT_EQ(difference(own(keys), later), 0) << "who asks for a form keeps it";
    RenderSettings settings;
    settings.specular_form = SpecularForm::normalized;
    EXPECT_EQ(difference(own(classical_keys), changed(classical_keys), settings), 0);
    EXPECT_EQ(difference(own(keys), changed(classical_keys), settings), 0);
}

/// k_s is still the reflectance that metallic-roughness parameters gave: only what the key says changes.
TEST_F(ChangedHighlight, StaysNormalizedWhereOnlyOtherParametersAreGiven) {
    RenderSettings settings;
    settings.lighting = Lighting::blinn_phong;
    EXPECT_LT(difference(sphere(""), changed("ambient = [1, 0, 0]\n"), settings), 1e-6f);
    settings.specular_form = SpecularForm::textbook;
    EXPECT_LT(difference(sphere(""), changed("ambient = [1, 0, 0]\n"), settings), 1e-6f)
        << "the picture's form goes for it as for any other";
}

}  // namespace
