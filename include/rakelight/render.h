// SPDX-License-Identifier: Apache-2.0
// The facade: load, smooth, render, save. Everything else of the library can be reached from here.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include <rakelight/attributes.h>
#include <rakelight/engine.h>
#include <rakelight/request.h>
#include <rakelight/scene.h>

namespace rakelight {

/// Loads a model file or one of builtin:teapot, sphere, cylinder, cone, torus, plane, with what shape_of_words() takes
/// behind it. What was changed, guessed or dropped goes to context.report().
/// @throws Error not_found, bad_file
Scene load(const std::string& path, const LoadOptions& options, Context& context);

/// Seam-free normals, and tangents where texture coordinates exist: a new scene that shares all untouched data.
Scene smooth(const Scene& scene, const AttributeOptions& options, Context& context);

/// Makes an engine by name ("soft"). @throws Error usage: unknown or not built in.
std::unique_ptr<Engine> make_engine(const std::string& name);

/// Draws a scene with the soft engine: makes normals and tangents that are missing, uses the scene's lights or, where it has
/// none, the default rig. The second form looks through the scene's first camera, or one fitted to its bounding box.
/// @throws Error usage, bad_file "nothing to draw"
Frame render(const Scene& scene, const Camera& camera, const RenderSettings& settings, Context& context);
Frame render(const Scene& scene, const RenderSettings& settings, Context& context);

/// Writes a frame's color: sRGB 8 bit, tone-mapped, for PNG, JPEG and WebP, linear float for EXR and HDR.
/// @throws Error usage (unknown ending, exposure out of range), failed (cannot write). Nothing is left half-written.
void save(const Frame& frame, const std::string& path, const ToneSettings& tone = {});

}  // namespace rakelight
