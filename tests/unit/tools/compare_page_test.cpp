// SPDX-License-Identifier: Apache-2.0
// The page of a comparison: its pictures are in it, and nothing of it is elsewhere.
#include <rakelight/tools/compare.h>
#include <rakelight_internal/tools/compare_page.h>

#include <gtest/gtest.h>

#include "io/files/file.h"
#include "io/pictures/image_io.h"
#include "support/temporary_folder.h"
#include "tools/html.h"
#include "unit/image/image_support.h"
#include "unit/io/pictures/image_io_support.h"

namespace rakelight {
namespace {

using test::picture_of;

std::span<const std::byte> bytes_of(std::string_view text) { return std::as_bytes(std::span(text)); }

TEST(Html, DataUrisAreBase64) {  // RFC 4648, section 10
    const std::pair<const char*, const char*> vectors[] = {{"", ""},
                                                           {"f", "Zg=="},
                                                           {"fo", "Zm8="},
                                                           {"foo", "Zm9v"},
                                                           {"foob", "Zm9vYg=="},
                                                           {"fooba", "Zm9vYmE="},
                                                           {"foobar", "Zm9vYmFy"}};
    for (const auto& [text, expected] : vectors)
        EXPECT_EQ(data_uri("text/plain", bytes_of(text)), std::string("data:text/plain;base64,") + expected);
    std::vector<std::byte> all(256);
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = std::byte(i);
    EXPECT_EQ(io::base64_decode(data_uri("a/b", all).substr(16)), all);
}

TEST(Html, TextCannotEndElementsOrAttributes) { EXPECT_EQ(html_text("a<b>&\"c\n"), "a&lt;b&gt;&amp;&quot;c?"); }

class ComparePage : public testing::Test {
protected:
    std::string page() {
        ComparisonPage page;
        page.add({"<i>x</i>", "a&b", "\"c\""}, pictures_, {}, 10);
        page.add({"second", "soft", "gl"}, pictures_, {}, 10);
        page.save(folder_.file("page.html"));
        const std::vector<std::byte> bytes = test::bytes_of_file(folder_.file("page.html"));
        return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
    }

    /// The pictures of a class in their order.
    std::vector<Pixels> images(const std::string& page, const std::string& name) {
        std::vector<Pixels> found;
        const std::string mark = "<img class=\"" + name + "\"", begin = "src=\"data:image/png;base64,";
        for (std::size_t at = 0; (at = page.find(mark, at)) != page.npos; ++at) {
            const std::size_t from = page.find(begin, at) + begin.size();
            const auto bytes = io::base64_decode(page.substr(from, page.find('"', from) - from));
            found.push_back(io::decode_image(bytes.value(), context_));
        }
        return found;
    }

    test::TemporaryFolder folder_;
    Context context_{{.threads = 1}};
    Pixels a_ = picture_of<std::uint8_t>(31, 14, 3, test::noise);
    Pixels b_ = picture_of<std::uint8_t>(31, 14, 3, [](int x, int y, int c) { return test::noise(x, y, c) & 240; });
    ComparedPictures pictures_{a_, b_, {}, context_};
};

TEST_F(ComparePage, HoldsBothPicturesAndBothDifferences) {
    const std::string text = page();
    const std::pair<const char*, Pixels> expected[] = {
        {"a", a_},
        {"b", b_},
        {"flip", pictures_.difference(DifferenceKind::flip, 1)},
        {"absolute", pictures_.difference(DifferenceKind::absolute, 10)}};
    for (const auto& [name, pixels] : expected) {
        const std::vector<Pixels> found = images(text, name);
        ASSERT_EQ(found.size(), 2u) << name;
        for (const Pixels& p : found) EXPECT_EQ(p.bytes, pixels.bytes) << name;
    }
}

TEST_F(ComparePage, RefersToNothingOutside) {
    const std::string text = page();
    for (const char* word : {"http:", "https:", "<link", "@import", "url("})
        EXPECT_EQ(text.find(word), text.npos) << word;
    for (std::size_t at = 0; (at = text.find("src=\"", at)) != text.npos; ++at)
        EXPECT_EQ(text.substr(at + 5, 5), "data:");
    EXPECT_EQ(text.find("href"), text.npos);
}

TEST_F(ComparePage, ForeignNamesAreText) {
    const std::string text = page();
    EXPECT_EQ(text.find("<i>x"), text.npos);
    EXPECT_NE(text.find("<h2>&lt;i&gt;x&lt;/i&gt;</h2>"), text.npos);
    EXPECT_NE(text.find("alt=\"&quot;c&quot;\""), text.npos);
    EXPECT_NE(text.find("a&amp;b"), text.npos);
}

}  // namespace
}  // namespace rakelight
