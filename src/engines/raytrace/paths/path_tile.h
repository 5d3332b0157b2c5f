// SPDX-License-Identifier: Apache-2.0
// Paths of light through the pixels of a tile, followed together from surface to surface.
#pragma once
#include <vector>

#include "engines/raytrace/paths/path_film.h"
#include "engines/raytrace/paths/path_lights.h"
#include "engines/raytrace/paths/path_numbers.h"
#include "engines/raytrace/trace_tile.h"

namespace rakelight::raytrace {

/// The state of a path besides its ray.
struct PathState {
    float pdf = 0;            ///< [1/sr] of the ray's direction; 0: emitters that it meets count whole
    std::uint32_t met = 0;    ///< surfaces so far, those too that alpha let it through
    bool is_straight = true;  ///< only mirrors and glass so far
    vec3 through{1, 1, 1};    ///< what is left behind surfaces that the ray went straight through
    std::int8_t color = -1;   ///< 0 to 2: only this color is left, since a body has parted them
};

/// A ray to a chosen emitter.
struct EmitterRay {
    vec3 origin, direction;  ///< the emitter is at 1, the environment at infinity
    vec3 weight;             ///< of its radiance in the pixel
    std::uint32_t pixel, draw, triangle;
    bool is_far;
    Media media;
};

struct PathScratch : TileScratch {
    std::vector<PathNumbers> numbers;            ///< [pixels]
    std::vector<PathState> states, next_states;  ///< [rays]
    std::vector<PathSample> brought;             ///< [pixels]
    std::vector<ChosenEmitter> chosen;           ///< [hits]
    std::vector<float> path_in, path_out;
    std::vector<EmitterRay> emitter_rays;
    std::vector<std::uint16_t> sample_counts;  ///< [pixels] of a tile that is handed out
};

/// What all paths of a picture share.
struct PathPicture {
    const TracePicture& trace;
    const PathLights& lights;
    std::vector<std::uint8_t> shines_behind;  ///< [draws]
    bool wants_guides = false, has_dispersion = false;
    bool shines = false;  ///< something has an area and gives light
};

/// Follows the paths of samples `first` to `last` - 1 of every pixel, into the film.
/// @param area  of at most tile_size x tile_size pixels, inside of the film's window
void follow_paths(const PathPicture& picture, const Window& area, int first, int last, const Context& context,
                  PathScratch& scratch, PathFilm& film);

}  // namespace rakelight::raytrace
