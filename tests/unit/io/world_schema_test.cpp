// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rakelight/io/world.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "support/shared.h"

using namespace rakelight;
using namespace rakelight::test;

TEST(WorldSchema, TheFileInDataIsWhatTheTablesSay) {
    std::ifstream file(source_dir() / "data/world.schema.json");
    std::ostringstream text;
    text << file.rdbuf();
    EXPECT_TRUE(text.str() == world_schema()) << "write it with: rakelight check --schema > data/world.schema.json";
}

TEST(WorldSchema, EveryKeyOfAnExampleIsInIt) {
    const nlohmann::json schema = nlohmann::json::parse(world_schema());
    EXPECT_EQ(schema["additionalProperties"], false);
    const nlohmann::json& light = schema["properties"]["light"]["items"];
    EXPECT_EQ(light["required"], nlohmann::json{"type"});
    EXPECT_EQ(light["additionalProperties"], false);
    EXPECT_EQ(light["properties"]["cutoff_deg"]["maximum"], 90);
    EXPECT_EQ(schema["properties"]["material"]["items"]["properties"]["bump_steps"]["items"]["type"], "integer");
    EXPECT_EQ(schema["properties"]["model"]["items"]["properties"]["normals"]["enum"].size(), 6u);
    EXPECT_EQ(schema["properties"]["camera"]["items"]["properties"]["vertical_fov_deg"]["exclusiveMaximum"], 180);
}
