// Settings of parts and regions that a drawing does not have are reported.
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing_files/documents.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <tuple>

using namespace forefront;
using namespace forefront::edit_test;

namespace {

/// Returns true if one finding names all of these.
bool reports(const Diagnostics &findings, const std::string &setting, const std::string &tag) {
    return std::any_of(findings.begin(), findings.end(), [&](const Diagnostic &finding) {
        return finding.code == "unused-setting" && finding.severity == Severity::Warning &&
               finding.message.find(setting) != std::string::npos && finding.message.find(tag) != std::string::npos;
    });
}

Document withUnknownTags() {
    const Result<Document> document = parseProject(R"({"format": "forefront", "version": 2,
        "shapes": [{"id": 1, "kind": "rectangle", "nodes": [[0, 0], [4, 2]]}],
        "boundaryNames": {"7": "quay"}, "spacing": {"size": 0.5, "partSizes": [{"tag": 11, "size": 0.1}]},
        "layers": [{"tag": 7, "first": 0.1}], "periodic": [{"from": 1, "to": 6}], "cracks": [9],
        "strips": [{"tag": 8, "width": 0.1, "rows": 2}], "mapped": [{"region": 4}],
        "regionElements": [{"region": 5, "elements": "quads"}]})",
                                                   "tags.json");
    REQUIRE_MESSAGE(document.ok(), toString(document.faults().front()));
    return *document;
}

} // namespace

TEST_CASE("Part settings: each setting of a part that does not exist is a warning, and the rest is meshed") {
    const Document document = withUnknownTags();
    const MeshingJob job = jobOf(document);
    CHECK(job.findings.size() == 7);
    CHECK(reports(job.findings, "boundary layers", "7 (quay)"));
    CHECK(reports(job.findings, "periodic", "6"));
    CHECK(reports(job.findings, "crack", "9"));
    CHECK(reports(job.findings, "strip", "8"));
    CHECK(reports(job.findings, "mapped region", "4"));
    CHECK(reports(job.findings, "elements of region", "5"));
    CHECK(reports(job.findings, "size", "11"));
    CHECK(meshDomain(job).ok());
}

TEST_CASE("Part settings: readers of projects pass the warnings on, and errors refuse") {
    ImportNotes notes;
    const Document document = withUnknownTags();
    const Result<MeshingJob> job = readJobOf(document, "tags.json", &notes);
    REQUIRE(job.ok());
    CHECK(notes.entries().size() == 7);
    CHECK(notes.entries().front().severity == Severity::Warning);
    CHECK(readJobOf(document, "tags.json", nullptr).ok());

    Document conflict = documentOf({square({0, 0}, 4), square({4, 0}, 4)});
    for (const auto &[shape, segment, size] : {std::tuple{0U, 1U, 0.1}, std::tuple{1U, 3U, 0.2}}) {
        Shape sized = *conflict.shapes[shape];
        sized.segmentSizes[segment].size = size;
        conflict.shapes[shape] = std::make_shared<const Shape>(sized);
    }
    const Result<MeshingJob> refused = readJobOf(conflict, "conflict.json", &notes);
    REQUIRE_FALSE(refused.ok());
    CHECK(refused.faults().front().code == "side-conflict");
    CHECK(refused.faults().front().file == "conflict.json");
}

TEST_CASE("Part settings: what a drawing has is used without a word") {
    Document document = documentOf({square({0, 0}, 4)});
    document.layers = {{.tag = 1, .first = 0.05}};
    document.spacing.partSizes[1] = {0.3, 0.2};
    document.mapped = {{1, {}}}; // the region without a marker
    const MeshingJob job = jobOf(document);
    CHECK(job.findings.empty());
    CHECK(job.layers.size() == 1);
    CHECK(job.mapped.size() == 1);
}
