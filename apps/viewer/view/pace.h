// SPDX-License-Identifier: Apache-2.0
// How coarse pictures are while something moves, by measured times.
#pragma once

namespace rakelight::viewer {

class Pace {
public:
    /// Takes the measured times of a picture.
    /// @param front_ms  whatever its size  @param pixels_ms  for its pixels  @param pixels  how many it has
    void measured(double front_ms, double pixels_ms, double pixels);
    /// By how much a picture in motion is smaller along each side: 1/16..1. Where the vertices alone take the time, pixels
    /// get half as much on top of it.
    /// @param budget_ms  that a picture in motion may take
    double scale(double whole_pixels, double budget_ms) const;
    /// Whether a picture of all its pixels, with so many samples each, takes no longer.
    bool allows(double whole_pixels, int samples, double budget_ms) const;

private:
    double front_ms_ = 0, pixel_ms_ = 0;  ///< of a picture, of a pixel; 0: nothing measured yet
};

}  // namespace rakelight::viewer
