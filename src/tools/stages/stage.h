// SPDX-License-Identifier: Apache-2.0
// A stage as it is written: a title, words, pictures and a table.
#pragma once
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "engines/empty_pixel.h"
#include "engines/raster/inspect/inspect_pixels.h"
#include "image/tone_curves.h"
#include "tools/stages/canvas.h"

namespace rakelight::stages {

using Json = nlohmann::ordered_json;

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
    Json numbers = Json::object();     ///< name -> number, text or list of numbers
    std::vector<std::string> columns;  ///< of the rows
    Json rows = Json::array();         ///< arrays of cells
    std::string rows_note;             ///< which rows these are
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
/// Clip space, what clipping cuts off, and what would happen without.
std::vector<Stage> clip_stages(const Sources& of);
/// Vertices after it: normalized device coordinates, screen.
std::vector<Stage> screen_stages(const Sources& of);
/// What the depth test's number keeps of a distance.
Stage depth_precision_stage(const Sources& of);
/// What the samples of a picture with several a pixel show.
Stage samples_stage(const Sources& of);
/// How far height maps move what textures are read at; where a material has one.
Stage relief_stage(const Sources& of);
/// Where which light is in shadow, and the shadow maps; where something throws shadows.
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
