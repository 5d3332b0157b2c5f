// SPDX-License-Identifier: Apache-2.0
// How much two pictures differ, where, and whether that is too much: numbers, a difference picture, a page.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <rakelight/context.h>
#include <rakelight/export.h>
#include <rakelight/image.h>
#include <rakelight/inspect.h>

namespace rakelight {

/// How pictures are compared.
struct CompareOptions {
    double tolerance = 0;  ///< >= 0; pixels any component of which differs by more count as different
    double pixels_per_degree =
        67;  ///< 1..1000; FLIP: of the viewer's angle (0.7 m wide display of 3840 pixels seen from 0.7 m)
};

/// Error, RMSE, PSNR and the share of pixels are of the components as they are: integers as 0..1 of their largest code, floats as the
/// linear light that they hold, alpha among them. SSIM and FLIP look at 8-bit sRGB colors as a display shows them: linear light is
/// clamped to 0..1 and encoded; where alpha is below 1 the color lies over middle gray (code 128).
struct PictureComparison {
    int width = 0, height = 0;  ///< [px] of both
    double max_error = 0;       ///< infinity where a NaN or an infinity meets anything but itself
    double rmse = 0;            ///< root of the mean squared difference of all components
    double psnr_db = 0;         ///< -20 log10(rmse), peak 1; +infinity where rmse is 0
    /// Of luma, -1..1; 1 for equal pictures. Absent: a side is under 11 pixels. Wang et al. 2004, "Image Quality Assessment: From
    /// Error Visibility to Structural Similarity", windows that lie whole in the picture, no downsampling.
    std::optional<double> ssim{};
    /// Mean over all pixels, 0..1; 0 for equal pictures. Andersson et al. 2020, "FLIP: A Difference Evaluator for Alternating Images".
    double flip = 0;
    std::uint64_t differing_pixels = 0;  ///< pixels off by more than the tolerance
    double differing_share = 0;          ///< 0..1 of all pixels
    /// Whether no component differs.
    bool is_equal() const { return max_error == 0; }
};

/// What is shown of a difference.
enum class DifferenceKind : std::uint8_t {
    flip,  ///< FLIP of each pixel: dark blue 0 over green and yellow to white 1; in EXR and HDR files the number itself
    absolute,  ///< |a - b| of red, green and blue as displayed, times a gain; in EXR and HDR files of the components as they are
};

/// Two pictures that were compared.
class RL_API ComparedPictures {
public:
    /// Where one has more channels than the other, gray is copied to RGB, and missing alpha is 1. Where one holds linear light, the
    /// other's sRGB colors are decoded.
    /// @throws Error check_failed: they differ in size; usage: impossible options; bad_file: beyond the memory budget
    ComparedPictures(Pixels a, Pixels b, const CompareOptions& options, Context& context);
    ~ComparedPictures();
    ComparedPictures(ComparedPictures&&) noexcept;
    ComparedPictures& operator=(ComparedPictures&&) noexcept;

    /// The numbers.
    const PictureComparison& comparison() const;
    /// RGB. @param gain  of DifferenceKind::absolute, > 0. @param component  u8, or f32 for numbers as they are
    Pixels difference(DifferenceKind kind, double gain, Component component = Component::u8) const;

    struct State;  ///< of the library itself
    const State& state() const { return *state_; }

private:
    std::unique_ptr<const State> state_;
};

/// A picture file, decoded. @throws Error not_found, bad_file
RL_API Pixels read_picture(const std::string& path, Context& context);

/// Whether a name's ending is that of a picture format which read_picture() reads.
RL_API bool has_picture_ending(const std::string& path);

/// Whether a name means something that is drawn: a world file, "builtin:...", an ending of a model format that this build reads.
RL_API bool is_scene(const std::string& name);

/// Writes a difference picture; its name's ending says the format. @throws Error usage: unknown ending; failed
RL_API void save_difference(const ComparedPictures& pictures, DifferenceKind kind, double gain,
                            const std::string& path);

/// Limits of a comparison; those absent hold for any.
struct CompareLimits {
    /// Of the fields of PictureComparison.
    std::optional<double> max_error{}, max_rmse{}, min_psnr_db{}, min_ssim{}, max_flip{}, max_differing_share{};
    bool empty() const {
        return !max_error && !max_rmse && !min_psnr_db && !min_ssim && !max_flip && !max_differing_share;
    }
};

/// One entry for each limit that is passed, in the order of CompareLimits; a picture that has no SSIM passes its limit.
RL_API std::vector<CheckFailure> check_limits(const PictureComparison& comparison, const CompareLimits& limits);

/// Whether a name means a page (.html, .htm); others mean a difference picture.
RL_API bool is_page(const std::string& path);
/// What is wrong with the name of a difference picture or a page before anything is compared. @throws Error usage, failed
RL_API void check_comparison_output(const std::string& path);

/// What is written above two pictures of a page.
struct PageTitles {
    std::string title{}, a{}, b{};  ///< the heading; what A and B are called
};

/// A page with the pictures of comparisons, one after the other: a wipe slider between the two, their differences, the numbers. One
/// file of HTML that refers to nothing outside of it.
class RL_API ComparisonPage {
public:
    /// Adds a comparison below those that are there. @param gain  of DifferenceKind::absolute, > 0
    void add(const PageTitles& titles, const ComparedPictures& pictures, const CompareOptions& options, double gain);
    /// The whole page. @throws Error failed
    void save(const std::string& path) const;

private:
    std::vector<std::string> titles_;
    std::string legend_, sections_;
};

}  // namespace rakelight
