// SPDX-License-Identifier: Apache-2.0
// A stage of the output: a title, a text, pictures and a table.
#pragma once
#include <string>
#include <vector>

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
    const raster::Inspection& engine;
    const raster::Inspection::Geometry& open;  ///< with what culling drops
    const raster::Inspection::Geometry& drawn;
    const raster::PixelStageData& pixels;
    ToneSettings tone;
    ToneCurve curve{tone, laid_behind(engine.settings())}, exposure{{ToneMapping::none, tone.exposure_ev}};
};

/// Vertices before the projection: model, world, camera.
std::vector<Stage> space_stages(const Sources& of);
/// The projection in three steps.
std::vector<Stage> projection_stages(const Sources& of);
/// Clip space, the parts that clipping cuts off, and what would happen without it.
std::vector<Stage> clip_stages(const Sources& of);
/// Vertices after it: normalized device coordinates, screen.
std::vector<Stage> screen_stages(const Sources& of);
/// The precision of the depth that the depth test compares.
Stage depth_precision_stage(const Sources& of);
/// The samples of a picture with several per pixel.
Stage samples_stage(const Sources& of);
/// How far height maps move texture coordinates; if a material has one.
Stage relief_stage(const Sources& of);
/// Where each light is in shadow, and the shadow maps; if something casts shadows.
Stage shadow_stage(const Sources& of);
/// Each light's terms.
Stage lighting_stage(const Sources& of);
/// Exposure, tone curve, codes.
Stage tone_stage(const Sources& of);
/// What `rakelight render` draws.
Stage picture_stage(const Sources& of);
/// The picture with each shading frequency.
Stage frequency_stage(const Sources& of, Context& context);
/// Pixels: culled faces, coverage, depth, visibility, normals, terms of the lights, the picture.
std::vector<Stage> pixel_stages(const Sources& of);

/// For people: at most 7 digits.
std::string digits(double value);
/// One stage's table: {"schema": "rakelight.stages/1", "stage": ..., ...}
std::string table_json(const Stage& stage);
/// A page. @param is_whole  its pictures and tables are in it, else beside it
std::string page(const std::string& model, const std::vector<Stage>& stages, bool is_whole, Context& context);

}  // namespace rakelight::stages
