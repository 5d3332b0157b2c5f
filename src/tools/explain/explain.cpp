// SPDX-License-Identifier: Apache-2.0
#include "tools/explain/explain.h"

#include <new>

#include <rakelight/scene/validate.h>

#include "base/format_text.h"
#include "engines/empty_pixel.h"
#include "engines/raster/inspect/nearest_visible.h"
#include "engines/raster/visibility/depth_formats.h"
#include "render/rows.h"
#include "tools/explain/explain_look.h"
#include "tools/open_engine.h"

namespace rakelight {
namespace {

std::vector<std::uint8_t> codes(vec4 color, bool with_alpha, const ToneCurve& tone) {
    const PixelFormat format{.component = Component::u8, .channels = with_alpha ? 4 : 3};
    std::vector<std::uint8_t> out(format.bytes());
    convert_row(&color, 1, format, tone, reinterpret_cast<std::byte*>(out.data()));
    return out;
}

using Explained = std::vector<std::shared_ptr<const ExplainedPixel>>;

void check_place(const RenderSettings& s, PixelPlace pixel) {
    if (pixel.x < 0 || pixel.y < 0 || pixel.x >= s.width || pixel.y >= s.height)
        throw Error(ErrorCode::usage, format_text("pixel {},{} is not in the picture of {} x {} pixels", pixel.x,
                                                  pixel.y, s.width, s.height));
}

/// One pixel; `out` has the engine. @param shaders  null: there are none
void explain_pixel(ExplainedPixel& out, PixelPlace pixel, const PictureRequest& request, ShaderTerms* shaders,
                   Context& context) {
    out.pixel = out.engine->explain(pixel.x, pixel.y, context);
    if (shaders) {
        out.shaded = shaders->at(pixel.x, pixel.y, context);
        out.pixel.color = out.shaded->color;
    }
    if (out.pixel.layers.empty()) out.nearest = raster::nearest_visible(*out.engine, pixel.x, pixel.y, context);
    if (out.pixel.has_marks)
        context.report().add(Remark::warning, request.input, {},
                             "lines or points of the model are near this pixel: only its surfaces are explained");
    out.tone = request.tone;
    const ToneCurve curve(request.tone, laid_behind(request.settings));
    out.displayed = curve.displayed(out.pixel.color);
    out.codes = codes(out.pixel.color, request.settings.background.w < 1, curve);
}

/// @param open  gives the engine with the scene in it
template <class Open>
Explained explained(PictureRequest request, std::span<const PixelPlace> pixels, Context& context, const Open& open) {
    try {
        for (const PixelPlace pixel : pixels) check_place(request.settings, pixel);  // before anything is loaded
        const PictureRequest asked = request;
        std::unique_ptr<ShaderTerms> shaders;
        const std::shared_ptr<const raster::Inspection> engine = open(request, &shaders);
        const RenderSettings& s = request.settings;
        const bool follows_rays = s.method != RayMethod::cast && s.max_depth > 0;
        if (request.engine == "trace" && (follows_rays || s.shadows))
            context.report().add(Remark::warning, request.input, {},
                                 "the pixel is explained as engine soft draws it: without reflected or refracted rays, "
                                 "and with shadow maps");
        Explained all;
        for (const PixelPlace pixel : pixels) {
            context.progress("explain", double(all.size()) / double(pixels.size()));
            auto out = std::make_shared<ExplainedPixel>();
            out->file = request.input;
            out->engine = engine;
            out->look = look_choices(asked, request, *engine);
            explain_pixel(*out, pixel, request, shaders.get(), context);
            all.push_back(std::move(out));
        }
        return all;
    } catch (const std::bad_alloc&) {
        throw Error(ErrorCode::failed, "out of memory").with_file(request.input);
    } catch (const Error& error) {
        throw error.with_file(request.input);
    }
}

}  // namespace

std::vector<std::shared_ptr<const ExplainedPixel>> explain(const PictureRequest& request,
                                                           std::span<const PixelPlace> pixels, Context& context) {
    return explained(request, pixels, context, [&](PictureRequest& looked, std::unique_ptr<ShaderTerms>* shaders) {
        return open_engine(load_for_engine(looked, context), looked, context, shaders);
    });
}

std::shared_ptr<const ExplainedPixel> explain(const PictureRequest& request, int x, int y, Context& context) {
    const PixelPlace pixel{x, y};
    return explain(request, {&pixel, 1}, context)[0];
}

std::shared_ptr<const ExplainedPixel> explain(const Scene& scene, const PictureRequest& request, int x, int y,
                                              Context& context) {
    const PixelPlace pixel{x, y};
    return explained(request, {&pixel, 1}, context, [&](PictureRequest& looked, std::unique_ptr<ShaderTerms>* shaders) {
        validate(scene);
        return open_engine(scene, looked, context, shaders);
    })[0];
}

std::vector<std::uint8_t> codes_of(const ExplainedPixel& pixel) { return pixel.codes; }
vec4 color_of(const ExplainedPixel& pixel) { return pixel.pixel.color; }

double standard_depth_per_key(const ExplainedPixel& e) {
    const shading::PictureCamera& view = e.engine->view();
    const raster::DepthRange range{view.z_near, view.z_far, view.orthographic};
    return raster::standard_of_reversed(1, range) - raster::standard_of_reversed(0, range);
}

dvec3 world_position(const ExplainedPixel& e, const float (&relative)[3]) {
    const dvec3 eye = e.engine->view().camera_to_world[3].xyz();
    return {eye.x + double(relative[0]), eye.y + double(relative[1]), eye.z + double(relative[2])};
}

}  // namespace rakelight
