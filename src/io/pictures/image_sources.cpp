// SPDX-License-Identifier: Apache-2.0
// Pictures that callers bring.
#include <utility>

#include <rakelight/io/image_sources.h>

#include "base/enumerators.h"
#include "base/format_text.h"
#include "io/pictures/image_io.h"
#include "io/pictures/new_pixels.h"

namespace rakelight {
namespace {

void check(const Pixels& p, const std::string& name) {
    const bool fits = p.width > 0 && p.height > 0 && p.width <= int(io::codec::max_side) &&
                      p.height <= int(io::codec::max_side) && p.channels >= 1 && p.channels <= 4 &&
                      exists(p.component, Component::f32) && p.bytes.size() == p.row_bytes() * std::size_t(p.height);
    if (!fits)
        throw Error(ErrorCode::usage, format_text("a picture of {} x {} pixels of {} components with {} bytes", p.width,
                                                  p.height, p.channels, p.bytes.size()))
            .with_file(name);
}

}  // namespace

ImageHandle image_from_file(const std::string& path) { return io::image_from_file(path, path, path); }

ImageHandle image_from_bytes(std::vector<std::byte> bytes, const std::string& name) {
    return io::image_from_bytes(name, name, std::make_shared<const std::vector<std::byte>>(std::move(bytes)), {});
}

ImageHandle image_from_pixels(Pixels pixels, const std::string& name) {
    check(pixels, name);
    EncodedImage image;
    image.name = image.file = name;
    const auto shared = std::make_shared<const Pixels>(std::move(pixels));
    image.decode = [shared](const EncodedImage&, Context& context) {
        MemoryCharge charge(context.memory(), shared->bytes.size(), "the picture");
        Pixels copy = *shared;
        copy.charge = share(std::move(charge));
        return copy;
    };
    return std::make_shared<const EncodedImage>(std::move(image));
}

}  // namespace rakelight
