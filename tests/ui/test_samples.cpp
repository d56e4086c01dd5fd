#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/formulas/element_counts.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing_files/documents.hpp"
#include "core/engine/mesh/quality.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/files/files.hpp"
#include "tests/ui/edit_driver.hpp"
#include "ui/platform/assets.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace forefront::test {

namespace {

/// Returns true if the nodes of a polygon are those of a regular one with more than four corners.
bool regular(const Shape &shape) {
    if (shape.kind() != ShapeKind::Polygon || shape.nodes.size() < 5) {
        return false;
    }
    Vec2 centre;
    for (const Vec2 node : shape.nodes) {
        centre += (1.0 / static_cast<double>(shape.nodes.size())) * node;
    }
    const auto differs = [](double a, double b) { return std::fabs(a - b) > 1e-4 * b; };
    const double radius = distance(centre, shape.nodes[0]), side = distance(shape.nodes[0], shape.nodes[1]);
    for (std::size_t k = 0; k < shape.nodes.size(); ++k) {
        const Vec2 next = shape.nodes[(k + 1) % shape.nodes.size()];
        if (differs(distance(centre, shape.nodes[k]), radius) || differs(distance(shape.nodes[k], next), side)) {
            return false;
        }
    }
    return true;
}

void countShape(const Shape &shape, std::map<std::string, int> &counts) {
    ++counts["shape " + std::string(wordOf(shape.kind()))];
    counts["inner line"] += shape.use == ShapeUse::Constraint ? 1 : 0;
    counts["node size"] += static_cast<int>(shape.nodeSizes.size());
    counts["regular polygon"] += regular(shape) ? 1 : 0;
    if (shape.is<PathForm>()) {
        for (const Curve &curve : shape.path().curves) {
            counts["arc"] += curve.kind() == CurveKind::Arc ? 1 : 0;
            counts["cubic"] += curve.kind() == CurveKind::Cubic ? 1 : 0;
        }
    }
}

/// Counts the features of a document that the gallery should show.
void countFeatures(const Document &document, std::map<std::string, int> &counts) {
    for (const auto &shape : document.shapes) {
        countShape(*shape, counts);
    }
    const SpacingSpec &spacing = document.spacing;
    for (const SizeSource &source : spacing.sources) {
        ++counts[source.plane ? "gradient" : "source " + std::string(wordOf(source.shape))];
    }
    for (const MarkedRegion &marker : document.regionMarkers) {
        counts["region size"] += marker.size > 0.0 ? 1 : 0;
        counts["region area"] += marker.maxArea > 0.0 ? 1 : 0;
    }
    counts["paint"] += spacing.paint.tiles.empty() ? 0 : 1;
    counts["expression"] += spacing.expression ? 1 : 0;
    counts["boundary lengths"] += spacing.fromBoundary ? 1 : 0;
    counts["size of a boundary part"] += static_cast<int>(spacing.partSizes.size());
    counts["number of elements"] += static_cast<int>(document.elementCounts.size());
    counts["parameter"] += static_cast<int>(document.parameters.size());
    counts["formula"] += static_cast<int>(document.formulas.size());
    counts["boundary name"] += static_cast<int>(document.boundaryNames.size());
    counts["region name"] += static_cast<int>(document.regionNames.size());
}

Document documentOf(const Sample &sample) {
    Result<Document> document = readDocument(sample.path);
    REQUIRE(document.ok());
    return *std::move(document);
}

/// Meshes a document, and checks the shapes of its elements.
TriMesh goodMesh(const Document &document) {
    Result<MeshingOutcome> outcome = meshDomain({toDomain(document), spacingOf(document), document.options});
    REQUIRE(outcome.ok());
    const MeshQuality quality = measureQuality(outcome->mesh, nullptr);
    CHECK(quality.alphaMean > 0.93);
    CHECK(quality.alphaMin > 0.3);
    return takeTriMesh(std::move(outcome->mesh));
}

} // namespace

TEST_CASE("Samples: together they show every kind of shape, curve, size and name") {
    std::map<std::string, int> counts;
    for (const ShapeKind kind : valuesOf<ShapeKind>()) {
        if (kind != ShapeKind::Point) {
            counts["shape " + std::string(wordOf(kind))] = 0;
        }
    }
    for (const SourceShape shape : valuesOf<SourceShape>()) {
        counts["source " + std::string(wordOf(shape))] = 0;
    }
    counts["gradient"] = 0;
    for (const Sample &sample : sampleDrawings()) {
        CAPTURE(sample.title);
        countFeatures(documentOf(sample), counts);
    }
    for (const auto &entry : counts) {
        CAPTURE(entry.first);
        CHECK(entry.second > 0);
    }
}

TEST_CASE("Samples: the mesh of each has well-shaped elements, and fewer than 20,000") {
    for (const Sample &sample : sampleDrawings()) {
        CAPTURE(sample.title);
        CHECK(goodMesh(documentOf(sample)).elements.size() < 20000);
    }
}

TEST_CASE("Samples: every parameter changes the mesh, which stays valid") {
    std::size_t parameters = 0;
    for (const Sample &sample : sampleDrawings()) {
        CAPTURE(sample.title);
        const Document document = documentOf(sample);
        for (const Parameter &parameter : document.parameters) {
            CAPTURE(parameter.name);
            const auto changed = overrideParameters(document, {{parameter.name, "1.2*(" + parameter.expression + ")"}});
            REQUIRE(changed.ok());
            CHECK(goodMesh(*changed).nodes != goodMesh(document).nodes);
            ++parameters;
        }
    }
    CHECK(parameters >= 8);
}

TEST_CASE("Samples: the holes of the bracket keep 24 elements when a parameter makes them wider") {
    const std::vector<Sample> gallery = sampleDrawings();
    const auto bracket = std::find_if(gallery.begin(), gallery.end(),
                                      [](const Sample &sample) { return sample.path.stem() == "bracket"; });
    REQUIRE(bracket != gallery.end());
    Driver driver;
    driver.context().actions.run("learn.bracket", driver.context());
    driver.settle();
    CHECK(driver.context().document.title() == bracket->title);
    for (const char *hole : {"12", "16"}) {
        const auto document = overrideParameters(*driver.context().document.current(), {{"hole", hole}});
        REQUIRE(document.ok());
        const TriMesh mesh = goodMesh(*document);
        CHECK(std::count_if(mesh.edges.begin(), mesh.edges.end(),
                            [](const TaggedEdge &edge) { return edge.tag == 3; }) == 48);
    }
}

} // namespace forefront::test
