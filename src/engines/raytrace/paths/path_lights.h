// SPDX-License-Identifier: Apache-2.0
// What shines on paths: triangles that emit and the environment, sampled as Shirley, Wang & Zimmerman 1996 do; and, where there
// are many lights without an area, which of them a point asks.
#pragma once
#include <array>
#include <memory>
#include <vector>

#include "cpu_shading/draw_list.h"
#include "engines/raytrace/paths/path_numbers.h"
#include "engines/raytrace/trace_picture.h"
#include "shading/lights/emitters.h"
#include "shading/lights/environment_table.h"
#include "shading/lights/light_choice.h"

namespace rakelight::raytrace {

/// What does not change from picture to picture.
struct ScenePathLights {
    shading::Emitters emitters;
    shading::EnvironmentTable sky;
    FrontFace front_face = FrontFace::counter_clockwise;
};

/// @param list, textures  of the engine; the list must outlive the result
std::unique_ptr<ScenePathLights> make_path_lights(const cpu_shading::DrawList& list,
                                                  const shading::TextureCache& textures, FrontFace front_face,
                                                  Context& context);

/// A place on an emitter, or a direction to the environment.
struct ChosenEmitter {
    vec3 place{};       ///< about the eye; unit towards the environment
    vec3 normal{};      ///< unit
    float size = 0;     ///< [m] largest coordinate of its triangle, about the eye
    float density = 0;  ///< [1/m^2], [1/sr] of the environment; 0: nothing shines
    bool is_far = false, shines_back = false;
    std::uint32_t draw = no_index, triangle = 0;
};

class PathLights {
public:
    /// @param scene, picture  must outlive this
    PathLights(const ScenePathLights& scene, const TracePicture& picture);

    ChosenEmitter choose(const std::array<std::uint32_t, 4>& numbers) const;
    /// [1/m^2] with which choose() comes to a place on a triangle; 0: never.
    float density_of(std::uint32_t draw, std::uint32_t triangle) const {
        if (!choice_.has_emitters) return 0;
        return float(choice_.probability_of_emitters()) * scene_.emitters.pdf_area(draw, triangle);
    }
    /// [1/sr] of a direction to the environment, unit.
    float density_of_sky(vec3 direction) const;
    /// The environment gives light.
    bool has_sky() const { return has_sky_; }
    bool is_there() const { return choice_.has_emitters || choice_.has_environment; }

    /// Whether each point asks some lights only.
    bool picks_lights() const { return !light_scale_.empty(); }
    std::uint32_t pick_light(std::uint32_t number) const { return picks_.sample(unit_double(number)).index; }
    const float* light_scale() const { return light_scale_.data(); }  ///< [lights] 1 / (picks * probability)

private:
    const ScenePathLights& scene_;
    const TracePicture& picture_;
    dvec3 eye_;
    bool has_sky_ = false;
    shading::LightChoice choice_;  ///< of what is asked
    shading::AliasTable picks_;
    std::vector<float> light_scale_;
};

}  // namespace rakelight::raytrace
