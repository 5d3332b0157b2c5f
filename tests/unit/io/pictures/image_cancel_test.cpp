// SPDX-License-Identifier: Apache-2.0
// A reader that is at work when the run is cancelled stops, and says that and not that the picture is broken.
#include <gtest/gtest.h>

#include <string>

#include "io/pictures/image_formats.h"
#include "io/pictures/image_io.h"
#include "unit/io/pictures/image_io_support.h"

namespace rakelight::io {
namespace {

TEST(CancelledPictures, AreNotReadToTheEnd) {
    struct Case {
        const char* name;
        Component component;
        const codec::ReadableFormat& format;
    };
    const test::TemporaryFolder folder;
    for (const Case& c :
         {Case{"a.png", Component::u8, codec::readable_png}, Case{"a.jpg", Component::u8, codec::readable_jpeg},
          Case{"a.exr", Component::f32, codec::readable_exr}, Case{"a.hdr", Component::f32, codec::readable_hdr}}) {
        write_image(folder.file(c.name), test::noise_picture(64, 48, 3, c.component));
        const std::vector<std::byte> bytes = test::bytes_of_file(folder / c.name);
        Context context;
        EXPECT_EQ(c.format.read(bytes, codec::Want::pixels, context).width, 64) << c.name;
        context.cancel();
        const Error error = test::error_of([&] { c.format.read(bytes, codec::Want::pixels, context); });
        EXPECT_EQ(error.code(), ErrorCode::failed) << c.name;
        EXPECT_EQ(error.reason(), "cancelled") << c.name;
    }
}

}  // namespace
}  // namespace rakelight::io
