// SPDX-License-Identifier: Apache-2.0
// What paths have brought to the pixels of a window, pass by pass: means, and how far they may be off.
#pragma once
#include <span>
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/engines/engine.h>

#include "math/linear.h"

namespace rakelight::raytrace {

/// What one path has brought.
struct PathSample {
    vec3 color;                 ///< times alpha
    vec3 direct;                ///< of it, likewise
    float alpha = 0;            ///< 1: a surface, or an opaque background
    vec3 albedo{1, 1, 1};       ///< of the first surface; 1 where it shines
    vec3 normal{}, position{};  ///< likewise; about the eye
};

class PathFilm {
public:
    /// @param window   of the picture
    /// @param guides   keeps albedo and normals, too
    /// @throws Error bad_file: over the memory budget
    PathFilm(const Window& window, bool guides, Context& context);

    const Window& window() const { return window_; }
    int samples() const { return samples_; }  ///< that every pixel has
    void end_pass(int samples) { samples_ += samples; }

    /// Of one pixel by one thread at a time.
    void add(int x, int y, const PathSample& sample);

    /// Of the picture, after at least one pass. @param background  of pixels that nothing covers
    vec4 color(std::size_t pixel, vec4 background) const;
    vec3 direct(std::size_t pixel) const { return mean(pixel, sums_[pixel].direct) * per_alpha(pixel); }
    vec3 indirect(std::size_t pixel) const;
    vec3 albedo(std::size_t pixel) const { return guides_[pixel].albedo; }
    /// The colors again, from what is times alpha, instead of the sums: those of denoise_into().
    void replace_colors(std::vector<vec3> colors) { replaced_ = std::move(colors); }
    /// What a denoiser asks for, all [pixels]; colors times alpha.
    struct Guided {
        std::vector<vec3> color, variance, albedo, normal, position;
    };
    Guided guided() const;
    float variance(std::size_t pixel) const;  ///< of the mean luminance: that of the samples over their number
    std::size_t pixel_at(int x, int y) const {
        return std::size_t(y - window_.y) * std::size_t(window_.width) + std::size_t(x - window_.x);
    }

    /// Standard error of the pixels' luminance over its mean, both means over the window; 0 where it is not known: for fewer than 2
    /// samples, or as long as no light has come.
    double noise() const;

private:
    struct Sums {
        dvec3 color{}, direct{}, squares{};
        double alpha = 0, luminance = 0, luminance_squares = 0;
        double count = 0;  ///< of samples: a cancelled pass is not everywhere
    };
    /// Means.
    struct Guides {
        vec3 albedo{}, normal{}, position{};
        float count = 0;  ///< of positions
    };
    vec3 mean(std::size_t pixel, const dvec3& sum) const;
    float per_alpha(std::size_t pixel) const;

    MemoryCharge charge_;
    Window window_;
    int samples_ = 0;
    std::vector<Sums> sums_;
    std::vector<Guides> guides_;
    std::vector<vec3> replaced_;  ///< [pixels] or empty
};

}  // namespace rakelight::raytrace
