// SPDX-License-Identifier: Apache-2.0
// A picture is the same to the bit, whatever drew it: alone, in a sequence, by a session that drew others before, in the viewer.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include <rakelight/render/render.h>
#include <rakelight/world/render_keys.h>

#include "one_way/table.h"
#include "one_way/ways.h"
#include "support/temporary_folder.h"

namespace rakelight::test {
namespace {

constexpr double step_s = 0.5;
constexpr std::size_t moments = 3;

std::string model() { return (source_dir() / "tests/one_way/moving.glb").string(); }

PictureRequest request_of(const std::vector<WorldValue>& values) {
    PictureRequest request{.input = model()};
    request.load.allow_shaders = true;
    request.output = "picture.png";
    read_render_keys(values, request);
    return request;
}

bool has_engine(const std::string& name) {
    try {
        return name.empty() || make_engine(name);
    } catch (const Error&) {
        return false;
    }
}

/// How many pixels differ; -1: the sizes do.
int differing(const Shown& a, const Shown& b) {
    if (a.width != b.width || a.height != b.height || a.codes.size() != b.codes.size()) return -1;
    int count = 0;
    for (std::size_t i = 0; i < a.codes.size(); ++i) count += a.codes[i] != b.codes[i];
    return count;
}

TEST(OneWay, EveryKeyHasAnExample) {
    std::set<std::string> of_table;
    for (const Example& example : read_table().examples) of_table.insert(example.key());
    for (const RenderKey& key : render_keys()) EXPECT_TRUE(of_table.erase(key.name)) << key.name << " has no example";
    EXPECT_EQ(of_table, std::set<std::string>()) << "are no keys";
}

/// By all ways, of the table's examples in their order: what one leaves behind is there for the next.
class Ways {
public:
    void try_example(const Example& example) {
        const PictureRequest request = request_of(example.values), without = request_of(example.without_key());
        TemporaryFolder folder;
        const auto is_compared = [&](const char* way) { return !example.differs.contains(way); };
        std::vector<Shown> in_sequence;
        if (is_compared("sequence"))
            in_sequence = by_sequence(request, step_s, moments, folder.path().string(), context_);
        bool has_changed = false;
        for (std::size_t i = 0; i < moments; ++i) {
            const double time_s = step_s * double(i);
            const Shown alone = by_picture(request, time_s, context_);
            has_changed |= alone != by_picture(without, time_s, context_);
            const auto compare = [&](const char* way, const Shown& shown) {
                EXPECT_EQ(differing(alone, shown), 0) << "pixels differ by way of " << way << " at " << time_s << " s";
            };
            if (is_compared("sequence")) compare("sequence", in_sequence.at(i));
            if (is_compared("session")) compare("session", by_session_.draw(request, time_s, context_));
            if (is_compared("viewer")) compare("viewer", by_viewer_.draw(request, time_s));
        }
        EXPECT_EQ(has_changed, example.same.empty()) << "it shows nothing, or should not: " << example.same;
    }

private:
    Context context_{{.threads = 2}};
    BySession by_session_;
    ByViewer by_viewer_{model(), context_};
};

TEST(OneWay, LeadsToOnePictureAtRest) {
    Context context;
    BySession by_session;
    ByViewer by_viewer(model(), context);
    const PictureRequest request = request_of(read_table().base);
    const Shown at_rest = by_picture(request, {}, context), moved = by_picture(request, 0.5, context);
    EXPECT_NE(differing(at_rest, moved), 0);
    for (int round = 0; round < 2; ++round) {
        EXPECT_EQ(differing(by_session.draw(request, {}, context), at_rest), 0);
        EXPECT_EQ(differing(by_viewer.draw(request, {}), at_rest), 0);
        EXPECT_EQ(differing(by_session.draw(request, 0.5, context), moved), 0);
        EXPECT_EQ(differing(by_viewer.draw(request, 0.5), moved), 0);
    }
}

TEST(OneWay, LeadsToOnePicture) {
    Ways ways;
    for (const Example& example : read_table().examples)
        if (has_engine(example.needs)) {
            SCOPED_TRACE(example.name);
            EXPECT_NO_THROW(ways.try_example(example));
        }
}

}  // namespace
}  // namespace rakelight::test
