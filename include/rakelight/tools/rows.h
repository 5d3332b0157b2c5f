// SPDX-License-Identifier: Apache-2.0
// The JSON reports of the program. A report has one row per file; a row has the result and remarks, or the error.
// Reports are in UTF-8, with invalid bytes replaced, and end with a line feed.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <rakelight/base/error.h>
#include <rakelight/base/export.h>
#include <rakelight/base/report.h>
#include <rakelight/render/picture.h>
#include <rakelight/tools/bake_files.h>
#include <rakelight/tools/check_scene.h>
#include <rakelight/tools/compare.h>
#include <rakelight/tools/convert_file.h>
#include <rakelight/tools/explain.h>
#include <rakelight/tools/inspect.h>
#include <rakelight/tools/reference.h>
#include <rakelight/tools/smooth_file.h>
#include <rakelight/tools/stages.h>

namespace rakelight {

/// Common members of all rows.
struct ReportRow {
    std::vector<ReportEntry> remarks{};
    /// Report::left_out()
    std::uint64_t remarks_left_out = 0;
    std::optional<Error> error{};
};

/// The position of a picture in a sequence.
struct FrameRow {
    std::int64_t frame = 0;   ///< number of the picture
    double time_s = 0;        ///< [s] time of the clip
    bool is_skipped = false;  ///< the file existed, so the row has only names
};

/// A row of `render --json`.
struct PictureRow : ReportRow {
    PictureResult result{};                      ///< at least `file` and `output`
    std::optional<ReferenceResult> reference{};  ///< if the picture was compared with a reference
    std::optional<FrameRow> frame{};             ///< if the picture belongs to a sequence
    std::size_t movie_pictures = 0;              ///< number of pictures of a movie; 0: the output is a picture
};

/// A row of `check --json`.
struct CheckRow : ReportRow {
    std::string file{};  ///< as it was named
    std::optional<SceneSummary> summary{};
};

/// A row of `inspect --json`.
struct InspectionRow : ReportRow {
    std::string file{};  ///< as it was named
    std::optional<Inspection> inspection{};
    std::optional<std::vector<CheckFailure>> check{};  ///< if limits were checked
    std::string heat_map{};                            ///< the written picture, or empty
};

/// A row of `compare --json`.
struct ComparisonRow : ReportRow {
    std::string a{}, b{};                ///< files or scenes
    std::string engine_a{}, engine_b{};  ///< engines that drew the scenes; empty for picture files
    CompareOptions options{};
    std::optional<PictureComparison> comparison{};
    std::vector<CheckFailure> failures{};  ///< violated limits
    std::string output{};                  ///< the written difference picture or page, or empty
};

/// A row of `explain --json`.
struct ExplainRow : ReportRow {
    std::string file{};  ///< as it was named
    int x = 0, y = 0;    ///< [px] of the pixel
    std::shared_ptr<const ExplainedPixel> pixel{};
};

/// A row of `stages --json`.
struct StagesRow : ReportRow {
    StagesResult result{};  ///< at least `file` and `folder`
};

/// A row of `smooth --json`.
struct SmoothedFileRow : ReportRow {
    std::string file{};  ///< as it was named
    std::optional<SmoothedFile> result{};
};

/// A row of `convert --json`.
struct ConvertedFileRow : ReportRow {
    ConvertedFile result{};  ///< at least `file` and `output`
};

/// A row of `bake --json`.
struct BakeRow : ReportRow {
    BakeFilesResult result{};  ///< at least `high` and `low`
};

/// {"schema": "rakelight.render/1", "rows": [...]}
RL_API std::string to_json(std::span<const PictureRow> rows);
/// {"schema": "rakelight.check/1", "rows": [...]}
RL_API std::string to_json(std::span<const CheckRow> rows);
/// {"schema": "rakelight.inspect/1", "rows": [...]}
RL_API std::string to_json(std::span<const InspectionRow> rows);
/// {"schema": "rakelight.compare/1", "rows": [...]}; numbers that are not finite are null.
RL_API std::string to_json(std::span<const ComparisonRow> rows);
/// {"schema": "rakelight.explain/1", "rows": [...]}; docs/explain.md describes the contents.
RL_API std::string to_json(std::span<const ExplainRow> rows);
/// {"schema": "rakelight.stages/1", "rows": [...]}
RL_API std::string to_json(std::span<const StagesRow> rows);
/// {"schema": "rakelight.smooth/1", "rows": [...]}
RL_API std::string to_json(std::span<const SmoothedFileRow> rows);
/// {"schema": "rakelight.convert/1", "rows": [...]}
RL_API std::string to_json(std::span<const ConvertedFileRow> rows);

/// {"schema": "rakelight.bake/1", "rows": [...]}
RL_API std::string to_json(std::span<const BakeRow> rows);

/// A readable table without the rows that have an error. Empty: there are no other rows.
RL_API std::string to_text(std::span<const ComparisonRow> rows);
/// "NAME", or "NAME (ENGINE)" if the engine is given.
RL_API std::string title_of(const std::string& name, const std::string& engine);

}  // namespace rakelight
