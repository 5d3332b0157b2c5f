// SPDX-License-Identifier: Apache-2.0
// Of a build without OpenEXR (RAKELIGHT_OPENEXR=OFF).
#include "base/left_out.h"
#include "io/pictures/image_formats.h"

namespace rakelight::io::codec {
namespace {

Error no_exr(ErrorCode code = ErrorCode::bad_file) {
    return left_out("EXR pictures", "OpenEXR", "RAKELIGHT_OPENEXR", code);
}

Pixels read_exr(std::span<const std::byte>, Want, Context&) { throw no_exr(); }
std::unique_ptr<RowReader> read_exr_rows(std::unique_ptr<InputFile>, Context&) { throw no_exr(); }

std::unique_ptr<ImageWriter> write_exr(const OutputTarget& target, int, int, int, Component) {
    throw no_exr(ErrorCode::usage).with_file(target.path);
}
std::unique_ptr<ImageWriter> write_exr_channels(const OutputTarget& target, int, int, std::vector<ExrChannel>) {
    throw no_exr(ErrorCode::usage).with_file(target.path);
}

}  // namespace

constinit const ReadableFormat readable_exr = {.read = read_exr, .read_rows = read_exr_rows};
constinit const WritableFormat writable_exr = {
    .component = Component::f32, .write = write_exr, .write_channels = write_exr_channels};

}  // namespace rakelight::io::codec
