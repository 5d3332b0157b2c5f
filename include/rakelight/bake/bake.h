// SPDX-License-Identifier: Apache-2.0
// Baking: stores details of a high-polygon surface (HIGH) in maps for a low-polygon surface (LOW).
//
// The cage is the surface of LOW, moved outward by `distance` along normals that are smooth over all objects of LOW.
// Each ray starts at the cage, runs along these normals, and ends at the same distance inside of LOW. A texel shows the
// first triangle on its ray that belongs to HIGH and faces outward.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/base/export.h>
#include <rakelight/geometry/attributes.h>
#include <rakelight/image/image.h>
#include <rakelight/radiosity/radiosity.h>
#include <rakelight/scene/scene.h>

namespace rakelight {

/// The content of a map.
enum class BakeMap : std::uint8_t {
    normal,     ///< HIGH's shading normal, including its normal map
    height,     ///< [m] distance of HIGH from LOW along LOW's smooth normal
    curvature,  ///< [1/m] mean curvature of HIGH; convex > 0
    occlusion,  ///< 0..1: cosine-weighted unoccluded share of the hemisphere above HIGH
    light,      ///< irradiance / pi on HIGH, from HIGH's lights and surfaces, linear RGB: with_radiosity()
};

/// The name of a map, also in file names: "normal".
RL_API const char* name_of(BakeMap map) noexcept;
/// Component type of integer pictures: 16 bits for heights, 8 bits for all other maps.
RL_API Component component_of(BakeMap map) noexcept;
/// All maps in their order.
RL_API std::span<const BakeMap> all_bake_maps() noexcept;

/// The space of normals. `tangent`: the tangent space of LOW's interpolated normal and MikkTSpace tangent. `object`:
/// LOW's object space.
enum class BakeSpace : std::uint8_t { tangent, object };

/// Options of bake_maps().
struct BakeOptions {
    std::vector<BakeMap> maps{BakeMap::normal};
    int width = 1024, height = 1024;  ///< [px] 1..16384
    double distance = 0;              ///< [m] distance of the cage, >= 0; 0: automatic (BakeReport::distance)
    BakeSpace space = BakeSpace::tangent;
    /// true: orthonormalize normal and tangent in each texel, as engines do by default. false: only interpolate normal
    /// and tangent, as in MikkTSpace.
    bool normalize_frames = false;
    bool green_down = false;  ///< in tangent space: green points to increasing v
    /// LOW's normals. `automatic`: the normals of the file if present, else computed over all objects. `model`: always
    /// computed over all objects.
    NormalSource low_normals = NormalSource::automatic;
    /// HIGH's normals. `automatic`: as rendered, so that glTF without normals is flat. `model`: computed over all
    /// objects with a crease angle of 60 degrees.
    NormalSource high_normals = NormalSource::automatic;
    double crease_angle_rad = pi;  ///< 0..pi: for LOW's computed normals. The normals of the cage have no creases
    /// For LOW's computed normals. `automatic`: creases by the rule, not by crease_angle_rad.
    Creasing creases = Creasing::angle;
    CornerWeight weight = CornerWeight::automatic;  ///< for LOW's computed normals
    int samples = 4;                                ///< samples per texel: 1, 4 or 16, on a regular grid
    int padding = 8;                ///< [px] 0..1024: width by which charts are extended beyond their borders
    bool make_coordinates = false;  ///< replace LOW's texture coordinates; LOW's textures are removed
    int chart_margin = 8;           ///< [px] 1..1024: free space between computed charts
    int rays = 64;                  ///< 1..4096: occlusion rays per sample, rounded up to a square number
    double occlusion_distance = 0;  ///< [m] >= 0: maximum distance of occluders; 0: unlimited
    int light_elements = RadiositySettings{}.elements;  ///< 1..max_radiosity_elements: for BakeMap::light
    /// [m] >= 0; 0: 1/50 of HIGH's diagonal. In integer pictures, a convex surface with this radius of curvature is
    /// white, and a concave surface with this radius is black.
    double curvature_radius = 0;
};

/// Statistics of bake_maps().
struct BakeReport {
    double distance = 0;            ///< [m] distance of the cage
    bool is_proposed = false;       ///< the distance was chosen automatically
    double curvature_radius = 0;    ///< [m] see BakeOptions::curvature_radius
    std::uint64_t texels = 0;       ///< texels that charts cover or touch
    std::uint64_t beyond = 0;       ///< texels where HIGH is beyond the cage; integer heights are clamped there
    std::uint64_t missed = 0;       ///< texels where no ray hit HIGH; they show LOW itself
    std::uint32_t charts = 0;       ///< connected pieces of LOW on the map
    std::uint32_t mirrored = 0;     ///< charts that are mirrored on the map
    std::uint32_t overlapping = 0;  ///< charts that overlap another chart or themselves
    /// Texels that several charts cover. They are baked for the first chart that is not mirrored. If all charts are
    /// mirrored, they are baked for the first chart.
    std::uint64_t overlapping_texels = 0;
    std::uint32_t made_coordinates = 0;  ///< mesh instances of LOW that got new texture coordinates
    double texels_per_meter = 0;         ///< resolution of computed charts
    RadiosityReport radiosity{};         ///< statistics of the light for BakeMap::light
};

/// The values of a map, see BakeMap. Normals are unit, in BakeOptions::space; in tangent space y points to decreasing
/// v.
struct BakedMap {
    BakeMap map = BakeMap::normal;
    int channels = 1;             ///< 3 for normal and light, otherwise 1
    std::vector<float> values{};  ///< [height * width * channels]
};

/// Result of bake_maps().
struct BakeResult {
    int width = 0, height = 0;     ///< [px]
    std::vector<BakedMap> maps{};  ///< in the order of the options
    BakeReport report{};
    /// LOW with the texture coordinates, normals and tangents that fit the maps. Texture coordinates are computed if
    /// LOW had none. Normal maps and height maps of LOW are removed.
    Scene low{};
    MemoryCharge charge{};  ///< memory charge of the maps
};

/// Bakes HIGH to LOW. Both may have many objects; all objects of LOW share one map. Texels outside of all charts copy
/// the nearest chart within the padding. Beyond the padding they have a constant value: (0, 0, 1) for normals, 1 for
/// occlusion, 0 for height, curvature and light.
///
/// The maps use set 0 of LOW's texture coordinates. If a mesh of LOW has no set 0, all meshes of LOW get new texture
/// coordinates. For these, connected faces along one axis form a chart, and charts are packed in shelves. Bit-identical
/// for any number of threads.
/// @throws Error usage: options out of range, or the charts do not fit; bad_file: an invalid scene (see validate()), no
///         triangles, over the memory budget, BakeMap::light of a HIGH without light; failed: built without rays,
///         Embree is not installed, cancelled. BakeMap::light also throws as with_radiosity()
RL_API BakeResult bake_maps(const Scene& high, const Scene& low, const BakeOptions& options, Context& context);

/// Whether this build supports baking.
RL_API bool can_bake() noexcept;

/// A map as a picture. Normals n are stored as 0.5 + 0.5 n. In float pictures all other maps keep their values. Integer
/// pictures are scaled:
/// - height: 0.5 at LOW, 1 at the cage, 0 at the same distance inside;
/// - curvature: 0.5 where flat, 1 at 1 / curvature_radius, 0 at -1 / curvature_radius;
/// - occlusion: 0..1;
/// - light: sRGB, clamped to 1.
/// @throws Error bad_file: over the memory budget
RL_API Pixels picture_of(const BakeResult& result, const BakedMap& map, const BakeOptions& options, Component component,
                         Context& context);

}  // namespace rakelight
