// SPDX-License-Identifier: Apache-2.0
// The facade: load (load.h), smooth, render, save.
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <rakelight/base/export.h>
#include <rakelight/engines/engine.h>
#include <rakelight/geometry/attributes.h>
#include <rakelight/image/image.h>
#include <rakelight/scene/scene.h>
#include <rakelight/world/load.h>

namespace rakelight {

/// Computes seam-free normals, and tangents where texture coordinates exist. Returns a new scene that shares all
/// unchanged data.
RL_API Scene smooth(const Scene& scene, const AttributeOptions& options, Context& context);

/// Makes an engine by name: "soft", "gl" or "trace".
/// @throws Error usage: the name is unknown, or this build does not have the engine
RL_API std::unique_ptr<Engine> make_engine(const std::string& name);

/// Draws a scene with the soft engine. Missing normals and tangents are computed. A scene without lights gets the
/// default light rig.
/// @throws Error usage: impossible settings; bad_file: "nothing to draw"
RL_API Frame render(const Scene& scene, const Camera& camera, const RenderSettings& settings, Context& context);
/// The same through the first camera of the scene. If the scene has no camera, one is fitted to its bounding box.
RL_API Frame render(const Scene& scene, const RenderSettings& settings, Context& context);

/// Writes the color of a frame. PNG, JPEG and WebP files get tone-mapped sRGB with 8 bits. EXR and HDR files get linear
/// floats. The file appears complete or not at all.
/// @param behind linear color and alpha of a background, composited behind pixels that are not opaque. Exposure and
///        tone curve do not apply to this color. Use it for frames drawn with
///        RenderSettings::composites_background = false
/// @throws Error usage: unknown ending, exposure out of range; failed: the file cannot be written
RL_API void save(const Frame& frame, const std::string& path, const ToneSettings& tone = {}, vec4 behind = {});

/// Writes a scene: .glb and .gltf store all that glTF can express, .obj what stands in the world with its materials,
/// .ply only triangles. Y is up in glTF and OBJ: a scene whose `source` is an STL file is turned. The report lists losses.
/// @throws Error usage: another ending; bad_file: an invalid scene (see validate()), or nothing to write; failed: the
///         file cannot be written
RL_API void save(const Scene& scene, const std::string& path, Context& context);

/// The bytes of the file that save() writes.
/// @param ending  the ending of the file name: ".png", ".exr", ...
/// @throws Error usage: unknown ending, exposure out of range
RL_API std::vector<std::byte> encode(const Frame& frame, const std::string& ending, const ToneSettings& tone = {},
                                     vec4 behind = {});

/// The color of a frame as display values: [width * height of the frame's window] sRGB codes. R is in the low byte,
/// then G, B and alpha. Alpha is not premultiplied.
/// @throws Error usage: exposure out of range
RL_API std::vector<std::uint32_t> to_srgb8(const Frame& frame, const ToneSettings& tone = {}, vec4 behind = {});

}  // namespace rakelight
