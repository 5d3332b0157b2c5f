// SPDX-License-Identifier: Apache-2.0
// A stage of the output: a title, a text, pictures and a table.
#pragma once
#include <string>
#include <vector>

#include <rakelight/render/picture.h>

#include "engines/empty_pixel.h"
#include "engines/raster/inspect/inspect_pixels.h"
#include "image/tone_curves.h"
#include "tools/stages/canvas.h"
#include "tools/stages/cell.h"

namespace rakelight::stages {

struct Picture {
    std::string name;  ///< of the file, without ending
    std::string caption;
    Canvas canvas;
};

struct Stage {
    std::string id;  ///< "clip-space": names the files
    std::string title;
    std::string text;  ///< what happens, for people; plain text
    std::vector<Picture> pictures;
    Numbers numbers;
    std::vector<std::string> columns;  ///< of the rows
    std::vector<Cell::List> rows;
    std::string rows_note;  ///< which rows these are
};

/// What the stages are made of.
struct Sources {
    const Scene& loaded;            ///< before it was prepared
    const PictureRequest& request;  ///< after decide()
    Context& context;
    const raster::Inspection& engine;
    const raster::Inspection::Geometry& open;  ///< with what culling drops
    const raster::Inspection::Geometry& drawn;
    const raster::PixelStageData& pixels;
    ToneSettings tone = request.tone;
    ToneCurve curve{tone, laid_behind(engine.settings())}, exposure{{ToneMapping::none, tone.exposure_ev}};
};

/// How a stage is made: a constant of its source. stages.cpp has all of them in the order of the page.
struct StageKind {
    Stage (*make)(const Sources& of);
    bool (*is_there)(const Sources& of) = nullptr;  ///< null: for every picture
};

/// The base meshes beside the displaced ones.
extern const StageKind displacement_stage;
/// Vertices before the projection.
extern const StageKind model_stage, world_stage, camera_stage;
/// The projection in three steps.
extern const StageKind frustum_stage, central_stage, depth_mapping_stage;
/// Clip space, and the parts that clipping cuts off.
extern const StageKind clip_space_stage, clipped_stage;
/// Clipping by all six planes, one after the other.
extern const StageKind clip_planes_stage;
/// Why clipping comes before the division.
extern const StageKind wrap_stage;
/// Vertices after the projection.
extern const StageKind device_stage, screen_stage;
/// Pixels: what the engine drops, finds and blends.
extern const StageKind culling_stage, coverage_stage, depth_stage, visibility_stage, normal_stage, blending_stage;
/// The precision of the depth that the depth test compares.
extern const StageKind depth_precision_stage;
/// How far height maps move texture coordinates.
extern const StageKind relief_stage;
/// Where each light is in shadow, and the shadow maps.
extern const StageKind shadow_stage;
/// The picture with each shading frequency.
extern const StageKind frequency_stage;
/// Each light's terms.
extern const StageKind lighting_stage;
/// The samples of a picture with several per pixel.
extern const StageKind samples_stage;
/// Exposure, tone curve, codes; and what `rakelight render` draws.
extern const StageKind tone_stage, picture_stage;

}  // namespace rakelight::stages
