// SPDX-License-Identifier: Apache-2.0
// The engine trace beside a minimal loop over Embree: the same rays, tile by tile on the same threads, in turns. The loop keeps the
// distance alone; the engine makes a picture of depth alone, and one of Lambert's light with a shadow ray at each point.
//   embree_peer MODEL [RESOLUTION] [FRAMES]
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include <rakelight/render/picture.h>
#include <rakelight/render/session.h>
#include <rakelight/world/load.h>

#include "cpu_shading/draw_list.h"
#include "engines/raytrace/scene/ray_scene.h"
#include "math/linear.h"
#include "shading/picture_camera.h"

namespace rakelight::bench {
namespace {

constexpr int tile = 32;

/// All triangles of a scene in one geometry, in the world about the eye.
class FlatScene {
public:
    FlatScene(const shading::DrawList& list, dvec3 eye) {
        for (const shading::Draw& draw : list.draws) {
            const Mesh& mesh = list.scene.meshes[draw.mesh];
            const auto first = std::uint32_t(positions_.size() / 3);
            const dmat4 to_eye = translation(-eye) * draw.to_world;
            for (const vec3& p : mesh.positions) {
                const dvec3 at = transform_point(to_eye, cast<double>(p));
                for (std::size_t c = 0; c < 3; ++c) positions_.push_back(float(at[c]));
            }
            for (const std::uint32_t i : mesh.indices) indices_.push_back(first + i);
        }
        positions_.push_back(0);  // Embree reads four numbers at once
        const raytrace::EmbreeLibrary& e = raytrace::embree();
        device_ = e.NewDevice("set_affinity=0");
        scene_ = e.NewScene(device_);
        e.SetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
        RTCGeometry g = e.NewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        e.SetSharedGeometryBuffer(g, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, positions_.data(), 0, 12,
                                  positions_.size() / 3);
        e.SetSharedGeometryBuffer(g, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, indices_.data(), 0, 12,
                                  indices_.size() / 3);
        e.CommitGeometry(g);
        e.AttachGeometry(scene_, g);
        e.ReleaseGeometry(g);
        e.CommitScene(scene_);
    }
    ~FlatScene() {
        raytrace::embree().ReleaseScene(scene_);
        raytrace::embree().ReleaseDevice(device_);
    }
    FlatScene(const FlatScene&) = delete;
    FlatScene& operator=(const FlatScene&) = delete;

    /// Distances of a tile's pixels; with `light`, whether it reaches them, too.
    void trace(const shading::PictureCamera& view, const Window& area, const dvec3* light, float* depth,
               float* seen) const {
        const raytrace::EmbreeLibrary& e = raytrace::embree();
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        const shading::PixelRays rays = shading::pixel_rays(view, area.x, area.y);
        for (int y = 0; y < area.height; ++y)
            for (int x = 0; x < area.width; ++x) {
                const vec3 d = cast<float>(rays.at(x, y));
                RTCRayHit hit{{0, 0, 0, float(view.z_near), d.x, d.y, d.z, 0, float(view.z_far), ~0u, 0, 0}, {}};
                hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
                e.Intersect1(scene_, &context, &hit);
                const std::size_t i = std::size_t(area.y + y) * std::size_t(view.width) + std::size_t(area.x + x);
                depth[i] = hit.ray.tfar;
                if (!light || hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) continue;
                const vec3 at = d * hit.ray.tfar * (1 - 1e-5f), l = cast<float>(*light) - at;
                RTCRay ray{at.x, at.y, at.z, 0, l.x, l.y, l.z, 0, 1, ~0u, 0, 0};
                e.Occluded1(scene_, &context, &ray);
                seen[i] = ray.tfar < 0 ? 0.0f : 1.0f;
            }
    }

private:
    std::vector<float> positions_;
    std::vector<std::uint32_t> indices_;
    RTCDevice device_ = nullptr;
    RTCScene scene_ = nullptr;
};

/// Takes nothing.
class NoSink final : public Sink {
public:
    void begin(int, int, Window, std::uint32_t) override {}
    void tile(const Tile&) override {}
    void end_pass(int) override {}
};

double median(std::vector<double> v) {
    std::ranges::sort(v);
    return v[v.size() / 2];
}

template <class Work>
double seconds(const Work& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void compare(const Scene& loaded, int width, int height, int frames, bool with_shadows) {
    Context context;
    Scene scene = loaded;
    const Camera camera = choose_camera(scene, {}, double(width) / height, context);
    const dvec3 eye = camera.to_world[3].xyz(), light = eye + dvec3{1, 2, 0.5};
    for (Material& m : scene.materials)
        m = Material{.double_sided = true};  // no maps and holes, which the loop does not know
    scene.lights = {{.type = LightType::point, .position = light}};
    RenderSettings settings{.width = width, .height = height};
    if (with_shadows)
        settings.shadows = true, settings.lighting = Lighting::lambert;
    else
        settings.colors = false, settings.channels = channel_depth;
    settings.cull = Cull::none;  // as the loop does
    Session session("trace");
    session.set(scene);
    NoSink sink;
    session.render(camera, settings, sink, context);
    shading::TextureCache textures;
    const cpu_shading::DrawList list = cpu_shading::make_draw_list(scene, textures, context);
    const shading::PictureCamera view = shading::picture_camera_of(list, camera, settings);
    const FlatScene flat(list, eye);
    std::vector<float> depth(std::size_t(width) * std::size_t(height)), seen(depth.size());
    const dvec3 light_about_eye = light - eye;
    const int columns = (width + tile - 1) / tile, rows = (height + tile - 1) / tile;
    const auto bare = [&] {
        context.parallel_for(std::size_t(columns) * std::size_t(rows), [&](std::size_t i) {
            const int x = int(i) % columns * tile, y = int(i) / columns * tile;
            flat.trace(view, {x, y, std::min(tile, width - x), std::min(tile, height - y)},
                       with_shadows ? &light_about_eye : nullptr, depth.data(), seen.data());
        });
    };
    bare();
    std::vector<double> ours, theirs;
    for (int f = 0; f < frames; ++f) {
        theirs.push_back(seconds(bare));
        ours.push_back(seconds([&] { session.render(camera, settings, sink, context); }));
    }
    const double rays = double(depth.size()) / 1e6;
    std::printf("%-16s bare loop %7.2f ms (%5.1f Mpx/s)   engine trace %7.2f ms (%5.1f Mpx/s)   rate %.2f\n",
                with_shadows ? "with shadow rays" : "primary rays", 1e3 * median(theirs), rays / median(theirs),
                1e3 * median(ours), rays / median(ours), median(theirs) / median(ours));
}

int run(int argc, char** argv) {
    if (argc < 2) return std::fprintf(stderr, "usage: embree_peer MODEL [WIDTH,HEIGHT] [FRAMES]\n"), 2;
    int width = 1920, height = 1080;
    if (argc > 2 && std::sscanf(argv[2], "%d,%d", &width, &height) != 2) return 2;
    Context context;
    const Scene scene = load(argv[1], {}, context);
    for (const bool with_shadows : {false, true})
        compare(scene, width, height, argc > 3 ? std::max(1, std::atoi(argv[3])) : 7, with_shadows);
    return 0;
}

}  // namespace
}  // namespace rakelight::bench

int main(int argc, char** argv) {
    try {
        return rakelight::bench::run(argc, argv);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "embree_peer: %s\n", error.what());
        return 1;
    }
}
