// SPDX-License-Identifier: Apache-2.0
// Common queries of a scene: validation, transforms, bounds, default view, materials.
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

class DrawnVertices;

/// validate() without index blocks that the validated scene `known` has in the mesh of the same index.
void validate_changes(const Scene& scene, const Scene& known);

/// The checks of validate() for lights.
/// @param nodes number of nodes of the scene
void validate_lights(const std::vector<Light>& lights, std::size_t nodes);

/// The fault of a camera's parameters as a message, or null. Engines require more than scenes: a finite far plane for
/// orthographic projection, and both fields of view.
enum class CameraUse { in_scene, in_engine };
const char* fault_of(const Camera& camera, CameraUse use);
/// The fault of subdivision or relief parameters as a message, or null.
const char* fault_of(const Subdivision& subdivision);
const char* fault_of(const Relief& relief);

/// Matrices node -> world, [nodes]. A single pass, because parents precede children.
std::vector<dmat4> world_matrices(const Scene& scene);

/// Axis-aligned box in world space of all drawn vertices of all objects, without non-finite ones. Empty if nothing is
/// drawn.
Bounds world_bounds(const Scene& scene);

/// Triangles of all objects; each instance counts.
std::uint64_t triangle_count(const Scene& scene);

/// Options of a fitted camera.
struct FitOptions {
    /// The world's up direction, which rotates the sides: for Z up the front is at -Y. Nonzero, finite, any length.
    /// Absent: `up`, else +Y.
    std::optional<dvec3> world_up;
    std::optional<dvec3>
        up;  ///< the picture's up vector, nonzero, finite. Absent, or parallel to the view: the side's default
    std::optional<double> vertical_fov_rad;    ///< 0..pi, both exclusive
    std::optional<double> horizontal_fov_rad;  ///< 0..pi, both exclusive; both angles then define the aspect
    bool orthographic = false;
    std::optional<dvec3> direction;             ///< view direction, replaces the side's; nonzero, finite, any length
    double azimuth_rad = 0, elevation_rad = 0;  ///< see orbited()
    double fill = 0.9;                          ///< > 0: share of the picture's smaller side filled by the model
};

/// `v` rotated by the shortest rotation from +Y to `up` (unit); half a turn about Z for -Y.
dvec3 turn_with_up(dvec3 v, dvec3 up);

/// A camera transform orbited about `focal`: to the right about `axis` (unit), then upward about its x axis.
dmat4 orbited(const dmat4& to_world, dvec3 focal, dvec3 axis, double azimuth_rad, double elevation_rad);

/// A camera from a named side, fitted to all drawn vertices: the model fills `fill` of the picture's smaller side and
/// is centered. Perspective with a vertical field of view of 40 degrees by default. Sides: "front" (+Z), "back", "left"
/// (-X), "right", "top" (+Y), "bottom", "isometric", and "default", oblique: from the direction (0.45, 0.35, 1).
/// @throws Error usage for another name.
Camera view_camera(const DrawnVertices& drawn, double aspect, const std::string& side, const FitOptions& options = {});
/// The default camera of models without cameras.
Camera default_camera(const DrawnVertices& drawn, double aspect, const FitOptions& options = {});

/// camera -> world of a camera of this scene, placed by a node or by its matrix, without scale.
dmat4 camera_to_world(const Scene& scene, const Camera& camera, const std::vector<dmat4>& world);

/// Calls f(TextureUse&) for every texture role of a material, also unused ones.
void for_each_texture_use(Material& m, const std::function<void(TextureUse&)>& f);

/// Removes the emission of a material whose emission texture is missing, because the factor alone would be too bright.
/// Reports it. (Other missing textures count as white: docs/materials.md.)
void drop_emission(Material& m, Report& report, const std::string& file, const std::string& place);

/// Gives meshes without a material an explicit default material of this name, so that it can be changed.
void name_default_material(Scene& scene);

/// Conversions between the two parameter sets of a material. Losses: see material_conversion.cpp.
Material classical_from_metallic_roughness(const Material& m);
Material metallic_roughness_from_classical(const Material& m);

/// Roughness of the GGX, Beckmann or Ward lobe that matches a Blinn-Phong exponent >= 0: alpha^2 = 2 / (n + 2) (Karis
/// 2013, "Specular BRDF Reference").
double roughness_of_exponent(double exponent);

/// Reflectance at normal incidence from the index of refraction: ((ior - 1) / (ior + 1))^2 (KHR_materials_ior; 0 is its
/// case for specular-glossiness and gives 1).
float ior_f0(float ior);

/// The specular form of a material: its own, else the picture's. Never automatic: normalized for (converted)
/// metallic-roughness parameters, else textbook.
SpecularForm specular_form_of(const Material& m, SpecularForm wanted);

/// Whether a material needs tangents: bump or normal map, or anisotropy.
bool needs_tangents(const Material& material);

/// The bump technique of a material: its own, else the picture's, else by its maps. Never automatic.
Bump bump_of(const Material& material, Bump wanted);
/// Whether a technique (not automatic) reads height maps.
bool reads_heights(Bump bump);

}  // namespace rakelight
