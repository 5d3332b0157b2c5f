// SPDX-License-Identifier: Apache-2.0
// The state of one draw of a picture: the features of its program, the numbers of its material, its textures.
#pragma once
#include <vector>

#include <rakelight/engines/engine.h>

#include "engines/opengl/picture/light_table.h"
#include "engines/opengl/programs/features.h"
#include "engines/opengl/scene/environment.h"
#include "engines/opengl/scene/material_numbers.h"
#include "engines/opengl/scene/textures.h"
#include "shading/draw_choices.h"
#include "shading/draw_list.h"
#include "shading/lights/lit_side.h"
#include "shading/picture_camera.h"

namespace rakelight::opengl {

/// A map that a draw reads.
struct BoundMap {
    TextureRoleNumber role;
    GLuint texture, sampler;
};

struct DrawState {
    Features features;
    MaterialNumbers numbers;
    std::vector<BoundMap> maps;
    std::uint32_t dropped = 0;  ///< [bits by TextureRoleNumber] maps that there is no unit for
    shading::Culling culling;
    const std::int32_t* against = nullptr;  ///< LitSide::against()
};

/// Everything that draws of a picture have in common.
struct PictureState {
    const shading::DrawList& list;
    const shading::TextureCache& cache;
    TextureStore& textures;
    const RenderSettings& settings;
    const shading::PictureCamera& view;
    const std::vector<Shading>& shading;  ///< [draws] never automatic
    const LightTable& lights;
    bool has_environment = false, has_shadows = false;
    int units = 12;                                  ///< texture units for materials' maps
    const shading::BehindFactors* behind = nullptr;  ///< of what is behind transmissive surfaces; null: they are opaque
};

/// Maps that a program of `units` units has no room for, the least visible first; 0: none.
std::uint32_t dropped_maps(std::uint32_t maps, int units);

/// What a stream without indices fetches of a mesh.
void set_mesh_features(const Mesh& mesh, Features& features);

/// @param output  what is to be written
/// @param wants_triangles  the program asks for the number of the triangle, its barycentrics or its plane
DrawState draw_state(const PictureState& picture, std::uint32_t draw, Output output, bool wants_triangles);

}  // namespace rakelight::opengl
