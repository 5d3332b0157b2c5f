// SPDX-License-Identifier: Apache-2.0
// The broken files of ../shared/hostile in the helper's formats keep their verdicts.
#include "support/hostile_cases.h"
#include "unit/io/import/import_support.h"

namespace rakelight::io::import_test {
namespace {

bool is_ours(const std::string& name) {
    std::string ending = std::filesystem::path(name).extension().string();
    for (char& c : ending) c = char(std::tolower(c));
    return !ending.empty() &&
           std::string(" .fbx .dae .3ds .ase .blend .x ").find(" " + ending + " ") != std::string::npos;
}

bool is_generated(const std::string& name) {
    return name.starts_with("truncated/") || name.starts_with("flipped/") || name.starts_with("mangled/") ||
           name.starts_with("dae/");
}

using ImportHostile = ImportTest;

TEST_F(ImportHostile, EveryFileKeepsItsVerdict) {
    RL_NEEDS_SHARED("hostile");
    std::size_t seen = 0;
    for (const auto& [name, fault, verdict, path] : rakelight::test::hostile_cases()) {
        if (!is_ours(name)) continue;
        SCOPED_TRACE(name + " (" + fault + "): " + verdict);
        ++seen;
        const Outcome outcome = read_import(path.string());
        const bool remarked = std::any_of(outcome.remarks.begin(), outcome.remarks.end(),
                                          [](const ReportEntry& e) { return e.remark != Remark::note; });
        if (outcome.error) {
            EXPECT_EQ(outcome.error->code(), ErrorCode::bad_file) << outcome.what();
            EXPECT_NE(outcome.what().find(std::filesystem::path(name).filename().string()), std::string::npos)
                << outcome.what();
            EXPECT_EQ(outcome.what().find('\n'), std::string::npos);
        }
        EXPECT_TRUE(verdict != "refuse" || outcome.error) << "it was accepted";
        EXPECT_TRUE(verdict != "warn+render" || (outcome.scene && remarked)) << outcome.what();
        EXPECT_TRUE(verdict != "either" || !is_generated(name) || outcome.error || remarked)
            << "accepted without a word";
    }
    EXPECT_GT(seen, 70u);
}

}  // namespace
}  // namespace rakelight::io::import_test
