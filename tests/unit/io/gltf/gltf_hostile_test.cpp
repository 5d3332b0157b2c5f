// SPDX-License-Identifier: Apache-2.0
// The broken files of ../shared/hostile: each keeps its verdict as far as the reader alone decides it.
#include <rakelight/base/report.h>
#include <rakelight/scene/validate.h>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <fstream>

#include "io/model_readers.h"
#include "support/shared.h"

namespace rakelight {
namespace {

struct Outcome {
    std::optional<Error> error;
    std::size_t remarks = 0;
};

Outcome read(const std::filesystem::path& path) {
    Outcome outcome;
    Context context({.threads = 1});
    try {
        const Scene scene = io::gltf_reader.read(path.string(), {}, context);
        validate(scene);
    } catch (const Error& error) {
        outcome.error = error;
    }
    for (const ReportEntry& entry : context.report().entries()) outcome.remarks += entry.remark != Remark::note;
    return outcome;
}

void expect_one_line(const Error& error, const std::filesystem::path& path) {
    const std::string text = error.what();
    EXPECT_EQ(text.find('\n'), std::string::npos);
    EXPECT_NE(text.find(path.filename().string()), std::string::npos) << text;
    EXPECT_FALSE(error.reason().empty());
}

/// What repairing attributes and nodes (the list) or decoding a picture says comes later than the reader.
/// The acceptance test over the whole program holds these files to their verdict too.
bool is_said_later(const std::string& name) {
    for (const char* known : {"nan_positions", "inf_positions", "huge_positions", "tiny_positions", "nan_normals",
                              "zero_normals", "tangent_w0", "nan_uv", "huge_uv", "constant_uv", "degenerate_all",
                              "coincident", "scale_zero", "matrix_singular"})
        if (name == std::string("gltf/") + known + ".gltf") return true;
    return name.find("texture_png") != std::string::npos || name.find("texture_not_an_image") != std::string::npos ||
           name.starts_with("pngsuite/");
}

TEST(GltfHostile, EveryFileKeepsItsVerdict) {
    RL_NEEDS_SHARED("hostile");
    const auto root = test::shared_dir() / "hostile";
    std::ifstream in(root / "cases.json");
    const auto cases = nlohmann::json::parse(in);
    std::size_t seen = 0;
    for (const auto& entry : cases) {
        const auto name = entry[0].get<std::string>(), verdict = entry[2].get<std::string>();
        if (verdict == "-" || !(name.ends_with(".gltf") || name.ends_with(".glb"))) continue;
        SCOPED_TRACE(name + " (" + entry[1].get<std::string>() + "): " + verdict);
        ++seen;
        const Outcome outcome = read(root / name);
        const std::string said = outcome.error ? outcome.error->what() : "loaded";
        if (outcome.error) expect_one_line(*outcome.error, root / name);
        if (verdict == "refuse") {
            EXPECT_TRUE(outcome.error) << said;
        }
        if (verdict == "render" || verdict == "warn+render") {
            EXPECT_FALSE(outcome.error) << said;
        }
        if (verdict == "load") {
            EXPECT_TRUE(!outcome.error || outcome.error->reason().find("nothing to draw") != std::string::npos) << said;
        }
        const bool is_generated = name.starts_with("gltf/") || name.starts_with("glb/");
        if (verdict == "warn+render" || (verdict == "either" && is_generated)) {
            EXPECT_TRUE(outcome.error || outcome.remarks > 0 || is_said_later(name)) << "loaded without a word";
        }
    }
    EXPECT_GE(seen, 200u);
}

TEST(GltfHostile, MessagesNameAReferenceOutsideAsItIsWritten) {
    RL_NEEDS_SHARED("hostile");
    Context context({.threads = 1});
    const auto folder = test::shared_dir() / "hostile/gltf";
    io::gltf_reader.read((folder / "path_traversal_texture.gltf").string(), {}, context);
    ASSERT_FALSE(context.report().entries().empty());
    EXPECT_NE(context.report().entries()[0].message.find("'../../../../../../etc/passwd' leaves the model's folder"),
              std::string::npos)
        << context.report().entries()[0].message;
    const Outcome outcome = read(folder / "path_traversal_buffer.gltf");
    ASSERT_TRUE(outcome.error);
    EXPECT_NE(std::string(outcome.error->what()).find("etc/"), std::string::npos) << outcome.error->what();
}

}  // namespace
}  // namespace rakelight
