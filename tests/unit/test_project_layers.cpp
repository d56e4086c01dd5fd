#include "core/drawing/document/equality.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing_files/project/project.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace forefront;

namespace layer_project_cases {

Result<Document> projectWith(const std::string &layers) {
    return parseProject(R"({"format": "forefront", "version": 1, "shapes": [
        {"id": 1, "kind": "rectangle", "use": "boundary", "tag": 3, "name": "", "nodes": [[0, 0], [4, 3]]}],
        "layers": )" + layers +
                            R"(, "nextId": 2})",
                        "layers.json");
}

std::string codeOf(const std::string &layers) {
    const Result<Document> document = projectWith(layers);
    return document ? std::string() : document.faults().front().code;
}

} // namespace layer_project_cases

using namespace layer_project_cases;

TEST_CASE("Project: boundary layers are kept, and given to the job where their part exists") {
    const Result<Document> document =
        projectWith(R"([{"tag": 3, "first": 0.01, "growth": 1.5, "count": 7, "type": "triangles"},
                        {"tag": 9, "first": 0.001, "thickness": 0.5}])");
    REQUIRE(document);
    REQUIRE(document->layers.size() == 2);
    CHECK(document->layers[0].first == 0.01);
    CHECK(document->layers[0].growth == 1.5);
    CHECK(document->layers[0].count == 7);
    CHECK(document->layers[0].cells == LayerCells::Triangles);
    CHECK(document->layers[1].growth == 1.2);
    CHECK(document->layers[1].thickness == 0.5);
    const Result<Document> again = parseProject(projectText(*document), "again.json");
    REQUIRE(again);
    CHECK(again->layers == document->layers);
    CHECK(sameContent(*again, *document));
    Document other = *document;
    other.layers.pop_back();
    CHECK_FALSE(sameContent(other, *document));
    const MeshingJob job = jobOf(*document);
    REQUIRE(job.layers.size() == 1);
    CHECK(job.layers[0] == document->layers[0]);
}

TEST_CASE("Project: invalid boundary layers are refused with their place") {
    CHECK(codeOf(R"([{"tag": 3, "first": 0.01, "count": 7}])").empty());
    CHECK(codeOf(R"([{"tag": 3, "first": 0.01, "count": 7, "thickness": 1}])") == "bad-layer");
    CHECK(codeOf(R"([{"tag": 3, "first": 0.01, "growth": 9}])") == "bad-layer");
    CHECK(codeOf(R"([{"tag": 3, "first": 0.01}, {"tag": 3, "first": 0.02}])") == "bad-tag");
    CHECK_FALSE(codeOf(R"([{"tag": 3}])").empty());
    CHECK_FALSE(codeOf(R"([{"tag": 3, "first": 0.01, "type": "hexes"}])").empty());
    CHECK_FALSE(codeOf(R"({})").empty());
}
