// SPDX-License-Identifier: Apache-2.0
// Comparison of pictures: metrics, limits, a difference picture, an HTML page.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/base/export.h>
#include <rakelight/image/image.h>
#include <rakelight/tools/inspect.h>
#include <rakelight/tools/report_row.h>

namespace rakelight {

/// Options of a comparison.
struct CompareOptions {
    double tolerance = 0;  ///< >= 0; a pixel counts as different if any component differs by more than this
    /// 1..1000; FLIP: pixels per degree of visual angle. The default is that of a display 0.7 m wide with 3840 pixels,
    /// seen from 0.7 m.
    double pixels_per_degree = 67;
};

/// The metrics of a comparison. Error, RMSE, PSNR and the differing pixels use the stored components including alpha.
/// Integers are scaled to 0..1, floats are linear light. SSIM and FLIP use 8-bit sRGB display colors. For these, linear
/// light is clamped to 0..1 and encoded, and transparent pixels are composited over middle gray (code 128).
struct PictureComparison {
    int width = 0, height = 0;  ///< [px] of both pictures
    double max_error = 0;       ///< infinity if a NaN or an infinity is compared with a different value
    double rmse = 0;            ///< root of the mean squared difference of all components
    double psnr_db = 0;         ///< -20 log10(rmse), peak 1; +infinity if rmse is 0
    /// SSIM of luma, -1..1; 1 for equal pictures. Absent if a side has fewer than 11 pixels. Wang et al. 2004, "Image
    /// Quality Assessment: From Error Visibility to Structural Similarity". Only windows entirely inside the picture
    /// are used, without downsampling.
    std::optional<double> ssim{};
    /// Mean FLIP over all pixels, 0..1; 0 for equal pictures. Andersson et al. 2020, "FLIP: A Difference Evaluator for
    /// Alternating Images".
    double flip = 0;
    std::uint64_t differing_pixels = 0;  ///< pixels that differ by more than the tolerance
    double differing_share = 0;          ///< 0..1: differing_pixels divided by all pixels
    /// Whether all components are equal.
    bool is_equal() const { return max_error == 0; }
};

/// Content of a difference picture.
enum class DifferenceKind : std::uint8_t {
    flip,      ///< FLIP per pixel, colored from dark blue (0) to white (1); EXR and HDR files get the value itself
    absolute,  ///< |a - b| times a gain, of display RGB; in EXR and HDR files of the stored components
};

/// The comparison of two pictures.
class RL_API ComparedPictures {
public:
    /// Compares two pictures. If their numbers of channels differ, gray is copied to RGB, and missing alpha is 1. If
    /// only one picture has linear light, the sRGB colors of the other picture are decoded.
    /// @throws Error check_failed: the sizes differ; usage: impossible options; bad_file: over the memory budget
    ComparedPictures(Pixels a, Pixels b, const CompareOptions& options, Context& context);
    ~ComparedPictures();
    ComparedPictures(ComparedPictures&&) noexcept;
    ComparedPictures& operator=(ComparedPictures&&) noexcept;

    /// The metrics.
    const PictureComparison& comparison() const;
    /// The difference picture, RGB.
    /// @param gain for DifferenceKind::absolute, > 0
    /// @param component u8, or f32 for unscaled values
    Pixels difference(DifferenceKind kind, double gain, Component component = Component::u8) const;

    struct State;  ///< internal
    const State& state() const { return *state_; }

private:
    std::unique_ptr<const State> state_;
};

/// Reads and decodes a picture file.
/// @throws Error not_found, bad_file
RL_API Pixels read_picture(const std::string& path, Context& context);

/// Whether read_picture() supports the ending of a name.
RL_API bool has_picture_ending(const std::string& path);

/// Whether a name denotes a scene: a world file, "builtin:...", or an ending of a model format of this build.
RL_API bool is_scene(const std::string& name);

/// Writes a difference picture in the format of its ending.
/// @throws Error usage: unknown ending; failed
RL_API void save_difference(const ComparedPictures& pictures, DifferenceKind kind, double gain,
                            const std::string& path);

/// Limits of a comparison. Absent limits are not checked.
struct CompareLimits {
    /// Limits of the members of PictureComparison.
    std::optional<double> max_error{}, max_rmse{}, min_psnr_db{}, min_ssim{}, max_flip{}, max_differing_share{};
    bool empty() const {
        return !max_error && !max_rmse && !min_psnr_db && !min_ssim && !max_flip && !max_differing_share;
    }
};

/// One entry for each violated limit, in the order of CompareLimits. If the comparison has no SSIM, min_ssim is
/// violated.
RL_API std::vector<CheckFailure> check_limits(const PictureComparison& comparison, const CompareLimits& limits);

/// A row of `compare --json`.
struct ComparisonRow : ReportRow {
    std::string a{}, b{};                ///< files or scenes
    std::string engine_a{}, engine_b{};  ///< engines that drew the scenes; empty for picture files
    CompareOptions options{};
    std::optional<PictureComparison> comparison{};
    std::vector<CheckFailure> failures{};  ///< violated limits
    std::string output{};                  ///< the written difference picture or page, or empty
};

/// {"schema": "rakelight.compare/1", "rows": [...]}; numbers that are not finite are null.
RL_API std::string to_json(std::span<const ComparisonRow> rows);
/// A readable table without the rows that have an error. Empty: there are no other rows.
RL_API std::string to_text(std::span<const ComparisonRow> rows);
/// "NAME", or "NAME (ENGINE)" if the engine is given.
RL_API std::string title_of(const std::string& name, const std::string& engine);

}  // namespace rakelight
