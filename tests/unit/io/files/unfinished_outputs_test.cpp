// SPDX-License-Identifier: Apache-2.0
#include "io/files/unfinished_outputs.h"

#include <gtest/gtest.h>
#include <rakelight_internal/io/unfinished_outputs.h>

#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "io/files/output_file.h"
#include "support/temporary_folder.h"

namespace rakelight::io {
namespace {

namespace fs = std::filesystem;

std::size_t files_in(const test::TemporaryFolder& folder) {
    return std::size_t(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()));
}

TEST(UnfinishedOutputs, AreRemovedAndWhatIsWholeStays) {
    const test::TemporaryFolder folder;
    folder.write("replaced", "before");
    OutputFile whole(folder.file("whole")), half(folder.file("half")), replacing(folder.file("replaced"));
    whole.commit();
    EXPECT_EQ(files_in(folder), 4u);
    remove_unfinished_outputs();
    EXPECT_EQ(files_in(folder), 2u);
    EXPECT_TRUE(fs::exists(folder / "whole"));
    EXPECT_EQ(fs::file_size(folder / "replaced"), 6u);
    EXPECT_THROW(half.commit(), Error);
    remove_unfinished_outputs();
    EXPECT_EQ(files_in(folder), 2u);
}

TEST(UnfinishedOutputs, OfManyAtOnceAreRemovedAsFarAsTheyAreWatched) {
    const test::TemporaryFolder folder;
    for (int round = 0; round < 3; ++round) {  // places are free again
        std::vector<std::unique_ptr<OutputFile>> files;
        for (int i = 0; i < 300; ++i) files.push_back(std::make_unique<OutputFile>(folder.file(std::to_string(i))));
        EXPECT_EQ(files_in(folder), 300u);
        if (round == 2) remove_unfinished_outputs();
        EXPECT_EQ(files_in(folder), round == 2 ? 300u - 256u : 300u);
    }
    EXPECT_TRUE(folder.is_empty());
}

}  // namespace
}  // namespace rakelight::io
