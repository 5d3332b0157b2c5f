// SPDX-License-Identifier: Apache-2.0
// What shaders of the user's make of a pixel, by engine gl, for tools.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include <rakelight/engines/engine.h>

namespace rakelight {

struct ShadedPixel {
    std::string lighting, vertex;  ///< names of the texts; empty: there is none
    vec4 color;                    ///< linear, straight alpha
    vec3 ambient, diffuse, specular, emission;
    /// A term that the lighting declares, of a light.
    struct Term {
        std::size_t light;
        std::string name;
        std::vector<float> value;
    };
    std::vector<Term> terms;  ///< of up to eight lights
};

/// Engine gl with a scene.
class ShaderTerms {
public:
    /// @param settings  with a text of the user's
    /// @throws Error usage: engine gl is not built in; failed: no OpenGL; what the engine throws
    ShaderTerms(const Scene& scene, const Camera& camera, const RenderSettings& settings, Context& context);
    ShadedPixel at(int x, int y, Context& context);

private:
    std::unique_ptr<Engine> engine_;
    Camera camera_;
    RenderSettings settings_;
};

}  // namespace rakelight
