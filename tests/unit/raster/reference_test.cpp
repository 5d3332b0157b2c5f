// SPDX-License-Identifier: Apache-2.0
// The soft engine against brute force in double precision: for each pixel a ray, every triangle, textbook formulas. The two
// share only the scene, the decoded textures and the sRGB table. Pixels near an edge (where a ray 1/64 px away meets another
// triangle) are left out: there the fixed-point rule decides, which coverage_test.cpp holds to its own reference.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "engines/raster/raster_engine.h"
#include "image/maps/mip_chain.h"
#include "math/color.h"
#include "support/scene_builder.h"

using namespace rakelight;
using namespace rakelight::test;

namespace {

constexpr int width = 160, height = 120;
constexpr dvec3 eye{0.4, 0.9, 3.2};

struct Ray {
    dvec3 origin, direction;
};  ///< direction has length 1 along the view axis, so t is the depth

struct Hit {
    double t, b1, b2;
    std::uint32_t node, triangle;
};

/// Everything by brute force.
class Reference {
public:
    Reference(const Scene& scene, const Camera& camera) : scene_(scene), camera_(camera) {
        Context context({.threads = 1});
        for (const Texture& t : scene.textures) {
            const Pixels pixels = t.image->decode(*t.image, context);
            srgb_.push_back(make_mip_chain(pixels, ColorSpace::srgb, context));
            linear_.push_back(make_mip_chain(pixels, ColorSpace::linear, context));
        }
    }

    Ray ray(double x, double y) const {
        const dmat4& m = camera_.to_world;
        const double u = (x / width * 2 - 1) * width / height, v = 1 - y / height * 2;
        if (camera_.projection == Projection::orthographic) {
            const double h = camera_.half_height;
            return {m[3].xyz() + m[0].xyz() * (u * h) + m[1].xyz() * (v * h), -m[2].xyz()};
        }
        const double h = std::tan(camera_.vertical_fov_rad / 2);
        return {m[3].xyz(), m[0].xyz() * (u * h) + m[1].xyz() * (v * h) - m[2].xyz()};
    }

    std::optional<Hit> nearest(const Ray& r) const {
        std::optional<Hit> best;
        for (std::uint32_t n = 0; n < scene_.nodes.size(); ++n)
            for (std::uint32_t t = 0; t < mesh(n).triangle_count(); ++t) {
                const std::optional<Hit> hit = meet(r, n, t);
                if (hit && hit->t >= camera_.z_near && hit->t <= camera_.z_far && !is_culled(r, n, t) &&
                    (!best || hit->t < best->t))
                    best = hit;
            }
        return best;
    }

    /// Shading normal: interpolated, bumped, turned to the viewer where its back is seen.
    dvec3 normal(const Ray& r, const Hit& h, double x, double y) const {
        const Mesh& m = mesh(h.node);
        const dmat3 linear = upper_left(matrix(h.node));
        const double mirror = determinant(linear) < 0 ? -1 : 1;
        const auto n_at = [&](std::size_t k) {
            return unit(cofactor(linear) * cast<double>(m.normals[corner(h, k)]) * mirror);
        };
        const auto t_at = [&](std::size_t k) { return unit(linear * cast<double>(m.tangents[corner(h, k)].xyz())); };
        const dvec3 n = unit(mixed(h, n_at(0), n_at(1), n_at(2)));
        dvec3 result = n;
        if (const TextureUse& use = material(h).normal_texture) {
            const dvec3 t_mixed = mixed(h, t_at(0), t_at(1), t_at(2));
            const dvec3 t = unit(t_mixed - n * dot(n, t_mixed)),
                        b = cross(n, t) * (double(m.tangents[corner(h, 0)].w) * mirror);
            const dvec3 texel = sample(use, linear_, h, x, y);
            const double scale = material(h).normal_scale;
            result = unit(t * ((2 * texel.x - 1) * scale) + b * ((2 * texel.y - 1) * scale) + n * (2 * texel.z - 1));
        }
        return is_back(r, h.node, h.triangle) ? -result : result;
    }

    /// Lambert under the scene's lights.
    dvec3 color(const Ray& r, const Hit& h, double x, double y) const {
        const dvec3 n = normal(r, h, x, y), p = r.origin + r.direction * h.t;
        dvec3 albedo = cast<double>(material(h).base_color.xyz()), sum{0, 0, 0};
        if (const TextureUse& use = material(h).base_color_texture) albedo = albedo * sample(use, srgb_, h, x, y);
        for (const Light& light : scene_.lights) {
            const bool far_away = light.type == LightType::directional;
            const dvec3 to_light = far_away ? -light.direction : light.position - p;
            const double d = length(to_light);
            const double attenuation =
                far_away ? 1
                         : 1 / (double(light.constant) + double(light.linear) * d + double(light.quadratic) * d * d);
            sum = sum + albedo * cast<double>(light.diffuse) * (attenuation * std::fmax(0.0, dot(n, to_light / d)));
        }
        return sum;
    }

private:
    static dvec3 unit(dvec3 v) { return v / length(v); }
    const dmat4& matrix(std::uint32_t node) const { return *scene_.nodes[node].local.matrix; }
    const Mesh& mesh(std::uint32_t node) const { return scene_.meshes[scene_.nodes[node].meshes[0]]; }
    const Material& material(const Hit& h) const { return scene_.materials[mesh(h.node).material]; }
    std::uint32_t corner(const Hit& h, std::size_t k) const {
        return mesh(h.node).indices[3 * std::size_t(h.triangle) + k];
    }
    dvec3 place(std::uint32_t node, std::uint32_t triangle, std::size_t k) const {
        return transform_point(matrix(node),
                               cast<double>(mesh(node).positions[mesh(node).indices[3 * std::size_t(triangle) + k]]));
    }
    template <class T>
    static T mixed(const Hit& h, T a, T b, T c) {
        return a * (1 - h.b1 - h.b2) + b * h.b1 + c * h.b2;
    }

    /// Moeller & Trumbore 1997; `anywhere`: on the triangle's plane, for derivatives.
    std::optional<Hit> meet(const Ray& r, std::uint32_t node, std::uint32_t triangle, bool anywhere = false) const {
        const dvec3 a = place(node, triangle, 0), e1 = place(node, triangle, 1) - a, e2 = place(node, triangle, 2) - a;
        const dvec3 p = cross(r.direction, e2);
        const double det = dot(e1, p);
        if (det == 0) return {};
        const dvec3 s = r.origin - a, q = cross(s, e1);
        const Hit hit{dot(e2, q) / det, dot(s, p) / det, dot(r.direction, q) / det, node, triangle};
        if (!anywhere && (hit.b1 < 0 || hit.b2 < 0 || hit.b1 + hit.b2 > 1)) return {};
        return hit;
    }
    bool is_back(const Ray& r, std::uint32_t node, std::uint32_t triangle) const {
        const dvec3 a = place(node, triangle, 0);
        const dvec3 face = cross(place(node, triangle, 1) - a, place(node, triangle, 2) - a);
        const double mirror =
            determinant(upper_left(matrix(node))) < 0 ? -1 : 1;  // glTF 2.0, 3.7.4: winding turns with it
        return dot(face, r.direction) * mirror > 0;
    }
    bool is_culled(const Ray& r, std::uint32_t node, std::uint32_t triangle) const {
        return !scene_.materials[mesh(node).material].double_sided && is_back(r, node, triangle);
    }

    /// Coordinates after the transform of KHR_texture_transform.
    dvec2 texcoord(const TextureUse& use, const Hit& h) const {
        const auto at = [&](std::size_t k) {
            const vec2 uv = mesh(h.node).texcoords[use.texcoord_set][corner(h, k)];
            return dvec2{uv.x, uv.y};
        };
        const dvec2 uv = mixed(h, at(0), at(1), at(2));
        const double c = std::cos(use.transform.rotation_rad), s = std::sin(use.transform.rotation_rad);
        const dvec2 scaled{uv.x * double(use.transform.scale.x), uv.y * double(use.transform.scale.y)};
        return {c * scaled.x + s * scaled.y + double(use.transform.offset.x),
                -s * scaled.x + c * scaled.y + double(use.transform.offset.y)};
    }
    static dvec3 texel(const MipChain& chain, std::size_t level, int x, int y) {
        const MipLevel& m = chain.levels[level];
        const auto wrap = [](int i, int n) { return std::size_t(((i % n) + n) % n); };
        const std::uint32_t v = m.rgba8[wrap(y, m.height) * std::size_t(m.width) + wrap(x, m.width)];
        const auto decode = [&](std::uint32_t byte) {
            return chain.is_srgb ? double(linear_from_srgb8(std::uint8_t(byte))) : byte / 255.0;
        };
        return {decode(v & 255), decode(v >> 8 & 255), decode(v >> 16 & 255)};
    }
    static dvec3 bilinear(const MipChain& chain, std::size_t level, dvec2 uv) {
        const double x = uv.x * chain.levels[level].width - 0.5, y = uv.y * chain.levels[level].height - 0.5;
        const int i = int(std::floor(x)), j = int(std::floor(y));
        const double s = x - i, t = y - j;
        return (texel(chain, level, i, j) * (1 - s) + texel(chain, level, i + 1, j) * s) * (1 - t) +
               (texel(chain, level, i, j + 1) * (1 - s) + texel(chain, level, i + 1, j + 1) * s) * t;
    }
    /// Trilinear, the footprint by central differences on the triangle's plane.
    dvec3 sample(const TextureUse& use, const std::vector<MipChain>& chains, const Hit& h, double x, double y) const {
        const MipChain& chain = chains[use.texture];
        const double step = 1e-3;
        const auto at = [&](double px, double py) {
            return texcoord(use, *meet(ray(px, py), h.node, h.triangle, true));
        };
        const auto texels = [&](dvec2 a, dvec2 b) {
            return std::hypot((a.x - b.x) * chain.levels[0].width, (a.y - b.y) * chain.levels[0].height) / (2 * step);
        };
        const double footprint =
            std::fmax(texels(at(x + step, y), at(x - step, y)), texels(at(x, y + step), at(x, y - step)));
        const double last = double(chain.levels.size() - 1),
                     level = std::fmin(std::fmax(std::log2(footprint), 0), last);
        const auto lower = std::size_t(level), upper = std::min(lower + 1, chain.levels.size() - 1);
        const dvec2 uv = texcoord(use, h);
        const double part = level - double(lower);
        return bilinear(chain, lower, uv) * (1 - part) + bilinear(chain, upper, uv) * part;
    }

    const Scene& scene_;
    const Camera& camera_;
    std::vector<MipChain> srgb_, linear_;
};

/// A ball of the unit radius, u round it, v from the top down, tangents along u.
Mesh ball(std::uint32_t material) {
    constexpr std::uint32_t round = 14, down = 8;
    Mesh mesh;
    std::vector<vec3> positions;
    std::vector<vec4> tangents;
    std::vector<vec2> uv;
    std::vector<std::uint32_t> indices;
    for (std::uint32_t j = 0; j <= down; ++j)
        for (std::uint32_t i = 0; i <= round; ++i) {
            const double a = 2 * pi * i / round, b = pi * (j + 0.25) / (down + 0.5);
            positions.push_back(cast<float>(dvec3{std::sin(b) * std::sin(a), std::cos(b), std::sin(b) * std::cos(a)}));
            tangents.push_back({float(std::cos(a)), 0, float(-std::sin(a)), 1});
            uv.push_back({float(i) / round, float(j) / down});
        }
    for (std::uint32_t j = 0; j < down; ++j)
        for (std::uint32_t i = 0; i < round; ++i) {
            const std::uint32_t a = j * (round + 1) + i, b = a + 1, c = a + round + 1, d = c + 1;
            indices.insert(indices.end(), {a, c, d, a, d, b});
        }
    mesh.normals = mesh.positions = positions;
    mesh.tangents = tangents;
    mesh.texcoords.emplace_back(uv);
    mesh.indices = indices;
    mesh.material = material;
    return mesh;
}

/// A floor through the eye plane, a normal-mapped ball, a mirrored and sheared one, and a square seen from behind.
Scene scene_of_everything() {
    Scene scene;
    const auto wave = [](double x) { return int(std::lround(127.5 + 90 * std::sin(x))); };
    const auto bumps = add_texture(scene, picture(rgb_pixels(32, 16, [&](int x, int y) {
                                       return std::array<int, 3>{wave(x * pi / 8), wave(y * pi / 4), 230};
                                   })));
    const auto tiles = add_texture(scene, picture(rgb_pixels(64, 16, [&](int x, int y) {
                                       return std::array<int, 3>{x * 4, 255 - y * 15, wave(x * pi / 16 + y * pi / 4)};
                                   })));
    Material floor, bumpy, two_sided;
    for (Material* m : {&floor, &bumpy, &two_sided})
        m->model = MaterialModel::metallic_roughness, m->metallic_roughness.metallic = 0;
    floor.base_color_texture = tiles;
    floor.base_color_texture.transform = {{0.3f, -0.2f}, {40, 90}, 0.4f};
    bumpy.base_color = {0.9f, 0.7f, 0.5f, 1};
    bumpy.normal_texture = bumps;
    bumpy.normal_texture.transform.scale = {4, 2};
    bumpy.normal_scale = 0.8f;
    two_sided.double_sided = true;
    two_sided.base_color_texture = tiles;
    two_sided.normal_texture = bumps;
    scene.materials = {floor, bumpy, two_sided};
    const dmat4 lying = {{{1, 0, 0, 0}, {0, 0, -1, 0}, {0, 1, 0, 0}, {0, -1, 0, 1}}};
    const dmat4 sheared = {{{-0.7, 0, 0, 0}, {0.2, 0.9, 0, 0}, {0, 0, 0.6, 0}, {1.4, 0.1, 0.2, 1}}};
    const dmat4 turned = {{{-0.8, 0, 0.3, 0}, {0, 0.8, 0, 0}, {-0.3, 0, -0.8, 0}, {0.1, 1.3, -1, 1}}};
    add_object(scene, square_mesh(0, 20), lying);
    add_object(scene, ball(1), translation(dvec3{-0.8, 0, 0}));
    add_object(scene, ball(1), sheared);
    add_object(scene, square_mesh(2), turned);
    Light lamp;
    lamp.position = {1.5, 2.5, 2};
    lamp.diffuse = {0.9f, 0.8f, 0.7f};
    lamp.linear = 0.05f;
    lamp.quadratic = 0.02f;
    scene.lights = {directional({-0.6, -0.64, -0.48}, {0.3f, 0.35f, 0.4f}), lamp};
    return scene;
}

Camera camera_of(Projection projection) {
    Camera camera;
    camera.projection = projection;
    camera.vertical_fov_rad = radians(55);
    camera.half_height = 1.6;
    camera.z_near = 0.1;
    camera.z_far = 15;  // cuts the floor
    camera.to_world = look_at(eye, {0.2, 0.2, 0}, {0.1, 1, 0});
    return camera;
}

std::uint64_t id_of(const std::optional<Hit>& h) { return h ? (std::uint64_t(h->node) << 32 | h->triangle) : ~0ull; }

}  // namespace

class AgainstBruteForce : public testing::TestWithParam<Projection> {};

TEST_P(AgainstBruteForce, ColorsNormalsDepthsAndObjectsAgreeInsideTriangles) {
    const Scene scene = scene_of_everything();
    const Camera camera = camera_of(GetParam());
    const Reference reference(scene, camera);
    Context context({.threads = 2});
    auto engine = raster::make_engine();
    engine->prepare(scene, context);
    Frame frame;
    engine->render(camera,
                   {.width = width,
                    .height = height,
                    .channels = channel_depth | channel_normal | channel_object,
                    .lighting = Lighting::lambert},
                   frame, context);
    int compared = 0, seen[4] = {0, 0, 0, 0};
    for (int py = 0; py < height; ++py)
        for (int px = 0; px < width; ++px) {
            const double x = px + 0.5, y = py + 0.5, near_by = 1.0 / 64;
            const Ray ray = reference.ray(x, y);
            const std::optional<Hit> hit = reference.nearest(ray);
            bool is_inside = true;
            for (const auto& [dx, dy] : {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)})
                is_inside = is_inside &&
                            id_of(reference.nearest(reference.ray(x + dx * near_by, y + dy * near_by))) == id_of(hit);
            if (!is_inside) continue;
            ++compared;
            const auto at = std::size_t(py * width + px);
            ASSERT_EQ(frame.object[at], hit ? hit->node : no_index) << px << ", " << py;
            if (!hit) continue;
            ++seen[hit->node];
            const dvec3 color = reference.color(ray, *hit, x, y), normal = reference.normal(ray, *hit, x, y);
            const vec4 is = frame.color[at];
            EXPECT_NEAR(frame.depth[at], hit->t, 2e-5 * hit->t) << px << ", " << py;
            // Attributes are those of the triangle with its corners on the grid of 1/256 pixel.
            EXPECT_NEAR(length(cast<double>(frame.normal[at]) - normal), 0, 5e-3)
                << px << ", " << py << " node " << hit->node;
            EXPECT_NEAR(length(dvec3{is.x, is.y, is.z} - color), 0, 1.0 / 255)
                << px << ", " << py << " node " << hit->node;
        }
    EXPECT_GT(compared, width * height * 9 / 10);
    for (const int pixels : seen) EXPECT_GT(pixels, 300) << "every kind of object is in the picture";
}

INSTANTIATE_TEST_SUITE_P(SoftEngine, AgainstBruteForce,
                         testing::Values(Projection::perspective, Projection::orthographic));
