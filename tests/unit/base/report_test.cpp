// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rakelight/base/report.h>

using namespace rakelight;

TEST(Report, CountsEqualRemarksAndKeepsTheFirstPlace) {
    Report r;
    r.add(Remark::dropped, "a.obj", "line 3", "a line primitive is not drawn");
    r.add(Remark::dropped, "a.obj", "line 9", "a line primitive is not drawn");
    r.add(Remark::changed, "a.obj", "line 9", "a line primitive is not drawn");
    ASSERT_EQ(r.entries().size(), 2u);
    EXPECT_EQ(r.entries()[0].count, 2u);
    EXPECT_EQ(r.entries()[0].place, "line 3");
}

TEST(Report, IsBoundedHoweverManyRemarksAFileCauses) {
    Report r;
    for (int i = 0; i < 1500; ++i) r.add(Remark::warning, "a", "", std::to_string(i));
    EXPECT_EQ(r.entries().size(), 1000u);
    EXPECT_EQ(r.left_out(), 500u);
}

TEST(Report, HasRoomForWarningsHoweverManyNotesThereAre) {
    Report r;
    for (int i = 0; i < 1200; ++i) r.add(Remark::note, "a", "", std::to_string(i));
    EXPECT_EQ(r.left_out(), 200u);
    EXPECT_EQ(r.notes_left_out(), 200u);
    r.add(Remark::dropped, "a", "", "x");
    EXPECT_EQ(r.left_out(), 200u) << "notes push no warning out";
    EXPECT_EQ(r.entries().back().message, "x");
    EXPECT_EQ(r.notes_left_out(), 200u);
    r.clear();
    EXPECT_EQ(r.notes_left_out(), 0u);
}
