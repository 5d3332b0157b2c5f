// SPDX-License-Identifier: Apache-2.0
// A temporary folder in which a test writes model files, and what loading one of them gave.
#pragma once
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "io/reader.h"

namespace rakelight::io::test {

class ObjFolder : public ::testing::Test {
protected:
    void SetUp() override {
        const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::path(::testing::TempDir()) /
                  (std::string("rl_obj_") + info->name() + "_" + std::to_string(::getpid()));
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::string write(const std::string& name, const std::string& text) {
        const auto path = folder_ / name;
        std::filesystem::create_directories(path.parent_path());
        std::ofstream(path, std::ios::binary) << text;
        return path.string();
    }
    /// Writes model.obj and loads it into a fresh report.
    Scene load(const std::string& text, const ReadOptions& options = {}) {
        context_.emplace();
        return read_obj(write("model.obj", text), options, *context_);
    }
    std::string error_of(const std::string& text) {
        try {
            load(text);
        } catch (const Error& e) {
            EXPECT_EQ(e.code(), ErrorCode::bad_file);
            return e.what();
        }
        return {};
    }
    std::vector<ReportEntry> remarks() { return context_->report().entries(); }
    /// The first remark whose message holds `part`.
    std::optional<ReportEntry> remark(const std::string& part) {
        for (const ReportEntry& e : remarks())
            if (e.message.find(part) != std::string::npos) return e;
        return std::nullopt;
    }

    std::filesystem::path folder_;
    std::optional<Context> context_;
};

}  // namespace rakelight::io::test
