// SPDX-License-Identifier: Apache-2.0
// The soft engine beside OpenGL without a GPU: the same scene, equations and texels, pictures in sRGB on both sides,
// frame by frame in turns. Says medians, their ratio, and how much the pictures differ.
//   gl_peer --triangles 100k --lights 2 --cases normal,phong,gouraud,unlit --pictures /tmp/peer- --json
// The case plain has one color an object: edges alone differ.
// --least-psnr DB fails where the pictures of both sides agree less.
// One call is one OpenGL version: what a package brings is chosen by the loader (LD_LIBRARY_PATH, LIBGL_DRIVERS_PATH).
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include <rakelight/render/picture.h>

#include "engines/opengl/picture/target.h"
#include "engines/opengl/renderer.h"
#include "image/compare/compare.h"
#include "io/pictures/image_io.h"
#include "raster/gl_scene.h"
#include "raster/gl_target.h"
#include "render/output/picture_sink.h"
#include "render/stopwatch.h"
#include "scene/placement.h"
#include "tools/bench/bench_scene.h"

namespace rakelight::bench {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
    std::uint64_t triangles = 100'000;
    std::uint32_t lights = 2;
    int width = 1920, height = 1080, frames = 9, samples = 1, threads = 0;
    std::vector<std::string> cases = {"normal"};
    std::string pictures;
    double least_psnr_db = 0;
    bool json = false, gl_only = false;
};

[[noreturn]] void wrong(const std::string& what) { throw Error(ErrorCode::usage, what); }

long number(const char* word, long low, long high) {
    char* end = nullptr;
    long n = std::strtol(word, &end, 10);
    if (*end == 'k') n *= 1000, ++end;
    if (*end == 'M') n *= 1'000'000, ++end;
    if (end == word || *end || n < low || n > high)
        wrong(std::string("'") + word + "' is no number that is possible here");
    return n;
}

std::vector<std::string> split(std::string words) {
    std::vector<std::string> all;
    for (std::size_t at; (at = words.find(',')) != std::string::npos; words.erase(0, at + 1))
        all.push_back(words.substr(0, at));
    all.push_back(words);
    return all;
}

Options parse(int argc, char** argv) {
    Options o;
    for (int i = 1; i < argc; ++i) {
        const std::string option = argv[i];
        if (option == "--json" || option == "--gl-only") {
            (option == "--json" ? o.json : o.gl_only) = true;
            continue;
        }
        if (++i == argc) wrong(option + " is unknown or lacks its value");
        const char* const value = argv[i];
        if (option == "--triangles")
            o.triangles = std::uint64_t(number(value, 2000, 100'000'000));
        else if (option == "--lights")
            o.lights = std::uint32_t(number(value, 0, bench_lights_max));
        else if (option == "--frames")
            o.frames = int(number(value, 1, 10'000));
        else if (option == "--samples")
            o.samples = int(number(value, 1, 8));
        else if (option == "--threads")
            o.threads = int(number(value, 1, 1024));
        else if (option == "--cases")
            o.cases = split(value);
        else if (option == "--least-psnr")
            o.least_psnr_db = double(number(value, 1, 100));
        else if (option == "--pictures")
            o.pictures = value;
        else if (option == "--resolution") {
            const auto sides = split(value);
            if (sides.size() != 2) wrong("--resolution takes W,H");
            o.width = int(number(sides[0].c_str(), 1, 16384)), o.height = int(number(sides[1].c_str(), 1, 16384));
        } else
            wrong("'" + option + "' is unknown");
    }
    return o;
}

struct Timings {
    std::vector<double> ms, cpu_ms;
    template <class Draw>
    void measure(const Draw& draw) {
        const std::clock_t cpu = std::clock();
        const Stopwatch watch;
        draw();
        ms.push_back(watch.ms());
        cpu_ms.push_back(1e3 * double(std::clock() - cpu) / CLOCKS_PER_SEC);
    }
    static double median(std::vector<double> v) {
        std::sort(v.begin(), v.end());
        return 0.5 * (v[(v.size() - 1) / 2] + v[v.size() / 2]);
    }
    Json json(const std::string& engine, const std::string& what) const {
        return {{"engine", engine},
                {"case", what},
                {"median_ms", median(ms)},
                {"fastest_ms", *std::min_element(ms.begin(), ms.end())},
                {"slowest_ms", *std::max_element(ms.begin(), ms.end())},
                {"cpu_ms", median(cpu_ms)}};
    }
};

RenderSettings settings_for(const std::string& name, const Options& o) {
    RenderSettings s;
    s.width = o.width, s.height = o.height;
    s.samples = o.samples;
    s.cull = Cull::back;
    s.bump = name == "normal" ? Bump::normal : Bump::none;
    if (name == "unlit" || name == "plain")
        s.shading = Shading::unlit;
    else if (name == "gouraud")
        s.shading = Shading::gouraud;
    else if (name != "normal" && name != "phong")
        wrong("cases are normal, phong (no normal map), gouraud, unlit, plain (unlit, no texture); not '" + name + "'");
    return s;
}

/// The soft engine's side of a case.
class SoftSide {
public:
    SoftSide(const Scene& scene, const RenderSettings& settings, Context& context)
        : settings_(settings), context_(context), camera_(scene.cameras[0]), engine_(make_engine("soft")) {
        engine_->prepare(prepare_scene(scene, {}, context), context);
    }
    void draw() { stats_ = engine_->render(camera_, settings_, sink_, context_); }
    std::uint64_t shaded() const { return stats_.pixels_shaded; }
    Pixels picture() const {
        Pixels p;
        p.width = settings_.width, p.height = settings_.height, p.channels = 3;
        p.bytes.resize(p.row_bytes() * std::size_t(p.height));
        for (int y = 0; y < p.height; ++y) {
            const std::byte* const row = sink_.color_row(y);
            for (int x = 0; x < p.width; ++x) std::memcpy(p.row(y) + 3 * x, row + 4 * x, 3);
        }
        return p;
    }

private:
    RenderSettings settings_;
    Context& context_;
    Camera camera_;
    std::unique_ptr<Engine> engine_;
    PictureSink sink_{PixelFormat{.channels = 4}};  ///< as the other side's target: sRGB codes, four bytes per pixel
    RenderStats stats_;
};

/// Our own OpenGL engine's side: its passes, in a context of its own, without reading the picture back, as the peer's.
class EngineSide {
public:
    EngineSide(const Scene& scene, const RenderSettings& settings, Context& context)
        : settings_(settings),
          context_(context),
          camera_(scene.cameras[0]),
          pixels_{0, 0, settings.width, settings.height} {
        renderer_.emplace();
        renderer_->prepare(prepare_scene(scene, {}, context), context);
        target_.reserve(settings.width, settings.height, settings.samples);
    }
    ~EngineSide() { gl_.make_current(); }
    EngineSide(const EngineSide&) = delete;
    EngineSide& operator=(const EngineSide&) = delete;

    void make_current() const { gl_.make_current(); }
    void draw() {
        RenderStats stats;
        renderer_->begin_picture(camera_, settings_, stats, context_);
        renderer_->draw_part(pixels_, target_, context_);
        GlContext::finish();
    }

private:
    GlContext gl_;
    RenderSettings settings_;
    Context& context_;
    Camera camera_;
    Window pixels_;
    std::optional<opengl::Renderer> renderer_;
    opengl::Target target_;
};

/// One color an object: what differs then are edges alone.
Scene without_textures(Scene scene) {
    scene.textures.clear();
    for (Material& m : scene.materials) m.base_color_texture = m.normal_texture = {};
    return scene;
}

/// Mean over components, in steps of 8 bits.
double mean_difference(const Pixels& a, const Pixels& b) {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < a.bytes.size(); ++i) sum += std::uint64_t(std::abs(int(a.bytes[i]) - int(b.bytes[i])));
    return double(sum) / double(a.bytes.size());
}

/// The soft engine where it has what the case needs; else nothing, and why.
std::unique_ptr<SoftSide> soft_side(const Scene& scene, const RenderSettings& settings, const Options& o,
                                    Context& context) {
    if (o.gl_only) return {};
    try {
        auto side = std::make_unique<SoftSide>(scene, settings, context);
        side->draw();
        return side;
    } catch (const Error& error) {
        std::fprintf(stderr, "gl_peer: soft: %s: not measured\n", error.reason().c_str());
        return {};
    }
}

void compare(const Pixels& soft, const Pixels& gl, Json& row) {
    const PictureDifference d = compare_pictures(soft, gl, 8.0 / 255);
    row["psnr_db"] = d.psnr_db;
    row["mean_difference_of_255"] = mean_difference(soft, gl);
    row["share_over_8_of_255"] = d.differing_share;
}

void run_case(const std::string& name, const Scene& scene, const GlContext& peer, const std::string& gl_name,
              const Options& o, Context& context, Json& rows) {
    const RenderSettings settings = settings_for(name, o);
    const GlTarget target(o.width, o.height, o.samples);
    const GlScene gl(scene, settings.shading, settings.bump, double(o.width) / o.height, context);
    const auto draw_gl = [&] {
        target.begin();
        gl.draw();
        target.resolve();
        GlContext::finish();
    };
    draw_gl();
    draw_gl();  // a second one: llvmpipe compiles late
    std::unique_ptr<SoftSide> soft = soft_side(scene, settings, o, context);
    EngineSide engine(scene, settings, context);
    for (int i = 0; i < 2; ++i) engine.draw();
    Timings soft_times, gl_times, engine_times;
    for (int frame = 0; frame < o.frames; ++frame) {
        if (soft) soft_times.measure([&] { soft->draw(); });
        peer.make_current();
        gl_times.measure(draw_gl);
        engine.make_current();
        engine_times.measure([&] { engine.draw(); });
    }
    peer.make_current();
    const std::string what = name + (o.samples > 1 ? ", " + std::to_string(o.samples) + " samples" : "");
    const Pixels gl_picture = target.read();
    if (!o.pictures.empty()) io::write_image(o.pictures + name + "-gl.png", gl_picture);
    if (soft) {
        Json row = soft_times.json("soft", what);
        row["pixels_shaded"] = soft->shaded();
        row["ratio_to_gl"] = Timings::median(soft_times.ms) / Timings::median(gl_times.ms);
        row["cpu_ratio_to_gl"] = Timings::median(soft_times.cpu_ms) / Timings::median(gl_times.cpu_ms);
        compare(soft->picture(), gl_picture, row);
        if (!o.pictures.empty()) io::write_image(o.pictures + name + "-soft.png", soft->picture());
        rows.push_back(std::move(row));
    }
    rows.push_back(gl_times.json(gl_name, what));
    Json row = engine_times.json("engine gl", what);
    row["ratio_to_gl"] = Timings::median(engine_times.ms) / Timings::median(gl_times.ms);
    row["cpu_ratio_to_gl"] = Timings::median(engine_times.cpu_ms) / Timings::median(gl_times.cpu_ms);
    rows.push_back(std::move(row));
}

void print(const Json& json) {
    std::printf("%s; %s\n", json["gl_renderer"].get<std::string>().c_str(),
                json["gl_version"].get<std::string>().c_str());
    std::printf("%d triangles, %d lights, %d x %d, %d frames\n", json["triangles"].get<int>(),
                json["lights"].get<int>(), json["width"].get<int>(), json["height"].get<int>(),
                json["frames"].get<int>());
    std::printf(
        "case               engine     median ms (fastest  slowest)      CPU   to GL  CPU to GL   PSNR dB  mean/255   "
        "over 8\n");
    for (const Json& r : json["rows"]) {
        std::printf("%-18s %-9s %10.2f %8.2f %9.2f %9.2f", r["case"].get<std::string>().c_str(),
                    r["engine"].get<std::string>().c_str(), r["median_ms"].get<double>(), r["fastest_ms"].get<double>(),
                    r["slowest_ms"].get<double>(), r["cpu_ms"].get<double>());
        if (r.contains("ratio_to_gl"))
            std::printf(" %7.3f %9.3f", r["ratio_to_gl"].get<double>(), r["cpu_ratio_to_gl"].get<double>());
        if (r.contains("psnr_db"))
            std::printf(" %10.2f %9.3f %7.3f %%", r["psnr_db"].get<double>(), r["mean_difference_of_255"].get<double>(),
                        100 * r["share_over_8_of_255"].get<double>());
        std::printf("\n");
    }
}

void run(const Options& o) {
    Context context({.threads = o.threads, .max_memory = o.triangles * 1200 + (4ull << 30)});
    const Scene scene = make_bench_scene(o.triangles, 100, o.lights, context);
    const GlContext gl;
    const std::string name = gl.renderer().starts_with("llvmpipe") ? "llvmpipe" : "gl";
    Json rows = Json::array();
    for (const std::string& c : o.cases) {
        run_case(c, c == "plain" ? without_textures(scene) : scene, gl, name, o, context, rows);
        gl.make_current();  // the engine's has ended
    }
    const Json json = {{"schema", "rakelight.bench/1"},
                       {"rows", rows},
                       {"triangles", triangle_count(scene)},
                       {"lights", o.lights},
                       {"width", o.width},
                       {"height", o.height},
                       {"frames", o.frames},
                       {"gl_renderer", gl.renderer()},
                       {"gl_version", gl.version()}};
    if (o.json)
        std::printf("%s\n", json.dump(2).c_str());
    else
        print(json);
    for (const Json& row : rows)
        if (row.contains("psnr_db") && row["psnr_db"].get<double>() < o.least_psnr_db)
            throw Error(ErrorCode::check_failed,
                        row["case"].get<std::string>() + ": the pictures differ by more than --least-psnr");
}

}  // namespace
}  // namespace rakelight::bench

int main(int argc, char** argv) {
    try {
        rakelight::bench::run(rakelight::bench::parse(argc, argv));
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "gl_peer: error: %s\n", error.what());
        return 1;
    }
}
