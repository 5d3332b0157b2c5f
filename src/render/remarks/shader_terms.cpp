// SPDX-License-Identifier: Apache-2.0
#include "render/remarks/shader_terms.h"

#include <array>

#include <rakelight/render/render.h>

#include "engines/shader_text.h"
#include "render/engines.h"
#ifdef RL_HAVE_OPENGL
#include "engines/opengl/opengl_engine.h"
#endif

namespace rakelight {
namespace {

std::vector<std::array<vec4, 4>> terms_of([[maybe_unused]] Engine& engine, [[maybe_unused]] int x,
                                          [[maybe_unused]] int y, [[maybe_unused]] Context& context) {
#ifdef RL_HAVE_OPENGL
    return opengl::user_terms(engine, x, y, context);
#else
    return {};
#endif
}

}  // namespace

ShaderTerms::ShaderTerms(const Scene& scene, const Camera& camera, const RenderSettings& settings, Context& context)
    : engine_(make_engine("gl")), camera_(camera), settings_(settings) {
    settings_.channels = channels_lighting;
    check_abilities("gl", engine_->capabilities(), settings_);
    engine_->prepare(scene, context);
}

ShadedPixel ShaderTerms::at(int x, int y, Context& context) {
    settings_.window = {x, y, 1, 1};
    Frame frame;
    engine_->render(camera_, settings_, frame, context);
    ShadedPixel pixel{.lighting = settings_.lighting_name,
                      .vertex = settings_.vertex_name,
                      .color = frame.color[0],
                      .ambient = frame.ambient[0],
                      .diffuse = frame.diffuse[0],
                      .specular = frame.specular[0],
                      .emission = frame.emission[0],
                      .terms = {}};
    const std::vector<ShaderVariable> declared = user_shaders_of(settings_).terms;
    if (declared.empty()) return pixel;
    const std::vector<std::array<vec4, 4>> values = terms_of(*engine_, x, y, context);
    for (std::size_t light = 0; light < values.size(); ++light)
        for (std::size_t i = 0; i < declared.size(); ++i) {
            const float* const first = &values[light][i].x;
            pixel.terms.push_back({light, declared[i].name, {first, first + declared[i].components()}});
        }
    return pixel;
}

}  // namespace rakelight
