// SPDX-License-Identifier: Apache-2.0
// Pictures of the fake engine as files in a folder of the test's own.
#pragma once
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "io/file.h"
#include "io/image_io.h"
#include "render/picture_files.h"
#include "render/picture_steps.h"
#include "unit/render/fake_engine.h"

namespace rakelight::test {

class PictureFiles : public testing::Test {
protected:
    void SetUp() override {
        folder_ = std::filesystem::temp_directory_path() /
                  ("rakelight_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::string file(const std::string& name) const { return (folder_ / name).string(); }
    Pixels decode(const std::string& name) { return io::decode_image(*io::read_file(file(name), context_), context_); }
    /// @param result  its view_range is what channels are shown by
    PictureResult draw(const PictureRequest& request, PictureResult result = {}) {
        draw_to_files(engine_, {}, request, result, context_);
        return result;
    }

    std::filesystem::path folder_;
    Context context_{{.threads = 2}};
    FakeEngine engine_;
};

}  // namespace rakelight::test
