// SPDX-License-Identifier: Apache-2.0
// MP4, WebM and GIF: what ffmpeg is told. One thread and no dates, so that the same pictures give the same bytes.
#include <sys/mman.h>

#include <cerrno>
#include <charconv>

#include "base/format_text.h"
#include "io/files/descriptor.h"
#include "io/files/output_file.h"
#include "io/movie/ffmpeg_process.h"
#include "io/movie/movie_formats.h"

namespace rakelight::io {
namespace {

using Words = std::vector<std::string>;

Words joined(std::initializer_list<Words> parts) {
    Words all;
    for (const Words& part : parts) all.insert(all.end(), part.begin(), part.end());
    return all;
}

std::string text_of(double number) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, number).ptr};
}

/// The pictures as they come in.
Words begin(const MoviePictures& pictures) {
    return {"-hide_banner",
            "-nostdin",
            "-loglevel",
            "error",
            "-threads",
            "1",
            "-filter_threads",
            "1",
            "-filter_complex_threads",
            "1",
            "-f",
            "image2pipe",
            "-framerate",
            text_of(pictures.fps),
            "-c:v",
            "png",
            "-i",
            ffmpeg_input};
}

/// The file that goes out.
Words end(const char* format) {
    return {"-threads",  "1",  "-map_metadata", "-1", "-fflags",    "+bitexact", "-flags:v",
            "+bitexact", "-f", format,          "-y", ffmpeg_output};
}

/// sRGB to the numbers of HD video (ITU-R BT.709), which players expect.
std::string to_video(const char* pixels) {
    return std::string(
               "scale=out_color_matrix=bt709:out_range=tv:flags=bicubic+accurate_rnd+full_chroma_int+bitexact,"
               "format=") +
           pixels;
}
const Words video_colors{"-color_primaries", "bt709", "-color_trc",   "iec61966-2-1",
                         "-colorspace",      "bt709", "-color_range", "tv"};

/// 4:2:0 halves both sides: an odd one gets its last row or column twice.
std::string to_even(const PngHeader& header) {
    const std::uint32_t right = header.width % 2, bottom = header.height % 2;
    if (right + bottom == 0) return {};
    return format_text("pad={}:{}:0:0,fillborders=right={}:bottom={}:mode=smear,", header.width + right,
                       header.height + bottom, right, bottom);
}

Words mp4_words(const MoviePictures& pictures) {
    return joined({begin(pictures),
                   {"-vf", to_even(pictures.header) + to_video("yuv420p"), "-c:v", "libx264", "-preset", "medium",
                    "-crf", "16", "-movflags", "+faststart"},
                   video_colors,
                   end("mp4")});
}

Words webm_words(const MoviePictures& pictures) {
    return joined({begin(pictures),
                   {"-vf", to_video(pictures.header.has_alpha() ? "yuva420p" : "yuv420p"), "-c:v", "libvpx-vp9", "-b:v",
                    "0", "-crf", "20", "-deadline", "good", "-cpu-used", "3", "-row-mt", "0", "-auto-alt-ref",
                    pictures.header.has_alpha() ? "0" : "1"},
                   video_colors,
                   end("webm")});
}

/// One palette for all pictures, found in a first run.
void encode_gif(const MoviePictures& pictures, int output, Context& context) {
    const Descriptor palette{::memfd_create("palette", MFD_CLOEXEC)};
    if (palette.fd < 0) throw Error(ErrorCode::failed, "no memory for a palette: " + system_message(errno));
    run_ffmpeg({joined({begin(pictures), {"-vf", "palettegen", "-frames:v", "1", "-c:v", "png"}, end("image2pipe")}),
                pictures.files, palette.fd, -1, 0, 0.4},
               context);
    run_ffmpeg({joined({begin(pictures),
                        {"-f", "png_pipe", "-i", ffmpeg_second_input, "-lavfi", "[0][1]paletteuse", "-loop", "0"},
                        end("gif")}),
                pictures.files, output, palette.fd, 0.4, 1},
               context);
}

/// @param encode  puts the movie into the file of this descriptor
template <class Encode>
void write(const std::string& path, const Encode& encode) {
    OutputFile out(path);
    try {
        encode(::fileno(out.handle()));
    } catch (const Error& error) {
        throw error.with_file(path);
    }
    out.commit();
}

void write_gif(const std::string& path, const MoviePictures& pictures, Context& context) {
    write(path, [&](int output) { encode_gif(pictures, output, context); });
}
void write_mp4(const std::string& path, const MoviePictures& pictures, Context& context) {
    write(path, [&](int output) { run_ffmpeg({mp4_words(pictures), pictures.files, output}, context); });
}
void write_webm(const std::string& path, const MoviePictures& pictures, Context& context) {
    write(path, [&](int output) { run_ffmpeg({webm_words(pictures), pictures.files, output}, context); });
}

}  // namespace

constinit const MovieFormat gif_movie = {.ending = "gif", .most_side = 65535, .write = write_gif, .is_by_ffmpeg = true};
constinit const MovieFormat mp4_movie = {
    .ending = "mp4", .most_side = 16384, .write = write_mp4, .has_alpha = false, .is_by_ffmpeg = true};
constinit const MovieFormat webm_movie = {
    .ending = "webm", .most_side = 16384, .write = write_webm, .is_by_ffmpeg = true};

}  // namespace rakelight::io
