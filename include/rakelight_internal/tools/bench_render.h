// SPDX-License-Identifier: Apache-2.0
// Measures how fast engines draw a scene.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include <rakelight/base/export.h>
#include <rakelight/render/picture.h>

namespace rakelight {

/// Options of bench_render().
struct RenderBenchOptions {
    std::string scene{};  ///< model file or "builtin:teapot"; empty: a scene generated from the three numbers below
    LoadOptions load{};
    std::uint64_t triangles = 100'000;  ///< approximate number of triangles, 100 to 10^8
    std::uint32_t objects = 100;        ///< 1 to 100 000, at most one for each 20 triangles
    /// Number of point lights, 0 to 10 000. Up to 8 lights have an unlimited range; more lights have a range of 1 m.
    std::uint32_t lights = 2;
    /// Generated scene: further numbers of lights to measure. Pictures with different numbers of lights are
    /// interleaved.
    std::vector<std::uint32_t> other_lights{};
    std::vector<std::string> engines = {"soft"};  ///< see make_engine(); the same engine may appear several times
    std::uint32_t frames = 15;                    ///< pictures of each engine, 1 to 10 000, after one warm-up picture
    RenderSettings settings = full_hd();          ///< the generated scene culls back faces by default
    /// Materials, normals, view, lights, environment and tone of the pictures. Input, load options, settings and output
    /// of this request are ignored.
    PictureRequest picture{};
    std::string output{};       ///< picture file of the first engine; empty: it is not written
    std::string export_file{};  ///< .glb file for the scene; empty: it is not written

    static RenderSettings full_hd() {
        RenderSettings settings{};
        settings.width = 1920;
        settings.height = 1080;
        return settings;
    }
};

/// Measurement of one engine. Times are wall clock; pictures of all engines are interleaved.
struct RenderBenchRow {
    std::string engine{}, isa{};                           ///< name of the engine; instruction set, or empty
    int threads = 0;                                       ///< threads used
    std::uint32_t lights = 0;                              ///< of the scene
    double median_ms = 0, fastest_ms = 0, slowest_ms = 0;  ///< from vertices to 8-bit display values
    double cpu_ms = 0;      ///< median CPU time of all threads, less sensitive to other load
    double first_ms = 0;    ///< time of the warm-up picture, with untouched memory
    double prepare_ms = 0;  ///< time of Engine::prepare(), which is called once
    double mtri_per_s = 0;  ///< million triangles of the scene per second, from the median
    double mpix_per_s = 0;  ///< million shaded pixels per second, from the median
    StageTimes stages{};    ///< [s] median of each stage
    RenderStats stats{};    ///< of the last picture
};

/// Result of bench_render().
struct RenderBenchReport {
    std::string scene{};                        ///< description of the scene
    std::uint64_t triangles = 0, vertices = 0;  ///< of the scene
    std::uint32_t objects = 0, lights = 0;      ///< of the scene
    int width = 0, height = 0;                  ///< [px]
    std::uint32_t frames = 0;                   ///< pictures of each engine
    std::vector<RenderBenchRow> rows{};
};

/// Draws the scene repeatedly to 8-bit display values. If `picture` sets no camera, the first camera of the scene is
/// used, or a fitted camera if the scene has none. Model files are prepared as in render_picture(). A scene without
/// lights gets the default light rig.
/// @throws Error usage: options out of range, an unknown engine; as load() and make_engine()
RL_API RenderBenchReport bench_render(const RenderBenchOptions& options, Context& context);

/// Schema rakelight.bench/1: {"schema", "rows": [{"engine", "median_ms", ...}], and the scene}.
RL_API std::string to_json(const RenderBenchReport& report);
/// A table for people.
RL_API std::string to_text(const RenderBenchReport& report);

}  // namespace rakelight
