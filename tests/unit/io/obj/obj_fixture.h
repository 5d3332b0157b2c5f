// SPDX-License-Identifier: Apache-2.0
// A temporary folder in which a test writes model files, and what loading one of them gave.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "io/model_readers.h"
#include "support/temporary_folder.h"

namespace rakelight::io::obj_test {

class ObjFolder : public ::testing::Test {
protected:
    std::string write(const std::string& name, const std::string& text) { return folder_.write(name, text); }
    /// Writes model.obj and loads it into a fresh report.
    Scene load(const std::string& text, const ReadOptions& options = {}) {
        context_.emplace();
        return obj_reader.read(write("model.obj", text), options, *context_);
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

    rakelight::test::TemporaryFolder folder_;
    std::optional<Context> context_;
};

}  // namespace rakelight::io::obj_test
