// SPDX-License-Identifier: Apache-2.0
// Baking: what a surface of many triangles (HIGH) looks like, written into maps for one of few (LOW).
//
// Rays go along LOW's normals, which are those over all its objects, from a cage that stands `distance` outside of LOW to
// as far inside; the first triangle of HIGH that faces outward is what a texel shows.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <rakelight/context.h>
#include <rakelight/export.h>
#include <rakelight/image.h>
#include <rakelight/radiosity.h>
#include <rakelight/scene.h>

namespace rakelight {

/// What a map holds.
enum class BakeMap : std::uint8_t {
    normal,     ///< HIGH's shading normal, its own normal map included
    height,     ///< [m] from LOW along its smooth normal
    curvature,  ///< [1/m] mean curvature of HIGH, convex > 0
    occlusion,  ///< 0..1: the share of the sky that HIGH leaves open, weighed by the cosine
    light,      ///< irradiance / pi on HIGH by its lights and all its surfaces, linear RGB: with_radiosity()
};

/// What a map is called, in file names too: "normal".
RL_API const char* name_of(BakeMap map) noexcept;
/// Of pictures of integers: heights 16 bits, else 8.
RL_API Component component_of(BakeMap map) noexcept;
/// All, in their order.
RL_API std::span<const BakeMap> all_bake_maps() noexcept;

/// In what a normal is written: the frame of LOW's interpolated normal and MikkTSpace tangent, or LOW's object space.
enum class BakeSpace : std::uint8_t { tangent, object };

/// What bake() makes of LOW.
struct BakeOptions {
    std::vector<BakeMap> maps{BakeMap::normal};
    int width = 1024, height = 1024;  ///< [px] 1..16384
    double distance = 0;              ///< [m] of the cage, >= 0; 0: proposed (BakeReport::distance)
    BakeSpace space = BakeSpace::tangent;
    /// Normal and tangent are made unit and perpendicular in each texel before the normal is written in them, as engines do
    /// by default; false: as MikkTSpace has it, interpolated and no more.
    bool normalize_frames = false;
    bool green_down = false;  ///< tangent space: green points to increasing v
    /// LOW's normals that the map acts on: `automatic`: the file's where it has them, else made over all objects; `model`:
    /// all are made.
    NormalSource low_normals = NormalSource::automatic;
    /// HIGH's: `automatic`: as it is rendered (glTF without normals is flat); `model`: made over all objects, with a crease angle
    /// of 60 degrees.
    NormalSource high_normals = NormalSource::automatic;
    double crease_angle_rad = pi;   ///< 0..pi: of LOW's normals that are made. The cage has no creases
    int samples = 4;                ///< a texel: 1, 4 or 16, on a regular grid
    int padding = 8;                ///< [px] 0..1024: by how much charts are continued
    bool make_coordinates = false;  ///< also where LOW has texture coordinates; its textures go then
    int chart_margin = 8;           ///< [px] 1..1024: left free between charts that are made
    int rays = 64;                  ///< 1..4096: of occlusion at each sample, rounded up to a square number
    double occlusion_distance = 0;  ///< [m] >= 0: what is farther away hides nothing; 0: nothing is too far
    int light_elements = RadiositySettings{}.elements;  ///< 1..most_radiosity_elements: of light
    double curvature_radius = 0;  ///< [m] >= 0: its curvature is white (concave: black); 0: a 50th of HIGH's diagonal
};

/// What bake() found.
struct BakeReport {
    double distance = 0;            ///< [m] of the cage
    bool is_proposed = false;       ///< it was not given
    double curvature_radius = 0;    ///< [m]
    std::uint64_t texels = 0;       ///< that charts cover or touch
    std::uint64_t beyond = 0;       ///< of them: HIGH is farther off than the cage, which heights of integers end at
    std::uint64_t missed = 0;       ///< of them: no ray met HIGH. They show LOW itself
    std::uint32_t charts = 0;       ///< pieces of LOW that are connected on the map
    std::uint32_t mirrored = 0;     ///< of them: mirrored on the map
    std::uint32_t overlapping = 0;  ///< of them: lie wholly or partly on another one, or on themselves
    std::uint64_t overlapping_texels = 0;  ///< baked once: for a chart that is not mirrored, else the first
    std::uint32_t made_coordinates = 0;    ///< placed meshes of LOW that got texture coordinates
    double texels_per_meter = 0;           ///< of charts that were made
    RadiosityReport radiosity{};           ///< of light
};

/// The numbers of a map, as above; normals are unit, in the space that was asked for, y towards decreasing v.
struct BakedMap {
    BakeMap map = BakeMap::normal;
    int channels = 1;             ///< normal and light: 3
    std::vector<float> values{};  ///< [height * width * channels]
};

/// What bake() made.
struct BakeResult {
    int width = 0, height = 0;     ///< [px]
    std::vector<BakedMap> maps{};  ///< in the order of the options
    BakeReport report{};
    /// LOW as the maps fit it: its coordinates (made, where it had none), normals, tangents; no normal or height maps.
    Scene low{};
    MemoryCharge charge{};  ///< pays for the maps
};

/// Bakes HIGH to LOW. Both may be of many objects; LOW's share one map. Texels beside charts continue the nearest one's
/// numbers as far as the padding goes, then are even (normal: (0, 0, 1); height, curvature and light 0, occlusion 1). Texture
/// coordinates are set 0. Where a mesh of LOW has none, all get new ones: faces that are connected and look along one axis become
/// a chart, and charts are packed in shelves. The same bits for any number of threads.
/// @throws Error usage: options out of their range, no room for the charts; bad_file: see validate(), no triangles, over
///         the memory budget; light: HIGH gives no light, and see with_radiosity(); failed: built without rays or Embree
///         not installed, cancelled
RL_API BakeResult bake_maps(const Scene& high, const Scene& low, const BakeOptions& options, Context& context);

/// Whether this build can.
RL_API bool can_bake() noexcept;

/// A map as a picture. Normals: 0.5 + 0.5 n. Integers: height: 0.5 at LOW, 0 and 1 at the cage; curvature: 0.5 where flat, 0 and 1
/// at 1 / curvature_radius; light: sRGB, 1 at most. Floats: height, curvature, occlusion and light as they are.
/// @throws Error bad_file: over the memory budget
RL_API Pixels picture_of(const BakeResult& result, const BakedMap& map, const BakeOptions& options, Component component,
                         Context& context);

}  // namespace rakelight
