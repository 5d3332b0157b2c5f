// SPDX-License-Identifier: Apache-2.0
// The facade: load (load.h), smooth, render, save.
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

/// Computes seam-free normals, and tangents where texture coordinates exist. Returns a new scene that shares all
/// unchanged data.
RL_API Scene smooth(const Scene& scene, const AttributeOptions& options, Context& context);

/// Makes an engine by name ("soft").
/// @throws Error usage: unknown or not built in.
RL_API std::unique_ptr<Engine> make_engine(const std::string& name);

/// Draws a scene with the soft engine. Missing normals and tangents are computed. A scene without lights gets the
/// default light rig.
/// @throws Error usage, bad_file "nothing to draw"
RL_API Frame render(const Scene& scene, const Camera& camera, const RenderSettings& settings, Context& context);
/// The same through the scene's first camera, or one fitted to its bounding box.
RL_API Frame render(const Scene& scene, const RenderSettings& settings, Context& context);

/// Writes a frame's color: sRGB 8 bit, tone-mapped, for PNG, JPEG and WebP, linear float for EXR and HDR.
/// @param behind linear color and alpha of a background, composited behind pixels that are not opaque. Exposure and
///         tone curve do not apply to it. For frames drawn with RenderSettings::composites_background = false
/// @throws Error usage (unknown ending, exposure out of range), failed (cannot write). Nothing is left half-written.
RL_API void save(const Frame& frame, const std::string& path, const ToneSettings& tone = {}, vec4 behind = {});

/// Writes a scene: .glb stores everything that glTF can express, .ply only triangles. The report lists what is lost.
/// @throws Error usage: another ending; bad_file: see validate(), or there is nothing to write; failed: cannot be written
RL_API void save(const Scene& scene, const std::string& path, Context& context);

/// The bytes of the file that save() writes.
/// @param ending  of its name: ".png", ".exr", ...
/// @throws Error usage: unknown ending, exposure out of range
RL_API std::vector<std::byte> encode(const Frame& frame, const std::string& ending, const ToneSettings& tone = {},
                                     vec4 behind = {});

/// A frame's color as display values: [width * height of its window] sRGB codes, R in the low byte, then G, B and alpha, which
/// is not premultiplied.
/// @throws Error usage: exposure out of range
RL_API std::vector<std::uint32_t> to_srgb8(const Frame& frame, const ToneSettings& tone = {}, vec4 behind = {});

}  // namespace rakelight
