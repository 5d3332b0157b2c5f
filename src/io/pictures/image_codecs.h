// SPDX-License-Identifier: Apache-2.0
// Internal to io: one reader and one writer per picture format, and what they share.
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "io/files/output_file.h"
#include "io/pictures/image_io.h"

namespace rakelight::io::codec {

inline constexpr std::uint32_t max_side = 32768;  ///< [px] the largest picture side that is read

/// What a reader returns: the pixels, or only what the header tells of them (Pixels without bytes).
enum class Want : std::uint8_t { pixels, header };

/// Memory for a picture, after its size was checked against `max_side` and the memory budget; none if only the header
/// is wanted.
/// @throws Error bad_file: no pixels, too large
Pixels make_pixels(std::uint64_t width, std::uint64_t height, int channels, Component component, Want want,
                   Context& context);

[[noreturn]] void bad_picture(const std::string& reason, const std::string& advice = {});

/// The readers. Each is given bytes that begin like its format. @throws Error bad_file
Pixels read_png(std::span<const std::byte> bytes, Want want, Context& context);
Pixels read_jpeg(std::span<const std::byte> bytes, Want want, Context& context);
Pixels read_webp(std::span<const std::byte> bytes, Want want, Context& context);
Pixels read_exr(std::span<const std::byte> bytes, Want want, Context& context);
Pixels read_hdr(std::span<const std::byte> bytes, Want want, Context& context);
Pixels read_bmp(std::span<const std::byte> bytes, Want want, Context& context);
Pixels read_tga(std::span<const std::byte> bytes, Want want, Context& context);
/// One of the readers. @throws Error bad_file: no known format
using PictureReader = Pixels (*)(std::span<const std::byte> bytes, Want want, Context& context);
PictureReader reader_of(std::span<const std::byte> bytes);

/// A picture at 1/factor of its size: each pixel is the mean code value of factor * factor pixels, fewer at the right
/// and lower border. @param row_at  row y of the whole picture; called once a row, from top to bottom
Pixels block_means(const Pixels& header, int factor, const std::function<const std::byte*(int y)>& row_at,
                   Context& context);
/// Readers that need no memory for the whole picture. JPEG: by a smaller inverse transform. @param factor  a power of 2
Pixels read_reduced_png(std::span<const std::byte> bytes, int factor, Context& context);
Pixels read_reduced_jpeg(std::span<const std::byte> bytes, int factor, Context& context);
/// Any format. @param most_side  [px] > 0: the picture is halved until no side is longer
Pixels read_reduced(std::span<const std::byte> bytes, int most_side, Want want, Context& context);
/// [pixels] What read_reduced() and the mip levels cost: as many as a PNG file with 3 x 8 bits a pixel has that takes
/// about as long to decode.
std::uint64_t reduced_work(std::span<const std::byte> bytes, int most_side, Context& context);
/// Whether all coefficients of a JPEG file are decoded before the first pixel is.
bool has_several_scans(std::span<const std::byte> bytes, Context& context);
/// @param bytes  a WebP file whose header was read
bool is_lossless_webp(std::span<const std::byte> bytes);
/// Refuses an EXR file whose headers would make the library ask for more memory than the file explains.
/// @param bytes  the file, or its beginning with all of its headers
void check_exr(std::span<const std::byte> bytes, Context& context, std::uint64_t most_a_side = max_side);
/// TGA has no magic number: true where the header could be one.
bool may_be_tga(std::span<const std::byte> bytes);

/// The writers. Sizes are 1..65536, channels 1..4, the component is component_for(target.path) or u16 for PNG.
std::unique_ptr<ImageWriter> write_png(const OutputTarget& target, int width, int height, int channels,
                                       Component component);
std::unique_ptr<ImageWriter> write_jpeg(const OutputTarget& target, int width, int height, int channels,
                                        Component component);
std::unique_ptr<ImageWriter> write_webp(const OutputTarget& target, int width, int height, int channels,
                                        Component component);
std::unique_ptr<ImageWriter> write_exr(const OutputTarget& target, int width, int height, int channels,
                                       Component component);
std::unique_ptr<ImageWriter> write_hdr(const OutputTarget& target, int width, int height, int channels,
                                       Component component);
std::unique_ptr<ImageWriter> write_ppm(const OutputTarget& target, int width, int height, int channels,
                                       Component component);
std::unique_ptr<ImageWriter> write_exr_channels(const OutputTarget& target, int width, int height,
                                                std::vector<ExrChannel> channels);

}  // namespace rakelight::io::codec
