// SPDX-License-Identifier: Apache-2.0
// Shaders of the user's in the engine gl: the lighting, the vertices, uniforms, faults by file and line.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "scene/faults.h"
#include "support/shared.h"
#include "support/thrown_error.h"
#include "unit/opengl/opengl_scenes.h"
#include "unit/opengl/opengl_test.h"

namespace rakelight {
namespace {

using test::drawn, test::small, test::OpenGl;

std::string shipped(const std::string& name) {
    std::ifstream file(test::source_dir() / "examples/shaders" / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void set_lighting(RenderSettings& s, const std::string& name, const std::string& text) {
    s.lighting_name = name, s.lighting_text = text;
}
void set_vertices(RenderSettings& s, const std::string& name, const std::string& text) {
    s.vertex_name = name, s.vertex_text = text;
}

/// A grid over the square from -1 to 1 that rises to the middle, with its own normals, tangents, coordinates.
Mesh hill(float height) {
    constexpr int n = 12;
    Mesh mesh;
    std::vector<vec3> positions, normals;
    std::vector<vec4> tangents;
    std::vector<vec2> uv;
    std::vector<std::uint32_t> indices;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            const float x = float(2 * i) / n - 1, y = float(2 * j) / n - 1;
            positions.push_back({x, y, height * (1 - x * x) * (1 - y * y)});
            const float dx = -2 * height * x * (1 - y * y), dy = -2 * height * y * (1 - x * x);
            const float length = std::sqrt(dx * dx + dy * dy + 1);
            normals.push_back({-dx / length, -dy / length, 1 / length});
            const float along = std::sqrt(1 + dx * dx);
            tangents.push_back({1 / along, 0, dx / along, 1});
            uv.push_back({(x + 1) / 2, (1 - y) / 2});
            if (i == n || j == n) continue;
            const auto a = std::uint32_t(j * (n + 1) + i), b = a + n + 1;
            for (const std::uint32_t k : {a, a + 1, b + 1, a, b + 1, b}) indices.push_back(k);
        }
    mesh.positions = positions, mesh.normals = normals, mesh.tangents = tangents, mesh.indices = indices;
    mesh.texcoords.emplace_back(uv);
    mesh.material = 0;
    return mesh;
}

Material glossy(float shininess) {
    Material m = test::matte({0.7f, 0.5f, 0.3f});
    m.classical.ambient = {0.3f, 0.2f, 0.1f};
    m.classical.specular = {0.4f, 0.5f, 0.6f};
    m.classical.shininess = shininess;
    return m;
}

Material metallic() {
    Material m;
    m.base_color = {0.7f, 0.5f, 0.3f, 1};
    m.metallic_roughness.metallic = 0.6f, m.metallic_roughness.roughness = 0.4f;
    return m;
}

Scene hill_of(const Material& material) {
    Scene scene;
    scene.materials = {material};
    test::add_object(scene, hill(0.5f));
    scene.lights = {test::directional({0.3, -0.4, -1}), test::directional({-1, 0.3, -0.5}, {0.3f, 0.4f, 0.5f})};
    Light& lamp = scene.lights.emplace_back();
    lamp.type = LightType::point;
    lamp.position = {0.5, 0.5, 1.5};
    lamp.linear = 0.5f;
    lamp.ambient = {0.1f, 0.2f, 0.3f};
    return scene;
}

double largest_difference(const Frame& a, const Frame& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.color.size(); ++i)
        for (std::size_t c = 0; c < 4; ++c)
            most = std::max(most, std::fabs(double(a.color[i][c]) - double(b.color[i][c])));
    return most;
}

constexpr double one_code = 1.0 / 255;

class OpenGlShaders : public OpenGl {
protected:
    /// The shipped text against the built-in model.
    double beside(const Scene& scene, RenderSettings settings, const std::string& file) {
        const Frame built_in = drawn(*engine, scene, settings, context);
        set_lighting(settings, file, shipped(file));
        return largest_difference(drawn(*engine, scene, settings, context), built_in);
    }
};

TEST_F(OpenGlShaders, PhongOfTheUsersIsTheBuiltInOne) {
    RenderSettings settings = small();
    settings.lighting = Lighting::phong;
    for (const float shininess : {1.0f, 17.0f, 100.0f})
        for (const Shading shading : {Shading::phong, Shading::gouraud, Shading::flat}) {
            settings.shading = shading;
            EXPECT_LT(beside(hill_of(glossy(shininess)), settings, "phong.glsl"), one_code)
                << shininess << " " << int(shading);
        }
    settings.shading = Shading::phong;
    settings.specular_form = SpecularForm::textbook;
    EXPECT_LT(beside(hill_of(metallic()), settings, "phong.glsl"), one_code) << "k_s is f0, the exponent the roughness";
}

/// Light, normal and viewer are one: k_a I_a + k_d I_d + k_s I_s.
TEST_F(OpenGlShaders, ALightingHasTheMaterialsOwnNumbers) {
    Scene scene;
    scene.materials = {glossy(100)};
    test::add_object(scene, test::square_mesh(0));
    scene.lights = {test::directional({0, 0, -1})};
    scene.lights[0].ambient = {0.5f, 0.5f, 0.5f};
    RenderSettings settings = small();
    set_lighting(settings, "phong.glsl", shipped("phong.glsl"));
    const vec4 middle = drawn(*engine, scene, settings, context, test::flat_camera()).color[24 * 64 + 32];
    EXPECT_NEAR(middle.x, 0.5 * 0.3 + 0.7 + 0.4, 1e-3);
    EXPECT_NEAR(middle.y, 0.5 * 0.2 + 0.5 + 0.5, 1e-3);
    EXPECT_NEAR(middle.z, 0.5 * 0.1 + 0.3 + 0.6, 1e-3);
    set_lighting(settings, "numbers.glsl",
                 "LightTerms user_terms(MaterialSurface s, LightSample light) { LightTerms t = no_terms();\n"
                 "t.diffuse = vec3(s.base.exponent, s.alpha_x, s.alpha_y); t.specular = s.base.specular; return t; }");
    settings.channels = channel_diffuse | channel_specular;
    const Frame numbers = drawn(*engine, scene, settings, context, test::flat_camera());
    EXPECT_NEAR(numbers.diffuse[24 * 64 + 32].x, 100, 1e-3);
    EXPECT_NEAR(numbers.diffuse[24 * 64 + 32].y, std::sqrt(2.0 / 102), 1e-5);
    EXPECT_NEAR(numbers.specular[24 * 64 + 32].z, 0.6, 1e-3);
}

TEST_F(OpenGlShaders, WardOfTheUsersIsTheBuiltInOne) {
    RenderSettings settings = small();
    settings.lighting = Lighting::ward;
    EXPECT_LT(beside(hill_of(glossy(17)), settings, "ward.glsl"), one_code);
    EXPECT_LT(beside(hill_of(metallic()), settings, "ward.glsl"), one_code);
    Material brushed = metallic();
    brushed.ward_alpha = vec2{0.4f, 0.1f};
    EXPECT_LT(beside(hill_of(brushed), settings, "ward.glsl"), one_code);
}

/// n.l = 0.8 at every pixel: round(0.8 steps) / steps.
TEST_F(OpenGlShaders, AUniformChangesThePicture) {
    Scene scene;
    scene.materials = {test::matte()};
    test::add_object(scene, test::square_mesh(0));
    scene.lights = {test::directional({0.6, 0, -0.8})};
    RenderSettings settings = small();
    set_lighting(settings, "toon.glsl", shipped("toon.glsl"));
    const auto red = [&] {
        return drawn(*engine, scene, settings, context, test::flat_camera()).color[24 * 64 + 32].x;
    };
    EXPECT_NEAR(red(), 2.0 / 3, 1e-3) << "three steps are the text's own value";
    for (const int steps : {1, 2, 4, 10}) {
        settings.uniforms = {{"steps", {float(steps)}}};
        EXPECT_NEAR(red(), std::floor(0.8 * steps + 0.5) / steps, 1e-3) << steps;
    }
    settings.uniforms = {{"stpes", {1}}};
    EXPECT_EQ(test::error_of(red).setting(), "uniform");
}

std::string fault_of(const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_file);
    return error.reason();
}

TEST_F(OpenGlShaders, FaultsAreNamedByTheUsersFileAndLine) {
    const std::string begin = "LightTerms user_terms(MaterialSurface s, LightSample light)\n{\n    LightTerms t;\n";
    const auto fault = [&](const std::string& text) {
        RenderSettings settings = small();
        set_lighting(settings, "bad.glsl", text);
        return fault_of(test::error_of([&] { drawn(*engine, hill_of(glossy(8)), settings, context); }));
    };
    EXPECT_NE(fault(begin + "    t.diffuse = foo(3);\n    return t;\n}\n").find("bad.glsl:4"), std::string::npos);
    EXPECT_NE(fault(begin + "    t.diffuse = 1;\n    return t;\n}\n").find("bad.glsl:4"), std::string::npos);
    EXPECT_NE(fault(begin + "    t.nothing = vec3(0.0);\n    return t;\n}\n").find("bad.glsl:4"), std::string::npos);
    EXPECT_NE(fault(begin + "    vec2 t;\n    return s;\n}\n").find("bad.glsl:"), std::string::npos);
    EXPECT_NE(
        fault(begin + "    return t;\n}\nReflection reflection() { Reflection r; return r; }\n").find("bad.glsl:"),
        std::string::npos)
        << "found in what follows";
    EXPECT_NE(fault("float user_terms;\n").find("bad.glsl:"), std::string::npos);
    EXPECT_NE(fault(begin + "    return t\n}\n").find("bad.glsl:5"), std::string::npos);
}

TEST_F(OpenGlShaders, FaultsOfBothTextsAreToldApart) {
    RenderSettings settings = small();
    settings.shading = Shading::gouraud;  // the lighting is in the vertex stage, too
    set_lighting(settings, "toon.glsl", shipped("toon.glsl"));
    set_vertices(settings, "wave.glsl", "void user_vertex(inout Vertex v)\n{\n    v.position = foo(3);\n}\n");
    const Error in_vertices = test::error_of([&] { drawn(*engine, hill_of(glossy(8)), settings, context); });
    EXPECT_NE(fault_of(in_vertices).find("wave.glsl:3"), std::string::npos) << in_vertices.reason();
    EXPECT_EQ(in_vertices.setting(), "vertex-shader");
    set_vertices(settings, "wave.glsl", "void user_vertex(inout Vertex v) {}\n");
    set_lighting(settings, "bad.glsl",
                 "LightTerms user_terms(MaterialSurface s, LightSample light)\n{ return foo(3); }\n");
    const Error in_lighting = test::error_of([&] { drawn(*engine, hill_of(glossy(8)), settings, context); });
    EXPECT_NE(fault_of(in_lighting).find("bad.glsl:2"), std::string::npos) << in_lighting.reason();
    EXPECT_EQ(in_lighting.setting(), "lighting");
    set_lighting(settings, "", "");
    set_vertices(settings, "none.glsl", "// user_vertex is not here\n");
    const Error missing = test::error_of([&] { drawn(*engine, hill_of(glossy(8)), settings, context); });
    EXPECT_NE(fault_of(missing).find("none.glsl"), std::string::npos) << missing.reason();
}

constexpr const char* raised =
    "uniform float height;\n"
    "void user_vertex(inout Vertex v) { v.position.z += height * v.position.x + 0.5 * rl_time; }\n";

/// Seen from z = 5 in parallel: what was z = 0 is z = height x + time / 2.
TEST_F(OpenGlShaders, VerticesStandWhereTheTextPutsThem) {
    Scene scene;
    scene.materials = {test::matte()};
    test::add_object(scene, test::square_mesh(0));
    scene.lights = {test::directional({0, 0, -1})};
    RenderSettings settings = small();
    settings.channels = channel_position | channel_depth | channel_face_normal;
    set_vertices(settings, "raised.glsl", raised);
    settings.uniforms = {{"height", {0.75f}}};
    settings.shader_time_s = 0.4;
    for (const Shading shading : {Shading::phong, Shading::flat}) {
        settings.shading = shading;
        const Frame frame = drawn(*engine, scene, settings, context, test::flat_camera());
        for (int x = 9; x < 55; ++x) {
            const std::size_t at = std::size_t(24 * 64 + x);
            const double is_x = (x + 0.5 - 32) / 24;
            ASSERT_NEAR(frame.position[at].x, is_x, 1e-5);
            ASSERT_NEAR(frame.position[at].z, 0.75 * is_x + 0.2, 1e-5);
            ASSERT_NEAR(frame.depth[at], 5 - (0.75 * is_x + 0.2), 1e-5);
            ASSERT_NEAR(frame.face_normal[at].x, -0.6, 1e-5) << "(-0.75, 0, 1) / 1.25";
        }
    }
    const vec4 lit = drawn(*engine, scene, settings, context, test::flat_camera()).color[24 * 64 + 32];
    EXPECT_NEAR(lit.x, 0.8, 1e-3) << "flat shading sees the triangle as it stands";
}

TEST_F(OpenGlShaders, VerticesLeaveTheirBoxAndTakeEdgesAndShadowsAlong) {
    Scene scene;
    scene.materials = {test::matte()};
    test::add_object(scene, test::square_mesh(0, 0.25f), translation(dvec3{3, 0, 0}));
    scene.lights = {test::directional({0, 0, -1})};
    RenderSettings settings = small();
    settings.edges = true;
    settings.line_color = {1, 0, 0, 1};
    set_vertices(settings, "moved.glsl", "void user_vertex(inout Vertex v) { v.position.x -= 3.0; }\n");
    const Frame frame = drawn(*engine, scene, settings, context, test::flat_camera());
    EXPECT_GT(frame.color[26 * 64 + 33].y, 0.5f) << "the square has come into the picture";
    int red = 0;
    for (const vec4& c : frame.color) red += c.x > c.y + 0.3f;
    EXPECT_GT(red, 20) << "its edges, too";
}

/// A floor, and a square over it that the text moves: its shadow moves as far.
TEST_F(OpenGlShaders, ShadowsFollowTheVerticesAndTheirUniforms) {
    Scene scene;
    scene.materials = {test::matte()};
    test::add_object(scene, test::square_mesh(0, 1.0f));
    test::add_object(scene, test::square_mesh(0, 0.3f), translation(dvec3{0, 0, 0.5}));
    scene.lights = {test::directional({1, 0, -1})};
    scene.lights[0].casts_shadow = true;
    RenderSettings settings = small();
    settings.shadows = true;
    set_vertices(settings, "moved.glsl",
                 "uniform float up;\nvoid user_vertex(inout Vertex v)\n"
                 "{ if (abs(v.position.x) < 0.5) { v.position.y += up; } }\n");
    engine->prepare(scene, context);
    const auto is_dark = [&](float up, int row) {
        settings.uniforms = {{"up", {up}}};
        Frame frame;
        engine->render(test::flat_camera(), settings, frame, context);
        return frame.color[std::size_t(row * 64 + 32 + 16)].x < 0.1f;  // x = 0.67: the shadow is from 0.2 to 0.8
    };
    EXPECT_TRUE(is_dark(0, 24));
    EXPECT_FALSE(is_dark(0.6f, 24)) << "the maps that were kept are drawn anew";
    EXPECT_TRUE(is_dark(0.6f, 24 - 14));
}

TEST_F(OpenGlShaders, LightInTangentSpaceIsTheBuiltInOneOfVertices) {
    Scene scene = hill_of(glossy(17));
    scene.materials[0].normal_texture =
        test::add_texture(scene, test::picture(test::rgb_pixels(16, 16, [](int x, int y) {
                              return std::array{128 + 60 * ((x / 4) % 3 - 1), 128 + 60 * ((y / 4) % 3 - 1), 220};
                          })));
    RenderSettings settings = small();
    settings.lighting = Lighting::phong;
    const Frame in_world = drawn(*engine, scene, settings, context);
    settings.tangent_space = TangentSpace::vertex;
    const Frame built_in = drawn(*engine, scene, settings, context);
    EXPECT_GT(largest_difference(in_world, built_in), 2 * one_code) << "interpolated vectors are others";
    settings.tangent_space = TangentSpace::world;
    set_lighting(settings, "tangent_space.glsl", shipped("tangent_space.glsl"));
    set_vertices(settings, "tangent_space.vertex.glsl", shipped("tangent_space.vertex.glsl"));
    EXPECT_LT(largest_difference(drawn(*engine, scene, settings, context), built_in), one_code);
    const test::EnvironmentVariable es("RAKELIGHT_GL", "es");
    engine = opengl::make_engine();
    EXPECT_LT(largest_difference(drawn(*engine, scene, settings, context), built_in), one_code);
}

/// A checkered floor that passes the eye of floor_camera() where x is 0.
Scene checkered_floor(double x) {
    Scene scene;
    scene.materials = {test::matte()};
    scene.materials[0].base_color_texture =
        test::add_texture(scene, test::picture(test::rgb_pixels(16, 16, [](int u, int v) {
                              return std::array{255 * ((u + v) % 2), 16 * u, 16 * v};
                          })));
    dmat4 lies;
    lies[1] = {0, 0, -1, 0}, lies[2] = {0, 1, 0, 0};
    test::add_object(scene, test::square_mesh(0, 3), translation(dvec3{x, 0, 0}) * lies);
    scene.lights = {test::directional({0, -1, 0})};
    return scene;
}

Camera floor_camera() {
    Camera camera;
    camera.vertical_fov_rad = 1.2, camera.z_near = 0.1;
    camera.to_world = look_at({0, 0.25, 0.4}, {-0.2, 0.1, -1}, {0, 1, 0});
    return camera;
}

TEST_F(OpenGlShaders, WhatIsLinearOnTheScreenBendsWhereMovedTrianglesAreCut) {
    RenderSettings settings = small();
    const auto picture = [&](double x) {
        return drawn(*engine, checkered_floor(x), settings, context, floor_camera());
    };
    const Frame in_space = picture(0);
    settings.interpolation = AttributeInterpolation::screen;
    const Frame built_in = picture(0);
    EXPECT_GT(largest_difference(in_space, built_in), 0.2);
    set_vertices(settings, "moved.glsl", "void user_vertex(inout Vertex v) { v.position.x -= 50.0; }\n");
    EXPECT_LT(largest_difference(picture(50), built_in), one_code) << "from outside of the picture";
}

/// The term `diffuse` of a text at each pixel of the floor, where z is not 0, with values that are linear on the screen.
std::vector<vec3> terms_of_floor(Engine& engine, RenderSettings settings, Context& context) {
    settings.interpolation = AttributeInterpolation::screen;
    settings.channels = channel_diffuse;
    const Frame frame = drawn(engine, checkered_floor(0), settings, context, floor_camera());
    std::vector<vec3> terms;
    std::ranges::copy_if(frame.diffuse, std::back_inserter(terms), [](vec3 term) { return term.z != 0; });
    return terms;
}

/// What the text hands on is linear in space, as the point is.
TEST_F(OpenGlShaders, VerticesHandOnTheirValuesWhereTrianglesAreCut) {
    RenderSettings settings = small();
    set_vertices(settings, "places.vertex.glsl",
                 "out vec3 places[2]; out float x;\nvoid user_vertex(inout Vertex v)\n"
                 "{ places[0] = vec3(0.0); places[1] = to_eye(v.position); x = v.position.x; }\n");
    set_lighting(settings, "places.glsl",
                 "in vec3 places[2]; in float x;\n"
                 "LightTerms user_terms(MaterialSurface s, LightSample light) { LightTerms t = no_terms();\n"
                 "t.diffuse = vec3(length(places[1] - rl_point.position), abs(x - rl_point.position.x), 1.0);\n"
                 "return t; }\n");
    const std::vector<vec3> terms = terms_of_floor(*engine, settings, context);
    EXPECT_GT(terms.size(), 1000u);
    for (const vec3& term : terms) {
        ASSERT_NEAR(term.x, 0, 1e-3);
        ASSERT_NEAR(term.y, 0, 1e-3);
    }
}

TEST_F(OpenGlShaders, NamesThatLookLikePartsOfAnArrayAreHandedOnToo) {
    RenderSettings settings = small();
    set_vertices(settings, "names.vertex.glsl",
                 "out float b_1; out float b[2]; out float b_0_1[2];\nvoid user_vertex(inout Vertex v)\n"
                 "{ b_1 = 0.125; b[0] = 0.25; b[1] = 0.5; b_0_1[0] = 0.0; b_0_1[1] = 0.75; }\n");
    set_lighting(settings, "names.glsl",
                 "in float b_1; in float b[2]; in float b_0_1[2];\n"
                 "LightTerms user_terms(MaterialSurface s, LightSample light) { LightTerms t = no_terms();\n"
                 "t.diffuse = vec3(b_1, b[0] + b_0_1[1], b[1] + b_0_1[0]); return t; }\n");
    const std::vector<vec3> terms = terms_of_floor(*engine, settings, context);
    EXPECT_GT(terms.size(), 1000u);
    for (const vec3& term : terms) {
        ASSERT_NEAR(term.x, 0.125, 1e-4);
        ASSERT_NEAR(term.y, 1, 1e-4);
        ASSERT_NEAR(term.z, 0.5, 1e-4);
    }
}

TEST_F(OpenGlShaders, FunctionsOfPixelsAloneCanBeUsed) {
    RenderSettings settings = small();
    set_lighting(settings, "lines.glsl",
                 "LightTerms user_terms(MaterialSurface s, LightSample light) { LightTerms t = no_terms();\n"
                 "t.diffuse = vec3(fwidth(rl_point.position.x) > 0.0 ? 1.0 : 0.5); return t; }");
    EXPECT_NO_THROW(drawn(*engine, hill_of(glossy(8)), settings, context));
}

}  // namespace
}  // namespace rakelight
