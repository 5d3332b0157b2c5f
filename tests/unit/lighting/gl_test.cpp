// SPDX-License-Identifier: Apache-2.0
// The lighting text on a GPU, or on Mesa's llvmpipe: every row of lighting_operations.inc evaluated in GLSL 3.30 and in ES
// 3.00 over random items gives what the scalar C++ gives, within the row's tolerances. Skipped where there is no EGL.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "lighting/albedo_tables.h"
#include "support/gl_context.h"
#include "support/shared.h"
#include "unit/lighting/lighting_items.h"

namespace rakelight::lighting_test {
namespace {

using test::GlContext;
using test::GlFlavour;

constexpr int side = 256;                                       ///< items: its square
constexpr int degenerate_width = 100, degenerate_height = 100;  ///< of degenerate_items()

std::string read_source(const std::string& name) {
    std::ifstream file(test::source_dir() / name);
    std::stringstream text;
    text << file.rdbuf();
    EXPECT_FALSE(text.str().empty()) << name;
    return text.str() + "\n";
}

/// Prelude, the test's maps and functions, the lighting text: functions of GLSL must be declared before they are used.
std::string whole_text() {
    std::string operations = read_source("tests/unit/lighting/operations.glsl");
    const std::size_t end_of_maps = operations.find("// real sample_albedo");
    std::string text = read_source("src/math/prelude.glsl") + operations.substr(0, end_of_maps) +
                       read_source("src/lighting/albedo_tables.glsl");
    std::istringstream list(read_source("src/lighting/all.glsl.list"));
    for (std::string name; std::getline(list, name);)
        if (!name.empty() && name[0] != '#') text += read_source("src/lighting/" + name);
    return text + operations.substr(end_of_maps) + read_source("tests/unit/lighting/material_operations.glsl") +
           "#define RL_TANGENT orthogonal_tangent(n, p)\n"
           "#define RL_U vec2(clamp(abs(s), 0.0f, 0.9999999f), clamp(abs(t), 0.0f, 0.9999999f))\n";
}

/// Of one operation: an item a pixel, six texels an item.
std::string main_of(const Operation& operation) {
    std::string text =
        "uniform sampler2D items;\nvoid main() {\n    ivec2 at = ivec2(int(gl_FragCoord.x) * 6, "
        "int(gl_FragCoord.y));\n";
    for (int k = 0; k < 6; ++k)
        text +=
            "    vec4 i" + std::to_string(k) + " = texelFetch(items, at + ivec2(" + std::to_string(k) + ", 0), 0);\n";
    text +=
        "    vec3 n = i0.xyz, l = vec3(i0.w, i1.xy), v = vec3(i1.zw, i2.x), ka = i2.yzw;\n"
        "    vec3 kd = i3.xyz, ks = vec3(i3.w, i4.xy), p = vec3(i4.zw, i5.x);\n"
        "    float e = i5.y, s = i5.z, t = i5.w;\n";
    return text + (operation.width == 3 ? "    result = vec4(" : "    result = vec4(vec3(") +
           std::string(operation.text) + (operation.width == 3 ? ", 1.0);\n}\n" : "), 1.0);\n}\n");
}

Items random_items() {
    Random random;
    Items items;
    for (int i = 0; i < side * side; ++i) items.push(random_item(random));
    return items;
}

/// [height][width] items, 24 floats each.
std::vector<float> texels_of(Items& items, int width, int height) {
    const Inputs in = items.inputs();
    std::vector<float> texels(std::size_t(width) * std::size_t(height) * 24);
    for (std::size_t i = 0; i < texels.size() / 24; ++i)
        for (std::size_t c = 0; c < 24; ++c) texels[i * 24 + c] = in.column[c][i];
    return texels;
}

/// As albedo_tables.glsl says.
std::vector<float> albedo_texels() {
    using namespace lighting;
    const AlbedoTables t = albedo_tables();
    std::vector<float> texels;
    const auto add = [&texels](const float* row, int count) {
        for (int i = 0; i < count; ++i) texels.insert(texels.end(), {row[i], 0, 0, 0});
    };
    add(t.lobe_loss, albedo_rows * albedo_columns);
    add(t.grazing, albedo_rows * albedo_columns);
    add(t.sheen, sheen_rows * albedo_columns);
    add(t.loss, albedo_columns);
    add(t.loss, albedo_columns);
    return texels;
}

/// How far `got` is off, as a multiple of what is allowed; infinity for what is not finite.
double excess(const Operation& operation, float e, float got, float expected) {
    if (!std::isfinite(got) || !std::isfinite(expected)) return std::numeric_limits<double>::infinity();
    const double allowed = double(operation.absolute) + double(operation.relative(e)) * std::abs(double(expected));
    return std::abs(double(got) - double(expected)) / allowed;
}

void expect_row(GlContext& context, const std::string& text, const Operation& operation, Items& items) {
    const std::vector<float> got = context.run(text + main_of(operation), side, side);
    const Results expected = run(scalar::kernel, operation.name, items);
    const Inputs in = items.inputs();
    double worst = 0;
    int over = 0;
    std::size_t at = 0, column = 0;
    for (std::size_t i = 0; i < std::size_t(side) * side; ++i)
        for (std::size_t c = 0; c < expected.width(); ++c) {
            const double off = excess(operation, in.column[21][i], got[4 * i + c], expected[c][i]);
            over += off > 1;
            if (off > worst) worst = off, at = i, column = c;
        }
    EXPECT_LE(worst, 1) << operation.name << ": " << over << " numbers; item " << at << " column " << column << ": "
                        << got[4 * at + column] << ", scalar " << expected[column][at];
}

void expect_all_rows(GlFlavour flavour) {
    std::string why;
    const std::unique_ptr<GlContext> context = GlContext::make(flavour, why);
    if (!context) GTEST_SKIP() << why;
    std::cout << "drawn by " << context->renderer() << "\n";
    Items items = random_items();
    const std::vector<float> numbers = texels_of(items, side, side), albedos = albedo_texels();
    context->set_textures({{"items", 6 * side, side, numbers}, {"rl_albedos", 32, 82, albedos}});
    const std::string text = whole_text();
    for (int o = 0; o < scalar::kernel.operation_count; ++o)
        expect_row(*context, text, scalar::kernel.operations[o], items);
}

/// Directions are unit: no function promises anything of huge ones.
bool has_huge_vector(const Inputs& in, std::size_t item) {
    for (std::size_t c = 0; c < 21; ++c)
        if (std::abs(in.column[c][item]) > 1e10f) return true;
    return false;
}

/// Where the scalar flavour gives a number, the GPU gives one, too.
void expect_no_nan(GlContext& context, const std::string& text, const Operation& operation, Items& items) {
    const std::vector<float> got = context.run(text + main_of(operation), degenerate_width, degenerate_height);
    const Results expected = run(scalar::kernel, operation.name, items);
    const Inputs in = items.inputs();
    for (std::size_t i = 0; i < got.size() / 4; ++i)
        for (std::size_t c = 0; c < expected.width() && !has_huge_vector(in, i); ++c)
            if (std::isnan(got[4 * i + c]) && std::isfinite(expected[c][i])) {
                ADD_FAILURE() << operation.name << " item " << i << " column " << c << ": scalar " << expected[c][i];
                return;
            }
}

TEST(LightingOnGpu, DegenerateInputGivesNoNaN) {
    std::string why;
    const std::unique_ptr<GlContext> context = GlContext::make(GlFlavour::core_33, why);
    if (!context) GTEST_SKIP() << why;
    Items items = degenerate_items();
    ASSERT_EQ(items.size(), std::size_t(degenerate_width) * degenerate_height);
    const std::vector<float> numbers = texels_of(items, degenerate_width, degenerate_height), albedos = albedo_texels();
    context->set_textures(
        {{"items", 6 * degenerate_width, degenerate_height, numbers}, {"rl_albedos", 32, 82, albedos}});
    const std::string text = whole_text();
    for (int o = 0; o < scalar::kernel.operation_count; ++o)
        expect_no_nan(*context, text, scalar::kernel.operations[o], items);
}

TEST(LightingOnGpu, EveryRowGivesTheNumbersOfTheScalarFlavourInGlsl330) { expect_all_rows(GlFlavour::core_33); }
TEST(LightingOnGpu, EveryRowGivesTheNumbersOfTheScalarFlavourInEs300) { expect_all_rows(GlFlavour::es_30); }

}  // namespace
}  // namespace rakelight::lighting_test
