// SPDX-License-Identifier: Apache-2.0
// Baking: stores details of a high-polygon surface (HIGH) in maps for a low-polygon surface (LOW).
//
// Rays follow LOW's normals, which are smooth across its objects, from a cage `distance` outside of LOW to the same
// distance inside. A texel shows the first triangle of HIGH that faces outward.
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

/// The content of a map.
enum class BakeMap : std::uint8_t {
    normal,     ///< HIGH's shading normal, including its normal map
    height,     ///< [m] from LOW along its smooth normal
    curvature,  ///< [1/m] mean curvature of HIGH, convex > 0
    occlusion,  ///< 0..1: cosine-weighted visible share of the hemisphere above HIGH
    light,      ///< irradiance / pi on HIGH from its lights and surfaces, linear RGB: with_radiosity()
};

/// The name of a map, also in file names: "normal".
RL_API const char* name_of(BakeMap map) noexcept;
/// Component type of integer pictures: 16 bits for heights, else 8.
RL_API Component component_of(BakeMap map) noexcept;
/// All maps in their order.
RL_API std::span<const BakeMap> all_bake_maps() noexcept;

/// The space of normals: the tangent space of LOW's interpolated normal and MikkTSpace tangent, or LOW's object space.
enum class BakeSpace : std::uint8_t { tangent, object };

/// Options of bake_maps().
struct BakeOptions {
    std::vector<BakeMap> maps{BakeMap::normal};
    int width = 1024, height = 1024;  ///< [px] 1..16384
    double distance = 0;              ///< [m] distance of the cage, >= 0; 0: automatic (BakeReport::distance)
    BakeSpace space = BakeSpace::tangent;
    /// Orthonormalize normal and tangent per texel, as engines do by default; false: only interpolate them, as in
    /// MikkTSpace.
    bool normalize_frames = false;
    bool green_down = false;  ///< tangent space: green points to increasing v
    /// LOW's normals. `automatic`: the file's if present, else computed over all objects; `model`: always computed.
    NormalSource low_normals = NormalSource::automatic;
    /// HIGH's normals. `automatic`: as rendered (glTF without normals is flat); `model`: computed over all objects with
    /// a crease angle of 60 degrees.
    NormalSource high_normals = NormalSource::automatic;
    double crease_angle_rad = pi;   ///< 0..pi: for LOW's computed normals. The cage has no creases
    int samples = 4;                ///< per texel: 1, 4 or 16, on a regular grid
    int padding = 8;                ///< [px] 0..1024: how far the borders of charts are extended
    bool make_coordinates = false;  ///< replace LOW's texture coordinates; its textures are removed
    int chart_margin = 8;           ///< [px] 1..1024: free space between computed charts
    int rays = 64;                  ///< 1..4096: occlusion rays per sample, rounded up to a square number
    double occlusion_distance = 0;  ///< [m] >= 0: maximum distance of occluders; 0: unlimited
    int light_elements = RadiositySettings{}.elements;  ///< 1..max_radiosity_elements: for BakeMap::light
    double curvature_radius =
        0;  ///< [m] >= 0: radius whose curvature is white (concave: black); 0: 1/50 of HIGH's diagonal
};

/// Statistics of bake_maps().
struct BakeReport {
    double distance = 0;            ///< [m] distance of the cage
    bool is_proposed = false;       ///< the distance was chosen automatically
    double curvature_radius = 0;    ///< [m]
    std::uint64_t texels = 0;       ///< covered or touched by charts
    std::uint64_t beyond = 0;       ///< of these: HIGH is beyond the cage; integer heights are clamped
    std::uint64_t missed = 0;       ///< of these: no ray hit HIGH; they show LOW itself
    std::uint32_t charts = 0;       ///< connected pieces of LOW on the map
    std::uint32_t mirrored = 0;     ///< of these: mirrored on the map
    std::uint32_t overlapping = 0;  ///< of these: overlap another chart or themselves
    std::uint64_t overlapping_texels =
        0;  ///< texels of several charts: baked for the first chart that is not mirrored, else the first
    std::uint32_t made_coordinates = 0;  ///< mesh instances of LOW that got texture coordinates
    double texels_per_meter = 0;         ///< resolution of computed charts
    RadiosityReport radiosity{};         ///< of BakeMap::light
};

/// The values of a map, see BakeMap; normals are unit, in BakeOptions::space, y towards decreasing v.
struct BakedMap {
    BakeMap map = BakeMap::normal;
    int channels = 1;             ///< normal and light: 3
    std::vector<float> values{};  ///< [height * width * channels]
};

/// Result of bake_maps().
struct BakeResult {
    int width = 0, height = 0;     ///< [px]
    std::vector<BakedMap> maps{};  ///< in the order of the options
    BakeReport report{};
    /// LOW with matching texture coordinates (computed if it had none), normals and tangents; without normal and height
    /// maps.
    Scene low{};
    MemoryCharge charge{};  ///< memory charge of the maps
};

/// Bakes HIGH to LOW. Both may have many objects; LOW's objects share one map. Texels outside of charts copy the
/// nearest chart within the padding. Beyond it they are constant (normal: (0, 0, 1); height, curvature and light 0,
/// occlusion 1). Texture coordinates are those of set 0. If a mesh of LOW has none, all meshes get new ones: connected
/// faces along one axis form a chart, and charts are packed in shelves. Bit-identical for any number of threads.
/// @throws Error usage: options out of range, no space for the charts; bad_file: see validate(), no triangles, over the
///         memory budget; light: HIGH has no light, and as with_radiosity(); failed: built without rays or Embree not
///         installed, cancelled
RL_API BakeResult bake_maps(const Scene& high, const Scene& low, const BakeOptions& options, Context& context);

/// Whether this build supports baking.
RL_API bool can_bake() noexcept;

/// A map as a picture. Normals: 0.5 + 0.5 n. Integers: height: 0.5 at LOW, 0 and 1 at the cage; curvature: 0.5 where flat, 0 and 1
/// at 1 / curvature_radius; light: sRGB, 1 at most. Floats: height, curvature, occlusion and light as they are.
/// @throws Error bad_file: over the memory budget
RL_API Pixels picture_of(const BakeResult& result, const BakedMap& map, const BakeOptions& options, Component component,
                         Context& context);

}  // namespace rakelight
