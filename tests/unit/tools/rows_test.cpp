// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <rakelight/tools/rows.h>

namespace rakelight {
namespace {

TEST(PictureJson, HoldsResultsErrorsAndForeignBytes) {
    std::vector<PictureRow> rows(2);
    rows[0].result = {.file = "a\xFF\n\"b.glb", .output = "a.png", .width = 3, .triangles = 12, .isa = "avx2"};
    rows[0].remarks = {{Remark::dropped, "a", "node 1", "something", 3}};
    rows[1].result = {.file = "b.glb", .output = "b.png"};
    rows[1].error = Error(ErrorCode::bad_file, "broken", "accessor 3").with_file("b.glb");
    const auto json = nlohmann::json::parse(to_json(rows));
    EXPECT_EQ(json["schema"], "rakelight.render/1");
    ASSERT_EQ(json["rows"].size(), 2u);
    EXPECT_EQ(json["rows"][0]["file"], "a\xEF\xBF\xBD\n\"b.glb");
    EXPECT_EQ(json["rows"][0]["triangles"], 12);
    EXPECT_EQ(json["rows"][0]["remarks"][0]["count"], 3);
    EXPECT_EQ(json["rows"][1]["error"]["exit_code"], 4);
    EXPECT_EQ(json["rows"][1]["error"]["place"], "accessor 3");
    EXPECT_FALSE(json["rows"][1].contains("width"));
    EXPECT_TRUE(nlohmann::json::parse(to_json(std::span<const PictureRow>()))["rows"].empty());
}

}  // namespace
}  // namespace rakelight
