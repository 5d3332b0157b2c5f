// SPDX-License-Identifier: Apache-2.0
// The facade: load (load.h), smooth, render, save. Everything else of the library can be reached from here.
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <rakelight/attributes.h>
#include <rakelight/engine.h>
#include <rakelight/export.h>
#include <rakelight/image.h>
#include <rakelight/load.h>
#include <rakelight/scene.h>

namespace rakelight {

/// Seam-free normals, and tangents where texture coordinates exist: a new scene that shares all untouched data.
RL_API Scene smooth(const Scene& scene, const AttributeOptions& options, Context& context);

/// Makes an engine by name ("soft"). @throws Error usage: unknown or not built in.
RL_API std::unique_ptr<Engine> make_engine(const std::string& name);

/// Draws a scene with the soft engine: makes normals and tangents that are missing, uses the scene's lights or, where it has
/// none, the default rig. The second form looks through the scene's first camera, or one fitted to its bounding box.
/// @throws Error usage, bad_file "nothing to draw"
RL_API Frame render(const Scene& scene, const Camera& camera, const RenderSettings& settings, Context& context);
/// Through the scene's first camera, or one fitted to it.
RL_API Frame render(const Scene& scene, const RenderSettings& settings, Context& context);

/// Writes a frame's color: sRGB 8 bit, tone-mapped, for PNG, JPEG and WebP, linear float for EXR and HDR.
/// @param behind  linear color, and its alpha, that is laid behind pixels which are not opaque after exposure and tone curve, which do not
///                change it: for frames drawn with RenderSettings::lays_background off
/// @throws Error usage (unknown ending, exposure out of range), failed (cannot write). Nothing is left half-written.
RL_API void save(const Frame& frame, const std::string& path, const ToneSettings& tone = {}, vec4 behind = {});

/// Writes a scene: .glb keeps all but what glTF has no place for, .ply the triangles alone; what is lost is said in the report.
/// @throws Error usage: another ending; bad_file: see validate(), or there is nothing to write; failed: cannot be written
RL_API void save(const Scene& scene, const std::string& path, Context& context);

/// The bytes of the file that save() writes. @param ending  of its name: ".png", ".exr", ...
/// @throws Error usage: unknown ending, exposure out of range
RL_API std::vector<std::byte> encode(const Frame& frame, const std::string& ending, const ToneSettings& tone = {},
                                     vec4 behind = {});

/// A frame's color as display values: [width * height of its window] sRGB codes, R in the low byte, then G, B and alpha, which
/// is not premultiplied. @throws Error usage: exposure out of range
RL_API std::vector<std::uint32_t> to_srgb8(const Frame& frame, const ToneSettings& tone = {}, vec4 behind = {});

}  // namespace rakelight
