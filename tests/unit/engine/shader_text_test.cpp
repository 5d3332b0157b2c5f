// SPDX-License-Identifier: Apache-2.0
// What GLSL texts of the user's declare, and the values of their uniforms.
#include "engines/shader_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "scene/faults.h"
#include "support/thrown_error.h"

namespace rakelight {
namespace {

/// The place and the reason of a text that is refused.
std::string fault_of(const std::string& text) {
    const Error error = test::error_of([&] { parse_shader_text("mine.glsl", text); });
    EXPECT_EQ(error.code(), ErrorCode::bad_file);
    EXPECT_EQ(error.file(), "mine.glsl");
    return error.place() + ": " + error.reason();
}

TEST(ShaderText, DeclarationsAreTakenOutAndLinesStay) {
    const std::string text =
        "uniform float height = 0.5, width = -1.5e-1f; // uniform float not_this;\n"
        "/* in vec3 nor_this; */ uniform highp vec3 tint = vec3(1.0, .5, 0);\n"
        "#define MANY \\\n uniform float nor_that\n"
        "uniform int count=3;\nuniform vec2 size = vec2(2);\n"
        "in\nvec3 a[4];\nout vec4 b;\n"
        "const float c[2] = float[2](1.0, 2.0);\n"
        "void f(in float x, out float y) { y = x; }\n";
    const ShaderText parsed = parse_shader_text("mine.glsl", text);
    ASSERT_EQ(parsed.uniforms.size(), 5u);
    EXPECT_EQ(parsed.uniforms[0].name, "height");
    EXPECT_EQ(parsed.uniforms[0].value, std::vector<float>{0.5f});
    EXPECT_EQ(parsed.uniforms[1].value, std::vector<float>{-0.15f});
    EXPECT_EQ(parsed.uniforms[2].type, "vec3");
    EXPECT_EQ(parsed.uniforms[2].line, 2);
    EXPECT_EQ(parsed.uniforms[2].value, (std::vector<float>{1, 0.5f, 0}));
    EXPECT_EQ(parsed.uniforms[3].value, std::vector<float>{3});
    EXPECT_EQ(parsed.uniforms[4].value, (std::vector<float>{2, 2}));
    ASSERT_EQ(parsed.inputs.size(), 1u);
    EXPECT_EQ(parsed.inputs[0].count, 4);
    ASSERT_EQ(parsed.outputs.size(), 1u);
    EXPECT_EQ(parsed.body.size(), text.size());
    EXPECT_EQ(parsed.last_line, 12);
    EXPECT_EQ(std::ranges::count(parsed.body, '\n'), std::ranges::count(text, '\n'));
    for (const char* const gone : {"uniform int", "in\nvec3", "out vec4"})
        EXPECT_EQ(parsed.body.find(gone), std::string::npos) << gone;
    EXPECT_NE(parsed.body.find("void f(in float x, out float y)"), std::string::npos);
}

TEST(ShaderText, FaultsAreNamedByTheirLine) {
    EXPECT_EQ(fault_of("float x;\nvoid f()\n{\n  if (x > 0.0) {\n}\n"), "line 3: '{' is not closed");
    EXPECT_EQ(fault_of("float x;\n}\n"), "line 2: '}' closes nothing");
    EXPECT_EQ(fault_of("float f(float x] { return x; }"), "line 1: ']' closes nothing");
    EXPECT_EQ(fault_of("\n/* begun\n"), "line 2: a comment begins that does not end");
    EXPECT_EQ(fault_of("#ifdef A\n#if B\n#endif\n"), "line 1: an #if begins that does not end");
    EXPECT_EQ(fault_of("\n#endif\n"), "line 2: an #endif without its #if");
    EXPECT_EQ(fault_of("\nuniform sampler2D map;\n").find("line 2: 'uniform sampler2D' is not supported"), 0u);
    EXPECT_EQ(fault_of("uniform mat4 m;").find("line 1: 'uniform mat4' is not supported"), 0u);
    EXPECT_EQ(fault_of("flat in vec3 n;"), "line 1: 'in' must begin its declaration, without qualifiers");
    EXPECT_EQ(fault_of("layout(location = 0) out vec3 n;").find("line 1: 'out' must begin"), 0u);
    EXPECT_EQ(fault_of("uniform float rl_fog;"), "line 1: 'rl_fog': names with 'rl_' are the engine's");
    EXPECT_EQ(fault_of("uniform float a;\nuniform vec2 a;"), "line 2: 'a' is declared twice");
    EXPECT_EQ(fault_of("uniform float a = b;"), "line 1: the value of 'a' must be a number, or float(numbers)");
    EXPECT_EQ(fault_of("uniform float a = 1e999;").find("line 1: the value of 'a'"), 0u);
    EXPECT_EQ(fault_of("uniform vec3 a = vec3(1, 2);").find("line 1: the value of 'a'"), 0u);
    EXPECT_EQ(fault_of("uniform float a[3];"), "line 1: 'a': a uniform cannot be an array");
    EXPECT_EQ(fault_of("out float a[17];"), "line 1: 'a' must have 1 to 16 elements");
    EXPECT_EQ(fault_of("uniform float a"), "line 1: ';' is missing after a declaration");
    EXPECT_EQ(fault_of("uniform"), "line 1: 'uniform ' is not supported: declare float, int, vec2, vec3 or vec4");
    EXPECT_EQ(fault_of("uniform float " + std::string(65, 'x') + ";"), "line 1: a name has more than 64 characters");
}

RenderSettings with(std::vector<ShaderUniform> uniforms) {
    RenderSettings s;
    s.lighting_name = "mine.glsl";
    s.lighting_text = "uniform float height = 2.0; uniform vec3 tint; uniform int steps = 3; // user_terms\n";
    s.uniforms = std::move(uniforms);
    return s;
}

TEST(UserShaders, UniformsHaveTheValuesOfTheSettingsElseTheirOwn) {
    const UserShaders s = user_shaders_of(with({{"tint", {1, 0.5f, 0}}}));
    ASSERT_EQ(s.uniforms.size(), 3u);
    EXPECT_EQ(s.uniforms[0].value, std::vector<float>{2});
    EXPECT_EQ(s.uniforms[1].value, (std::vector<float>{1, 0.5f, 0}));
    EXPECT_EQ(s.uniforms[2].value, std::vector<float>{3});
}

std::string uniform_fault(std::vector<ShaderUniform> uniforms) {
    const Error error = test::error_of([&] { check_shaders(with(std::move(uniforms))); });
    EXPECT_EQ(error.code(), ErrorCode::usage);
    EXPECT_EQ(error.setting(), "uniform");
    return error.reason() + "; " + error.advice();
}

TEST(UserShaders, ValuesThatDoNotFitAreRefused) {
    constexpr float inf = std::numeric_limits<float>::infinity();
    EXPECT_EQ(uniform_fault({{"hieght", {1}}}),
              "'hieght' is no uniform of the GLSL text; did you mean 'height'? it declares height (float), tint "
              "(vec3), steps (int)");
    EXPECT_EQ(uniform_fault({{"tint", {1}}}), "'tint' is a vec3, which needs 3 numbers, not 1; ");
    EXPECT_EQ(uniform_fault({{"height", {1, 2}}}), "'height' is a float, which needs 1 number, not 2; ");
    EXPECT_EQ(uniform_fault({{"height", {inf}}}), "the value of 'height' is not finite; ");
    EXPECT_EQ(uniform_fault({{"steps", {1.5f}}}), "'steps' is an int, which needs a whole number up to 16777216; ");
    EXPECT_EQ(uniform_fault({{"height", {1}}, {"height", {1}}}), "'height' is given twice; ");
    EXPECT_EQ(uniform_fault(std::vector<ShaderUniform>(65)), "there may be 64 values; ");
    RenderSettings none;
    none.uniforms = {{"height", {1}}};
    EXPECT_EQ(test::error_of([&] { check_shaders(none); }).reason(),
              "'height' is no uniform: there is no GLSL text that declares it");
}

std::string pair_fault(const std::string& vertex, const std::string& lighting) {
    RenderSettings s;
    s.lighting_name = "light.glsl", s.lighting_text = lighting;
    s.vertex_name = "vertex.glsl", s.vertex_text = vertex;
    const Error error = test::error_of([&] { check_shaders(s); });
    EXPECT_EQ(error.code(), ErrorCode::bad_file);
    return error.file() + " " + error.place() + ": " + error.reason();
}

TEST(UserShaders, WhatIsHandedOnMustBeDeclaredAlike) {
    EXPECT_EQ(pair_fault("out vec3 a;", "\nin vec3 b;"),
              "light.glsl line 2: 'b' is an input, but vertex.glsl gives no output of this name and type");
    EXPECT_EQ(pair_fault("out vec3 a[3];", "in vec3 a[2];").find("light.glsl line 1: 'a' is an input"), 0u);
    EXPECT_EQ(pair_fault("in vec3 a;", "x").find("vertex.glsl line 1: 'a' is an input"), 0u);
    EXPECT_EQ(pair_fault("out vec4 a[9];", "x"), "vertex.glsl line 1: 'a' is too much: 32 numbers may be handed on");
    EXPECT_EQ(pair_fault("uniform float a;", "uniform vec2 a;"),
              "light.glsl line 1: 'a' is declared otherwise in vertex.glsl");
    EXPECT_EQ(pair_fault("x", "out vec3 a, b, c, d, e;"),
              "light.glsl line 1: 'e' is one term too many: there may be 4");
    RenderSettings alone = with({});
    alone.lighting_text = "in vec3 a;";
    EXPECT_EQ(test::error_of([&] { check_shaders(alone); }).reason(),
              "'a' is an input, but there is no vertex shader that gives it");
}

}  // namespace
}  // namespace rakelight
