// SPDX-License-Identifier: Apache-2.0
// What the tests of the import helper share: the built helper, a folder for files, and what reading one gave.
#pragma once
#include <gtest/gtest.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "io/model_readers.h"
#include "support/environment_variable.h"
#include "support/shared.h"
#include "support/temporary_folder.h"

namespace rakelight::io::import_test {

using rakelight::test::EnvironmentVariable;

struct Outcome {
    std::optional<Scene> scene;
    std::optional<Error> error;
    std::vector<ReportEntry> remarks;
    bool says(const std::string& part) const {
        return std::any_of(remarks.begin(), remarks.end(),
                           [&](const ReportEntry& e) { return e.message.find(part) != std::string::npos; });
    }
    std::string what() const { return error ? error->what() : "read"; }
};

inline Outcome read_import(const std::string& path, const ReadOptions& options = {},
                           ContextOptions run = {.threads = 1}) {
    Outcome outcome;
    Context context(run);
    try {
        outcome.scene = import_reader.read(path, options, context);
    } catch (const Error& e) {
        outcome.error = e;
    }
    outcome.remarks = context.report().entries();
    return outcome;
}

/// Tests that start the helper which this build made; skipped in a build without it.
class ImportTest : public ::testing::Test {
protected:
    void SetUp() override {
#if defined(RL_IMPORT_HELPER)
        helper_.emplace("RAKELIGHT_IMPORT", RL_IMPORT_HELPER);
#else
        GTEST_SKIP() << "built without the import helper";
#endif
    }
    std::string write(const std::string& name, const std::string& text) const { return folder_.write(name, text); }
    rakelight::test::TemporaryFolder folder_;
    std::optional<EnvironmentVariable> helper_;
};

/// World positions and normals of all triangle corners, in the file's order.
struct Corner {
    dvec3 position;
    dvec3 normal;
};
std::vector<Corner> corners_of(const Scene& scene);

}  // namespace rakelight::io::import_test
