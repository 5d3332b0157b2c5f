// SPDX-License-Identifier: Apache-2.0
// Questions that every user of a scene asks: is it whole, where is everything, what is the default view of it.
#pragma once
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <rakelight/report.h>
#include <rakelight/scene.h>
#include <rakelight/scene_queries.h>
#include <rakelight/validate.h>

namespace rakelight {

/// validate(), but for index blocks that `known`, a scene that passed it, has in its mesh of the same number.
void validate_changes(const Scene& scene, const Scene& known);

/// What validate() says of a scene's lights. @param nodes  of the scene
void validate_lights(const std::vector<Light>& lights, std::size_t nodes);

/// What is wrong with the numbers of a camera, whatever its node, for people; null: nothing. Engines need more than a
/// scene: a finite far of a parallel projection, and a vertical field of view beside a horizontal one.
enum class CameraUse { in_scene, in_engine };
const char* fault_of(const Camera& camera, CameraUse use);
/// What is wrong with a wish for subdivision, or with the reading of height maps; null: nothing.
const char* fault_of(const Subdivision& subdivision);
const char* fault_of(const Relief& relief);

/// Matrices node -> world, [nodes]. A single pass, since parents come first.
std::vector<dmat4> world_matrices(const Scene& scene);

/// Axis-aligned box of all drawn vertices of all objects, in the world; vertices that are not finite are left out.
/// Empty when nothing is drawn.
Bounds world_bounds(const Scene& scene);

/// How far what is drawn reaches: for each direction (any length) the largest dot product with it of a drawn vertex's place
/// from `about`, in the world. 0 where nothing is drawn; vertices that are not finite are left out.
void farthest_along(const Scene& scene, dvec3 about, std::span<const dvec3> directions, std::span<double> reach);

/// Triangles in all objects, instances counted each time.
std::uint64_t triangle_count(const Scene& scene);

/// What a fitted camera shall keep to; the model fits whatever it is.
struct FitOptions {
    /// The world's up, which sides turn along with: by it the front of a model that is Z up is at -Y. Not zero, finite; any
    /// length. Absent: `up`, else +Y.
    std::optional<dvec3> world_up;
    std::optional<dvec3> up;                   ///< the picture's; likewise. Absent, or along the view: the side's own
    std::optional<double> vertical_fov_rad;    ///< 0..pi, both exclusive
    std::optional<double> horizontal_fov_rad;  ///< likewise; the aspect is that of both angles then
    bool orthographic = false;
    std::optional<dvec3>
        direction;  ///< along which the camera looks, in place of the side's; not zero, finite; any length
    double azimuth_rad = 0, elevation_rad = 0;  ///< see orbited()
    double fill = 0.9;                          ///< > 0: share of the picture's tighter side that the model takes
};

/// `v` turned by the shortest turn that takes +Y to `up` (of length 1); half a turn about Z where up is -Y.
dvec3 turn_with_up(dvec3 v, dvec3 up);

/// A camera's placement turned about `focal`: to the right about `axis` (of length 1), then upward about its own x axis.
dmat4 orbited(const dmat4& to_world, dvec3 focal, dvec3 axis, double azimuth_rad, double elevation_rad);

/// A camera from a named side of the world, as near as lets all that is drawn be seen: it takes `fill` of the picture's
/// tighter side, and has the same room left and right, and above and below. Perspective, 40 degrees vertical, unless
/// `options` say otherwise. Sides: "front" (+Z), "back", "left" (-X), "right", "top" (+Y), "bottom", "isometric", and
/// "default", oblique: from the direction (0.45, 0.35, 1).
/// @param bounds  world_bounds() of the scene
/// @throws Error usage for another name.
Camera view_camera(const Scene& scene, const Bounds& bounds, double aspect, const std::string& side,
                   const FitOptions& options = {});
/// The view by which a model without cameras is shown.
Camera default_camera(const Scene& scene, const Bounds& bounds, double aspect, const FitOptions& options = {});

/// camera -> world of a camera of this scene, whether placed by a node or by itself; scale is taken out.
dmat4 camera_to_world(const Scene& scene, const Camera& camera, const std::vector<dmat4>& world);

/// Calls f(TextureUse&) for every use that a material can have, given or not.
void for_each_texture_use(Material& m, const std::function<void(TextureUse&)>& f);

/// Without its texture a material has no emission: files write a whole factor beside a texture that is mostly black.
/// Says so where there was some. (Other textures that are missing count as white: docs/materials.md.)
void drop_emission(Material& m, Report& report, const std::string& file, const std::string& place);

/// Meshes without a material get one of this name, white and as engines draw such meshes, so that it can be changed.
void name_default_material(Scene& scene);

/// Named conversions between the two parameter sets of a material. What they lose is said in the functions' .cpp.
Material classical_from_metallic_roughness(const Material& m);
Material metallic_roughness_from_classical(const Material& m);

/// Roughness of the GGX, Beckmann or Ward lobe that is as wide as Blinn-Phong's of this exponent >= 0: alpha^2 = 2 / (n + 2)
/// (Karis 2013, "Specular BRDF Reference").
double roughness_of_exponent(double exponent);

/// Reflectance at normal incidence that an index of refraction gives: ((ior - 1) / (ior + 1))^2 (KHR_materials_ior; 0
/// is its case for specular-glossiness and gives 1).
float ior_f0(float ior);

/// How a material's Phong or Blinn-Phong lobe is weighed: as it says itself, else as the picture wants; never
/// automatic: normalized for metallic-roughness parameters and what was made of them, else the textbook's.
SpecularForm specular_form_of(const Material& m, SpecularForm wanted);

/// Whether something of a material acts along the tangent: a bump or normal map, an anisotropic highlight.
bool needs_tangents(const Material& material);

/// How a material's bumps act: as it says itself, else as the picture wants; never automatic: the map that it has
/// decides.
Bump bump_of(const Material& material, Bump wanted);
/// Of a technique that is not automatic.
bool reads_heights(Bump bump);

}  // namespace rakelight
