#include "core/drawing/document/equality.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/engine/domain/add_loop.hpp"
#include "core/engine/mesh/placed_cell.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/engine/strips/widened_domain.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <span>
#include <string>

using namespace forefront;

namespace strip_cases {

/// Adds a line with a tag through some places, closed if the last is the first.
void addLine(Domain &domain, const std::vector<Vec2> &places, std::int32_t tag,
             SegmentRole role = SegmentRole::Constraint) {
    const auto nodeAt = [&](Vec2 p) {
        const auto found = std::ranges::find(domain.nodes, p);
        if (found == domain.nodes.end()) {
            domain.nodes.push_back(p);
            return static_cast<std::uint32_t>(domain.nodes.size() - 1);
        }
        return static_cast<std::uint32_t>(found - domain.nodes.begin());
    };
    for (std::size_t k = 0; k + 1 < places.size(); ++k) {
        const std::uint32_t a = nodeAt(places[k]), b = nodeAt(places[k + 1]);
        domain.segments.push_back({a, b, tag, role, {}});
    }
}

/// A square of 10 by 10 with a line of tag 2, and a strip along it.
MeshingJob withLine(const std::vector<Vec2> &places, double width = 0.6, std::uint32_t rows = 2) {
    MeshingJob job;
    addLine(job.domain, {{0, 0}, {5, 0}, {10, 0}, {10, 5}, {10, 10}, {0, 10}, {0, 5}, {0, 0}}, 1,
            SegmentRole::Boundary);
    addLine(job.domain, places, 2);
    job.domain.boundaryNames = {{2, "wall"}};
    job.spacing.size = 1.0;
    job.strips = {{2, width, rows}};
    job.options.verify = true;
    return job;
}

MeshingOutcome stripMesh(const MeshingJob &job) {
    Result<MeshingOutcome> outcome = meshDomain(job);
    REQUIRE_MESSAGE(outcome, toString(outcome ? Diagnostic() : outcome.faults().front()));
    return *std::move(outcome);
}

/// The elements of a region.
struct RegionFigures {
    std::size_t quads = 0, triangles = 0;
    double area = 0.0;
};

RegionFigures figuresOf(const Mesh &mesh, std::int32_t region) {
    RegionFigures figures;
    const MeshView view(mesh);
    for (std::size_t e = 0; e < view.elementCount(); ++e) {
        if (view.region(e) != region) {
            continue;
        }
        const PlacedCell cell(view, e);
        const std::span<const Vec2> corners = cell.corners();
        ++(corners.size() == 4 ? figures.quads : figures.triangles);
        for (std::size_t k = 0; k < corners.size(); ++k) {
            figures.area += 0.5 * cross(corners[k], corners[(k + 1) % corners.size()]);
        }
    }
    return figures;
}

/// Returns the fault of a job, which must have a place.
std::string refusal(const MeshingJob &job) {
    const Result<MeshingOutcome> outcome = meshDomain(job);
    if (outcome) {
        return "";
    }
    CHECK(outcome.faults().front().at.has_value());
    CHECK(outcome.faults().front().message.find("wall") != std::string::npos);
    return outcome.faults().front().code;
}

} // namespace strip_cases

using namespace strip_cases;

TEST_CASE("Strips: rows along a line inside the domain, with flat ends and mitres") {
    const MeshingJob job = withLine({{2, 2}, {8, 2}, {8, 7}}, 0.6, 3);
    const Mesh mesh = stripMesh(job).mesh;
    const RegionFigures strip = figuresOf(mesh, 2);
    CHECK(mesh.regionNames.at(2) == "wall");
    CHECK(strip.triangles == 0);
    CHECK(strip.quads >= 3 * 11);
    CHECK(strip.quads % 3 == 0);
    CHECK(strip.area == doctest::Approx(0.6 * 11).epsilon(1e-12)); // of a strip with a mitre
    CHECK(figuresOf(mesh, 1).area == doctest::Approx(100 - 6.6).epsilon(1e-12));
    std::size_t sides = 0;
    for (const TaggedEdge &edge : mesh.edges) {
        sides += edge.tag == 2 ? 1 : 0;
    }
    CHECK(sides == 2 * strip.quads / 3 + 2 * 3);
}

TEST_CASE("Strips: triangles, quadrilaterals around them, second order, a region of choice") {
    MeshingJob job = withLine({{2, 2}, {8, 3}});
    job.strips.front().cells = LayerCells::Triangles;
    CHECK(figuresOf(stripMesh(job).mesh, 2).quads == 0);
    CHECK(figuresOf(stripMesh(job).mesh, 2).triangles % 4 == 0);
    job.strips.front().cells = LayerCells::Quads;
    job.strips.front().region = 7;
    job.options.order = ElementOrder::Second;
    for (const Elements elements : {Elements::Triangles, Elements::Quads, Elements::Mixed}) {
        job.options.elements = elements;
        const Mesh mesh = stripMesh(job).mesh;
        CHECK(figuresOf(mesh, 7).quads > 0);
        CHECK(figuresOf(mesh, 7).triangles == 0);
        if (elements == Elements::Quads) {
            CHECK(figuresOf(mesh, 1).triangles == 0);
        }
    }
}

TEST_CASE("Strips: a number of elements of the line counts on both sides, with its bias") {
    MeshingJob job = withLine({{2, 2}, {8, 2}, {8, 7}}, 0.6, 2);
    job.spacing.placed.elements.assign(job.domain.segments.size(), 0);
    job.spacing.placed.biases.resize(job.domain.segments.size());
    job.spacing.placed.elements[7] = 13;
    job.spacing.placed.biases[7].ratio = 4.0;
    job.spacing.placed.elements[8] = 4;
    const Mesh mesh = stripMesh(job).mesh;
    CHECK(figuresOf(mesh, 2).quads == 2 * 17);
    double shortest = 10.0, longest = 0.0;
    for (const TaggedEdge &edge : mesh.edges) {
        const Vec2 a = mesh.nodes[index(edge.a)], b = mesh.nodes[index(edge.b)];
        if (edge.tag == 2 && a.y == b.y && a.y == doctest::Approx(1.7)) {
            shortest = std::min(shortest, distance(a, b));
            longest = std::max(longest, distance(a, b));
        }
    }
    CHECK(longest / shortest == doctest::Approx(4.0).epsilon(1e-6));
}

TEST_CASE("Strips: ends on the boundary, at its corners and on other lines") {
    // On straight parts, whose node in the middle is left out; obliquely; at a corner with two rows.
    for (const std::uint32_t rows : {1U, 2U, 3U}) {
        const Mesh across = stripMesh(withLine({{5, 0}, {0, 5}}, 0.6, rows)).mesh;
        CHECK(figuresOf(across, 2).area == doctest::Approx(0.6 * std::sqrt(50.0)).epsilon(1e-12));
    }
    CHECK(figuresOf(stripMesh(withLine({{5, 0}, {4, 4}, {10, 5}}, 0.5, 3)).mesh, 2).area ==
          doctest::Approx(0.5 * (std::sqrt(17.0) + std::sqrt(37.0))).epsilon(0.01));
    CHECK(figuresOf(stripMesh(withLine({{0, 0}, {6, 6}})).mesh, 2).area ==
          doctest::Approx(0.6 * std::sqrt(72.0) - 0.09).epsilon(1e-12));
    CHECK(refusal(withLine({{0, 0}, {6, 6}}, 0.6, 1)) == "strip-end");
    // On another line, whose part in the end has the rows on both sides; and beside a line that goes on from its end.
    MeshingJob between = withLine({{3, 4}, {3, 8}}, 0.6, 3);
    addLine(between.domain, {{1, 4}, {3, 4}, {6, 4}}, 3);
    CHECK(figuresOf(stripMesh(between).mesh, 2).area == doctest::Approx(0.6 * 4).epsilon(1e-12));
    MeshingJob onward = withLine({{3, 4}, {3, 8}}, 0.6, 2);
    addLine(onward.domain, {{3, 4}, {3, 1}}, 3);
    CHECK(figuresOf(stripMesh(onward).mesh, 2).quads > 0);
    onward.strips.front().rows = 3;
    CHECK(refusal(onward) == "strip-end");
}

TEST_CASE("Strips: closed lines and curves") {
    const std::vector<Vec2> ring = {{3, 3}, {7, 3}, {7, 7}, {3, 7}, {3, 3}};
    CHECK(figuresOf(stripMesh(withLine(ring, 0.5, 2)).mesh, 2).area == doctest::Approx(0.5 * 16).epsilon(1e-12));
    MeshingJob circle = withLine({});
    Domain &domain = circle.domain;
    domain.curves.push_back(Curve::circle({5, 5}, {8, 5}));
    domain.curves.push_back(Curve::cubic({1, 0.8}, {3, 0.8}, {3, 1.6}, {5, 0.8}));
    const auto addCurve = [&](std::uint32_t curve, std::uint32_t chords, bool closed) {
        const auto first = static_cast<std::uint32_t>(domain.nodes.size());
        for (std::uint32_t k = 0; k < chords + (closed ? 0 : 1); ++k) {
            domain.nodes.push_back(domain.curves[curve].point(k / static_cast<double>(chords)));
        }
        for (std::uint32_t k = 0; k < chords; ++k) {
            domain.segments.push_back(
                {first + k,
                 closed && k + 1 == chords ? first : first + k + 1,
                 2,
                 SegmentRole::Constraint,
                 {curve, k / static_cast<double>(chords), (k + 1) / static_cast<double>(chords)}});
        }
    };
    addCurve(0, 48, true);
    addCurve(1, 24, false);
    circle.spacing.size = 0.3;
    for (const std::uint32_t rows : {1U, 3U}) {
        circle.strips.front().rows = rows;
        const MeshingOutcome made = stripMesh(circle);
        const double length = 6 * std::numbers::pi + domain.curves[1].length();
        CHECK(figuresOf(made.mesh, 2).area == doctest::Approx(0.6 * length).epsilon(0.003));
        for (const TaggedEdge &edge : made.mesh.edges) { // the sides follow parallels
            const Vec2 p = made.mesh.nodes[index(edge.a)];
            const double r = distance(p, {5, 5});
            if (edge.tag == 2 && p.y > 1.65) {
                CHECK(std::abs(std::abs(r - 3.0) - 0.3) < 1e-9);
            }
        }
    }
    circle.strips.front().width = 6.5;
    CHECK(refusal(circle) == "strip-bend");
}

TEST_CASE("Strips: what they cannot do is refused with the line and the place") {
    CHECK(refusal(withLine({{2, 2}, {8, 2}, {2, 2.3}})) == "strip-bend");                    // too sharp
    CHECK(refusal(withLine({{2, 2}, {2.2, 2.1}, {2.2, 8}, {2.3, 9}}, 0.9)) == "strip-bend"); // too short
    CHECK(refusal(withLine({{2, 2}, {8, 2}, {8, 8}, {5, 8}, {5, 2.2}})) == "strip-room");
    CHECK(refusal(withLine({{2, 2}, {8, 2}}, 4.5)) == "strip-room");
    CHECK(refusal(withLine({{5, 0}, {9, 0.5}})) == "strip-end"); // too oblique
    CHECK(refusal(withLine({{5, 0}, {5, 9}}, 11.0)) == "strip-end");
    MeshingJob crossed = withLine({{2, 2}, {5, 5}, {8, 8}});
    addLine(crossed.domain, {{5, 5}, {8, 2}}, 3);
    CHECK(refusal(crossed) == "strip-meets");
    MeshingJob two = withLine({{2, 2}, {5, 5}});
    addLine(two.domain, {{5, 5}, {8, 2}}, 3);
    two.strips.push_back({3, 0.4, 2});
    CHECK(refusal(two) == "strip-meets");
    MeshingJob inside = withLine({{2, 2}, {8, 2}});
    inside.domain.nodes.push_back({5, 2.1});
    inside.domain.points.push_back({static_cast<std::uint32_t>(inside.domain.nodes.size() - 1), 5});
    CHECK(refusal(inside) == "strip-room");
    MeshingJob marked = withLine({{2, 2}, {8, 2}});
    marked.domain.regionMarkers.push_back({{5, 2.1}, 4});
    CHECK(refusal(marked) == "strip-room");
    MeshingJob edge = withLine({{2, 2}, {8, 2}});
    edge.domain.boundaryNames[1] = "wall";
    edge.strips = {{1, 0.2, 1}};
    CHECK(refusal(edge) == "strip-outside");
}

TEST_CASE("Strips: wrong numbers and what they cannot be had with") {
    MeshingJob job = withLine({{2, 2}, {8, 2}});
    const auto code = [&](const StripSpec &spec) {
        MeshingJob other = job;
        other.strips = {spec};
        const Result<MeshingOutcome> outcome = meshDomain(other);
        return outcome ? std::string() : outcome.faults().front().code;
    };
    CHECK(code({9, 0.5, 1}) == "unknown-boundary");
    CHECK(code({2, 0.0, 1}) == "bad-strip");
    CHECK(code({2, std::nan(""), 1}) == "bad-strip");
    CHECK(code({2, 0.5, 0}) == "bad-strip");
    CHECK(code({2, 0.5, kMaxStripRows + 1}) == "bad-strip");
    CHECK(code({2, 0.5, 1, LayerCells::Quads, -1}) == "bad-strip");
    const auto refused = [&](const auto &change) {
        MeshingJob other = job;
        change(other);
        const Result<MeshingOutcome> outcome = meshDomain(other);
        return outcome ? std::string() : outcome.faults().front().code;
    };
    CHECK(refused([](MeshingJob &other) { other.strips.push_back(other.strips.front()); }) == "repeated-strip");
    CHECK(refused([](MeshingJob &other) { other.cracks = {2}; }) == "strip-line");
    CHECK(refused([](MeshingJob &other) { other.layers = {{1, 0.1}}; }) == "strip-layers");
    CHECK(refused([](MeshingJob &other) { other.options.keepBoundary = true; }) == "strip-boundary");
    CHECK(refused([](MeshingJob &other) { other.options.leastAngle = 20.0; }) == "least-angle");
    CHECK(refused([](MeshingJob &other) { other.options.maxElements = 20; }) == "too-many-elements");
}

TEST_CASE("Strips: the automatic spacing does not see their width, the front does see their ends") {
    MeshingJob job = withLine({{3, 5}, {7, 5}}, 0.04, 2);
    job.spacing = {};
    const std::size_t with = stripMesh(job).mesh.elementCount();
    job.strips.clear();
    const std::size_t without = stripMesh(job).mesh.elementCount();
    CHECK(with > without);
    CHECK(with < 3 * without + 1500);
}

TEST_CASE("Strips: random polylines verify, or are refused with their place") {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(0.0, 1.0);
    int made = 0;
    for (int round = 0; round < 60; ++round) {
        std::vector<Vec2> places;
        Vec2 at{1.5 + number(random), 1.5 + 7 * number(random)};
        for (int k = 0; k < 2 + round % 4; ++k) {
            places.push_back(at);
            at = {at.x + 0.8 + number(random), std::clamp(at.y + 3.0 * number(random) - 1.5, 0.8, 9.2)};
        }
        if (round % 3 == 0) {
            places.front() = {0, 5};
        }
        MeshingJob job = withLine(places, 0.2 + 0.5 * number(random), 1 + round % 4);
        job.options.elements = round % 2 == 0 ? Elements::Triangles : Elements::Quads;
        const Result<MeshingOutcome> outcome = meshDomain(job);
        if (outcome) {
            ++made;
            CHECK(figuresOf(outcome->mesh, 2).quads % job.strips.front().rows == 0);
        } else {
            CAPTURE(toString(outcome.faults().front()));
            CHECK(outcome.faults().front().code.starts_with("strip-"));
            CHECK(outcome.faults().front().at.has_value());
        }
    }
    CHECK(made > 30);
}

TEST_CASE("Project: strips are kept, and given to the job where their lines exist") {
    const auto project = [](const std::string &strips) {
        return parseProject(R"({"format": "forefront", "version": 1, "shapes": [
            {"id": 1, "kind": "rectangle", "use": "boundary", "tag": 1, "name": "", "nodes": [[0, 0], [8, 6]]},
            {"id": 2, "kind": "polyline", "use": "constraint", "tag": 2, "name": "", "nodes": [[2, 3], [6, 3]]}],
            "strips": )" + strips +
                                R"(, "nextId": 3})",
                            "strips.json");
    };
    const Result<Document> document = project(
        R"([{"tag": 2, "width": 0.5, "rows": 3, "type": "triangles", "region": 8}, {"tag": 9, "width": 1, "rows": 1}])");
    REQUIRE_MESSAGE(document, toString(document ? Diagnostic() : document.faults().front()));
    REQUIRE(document->strips.size() == 2);
    const Result<Document> again = parseProject(projectText(*document), "again.json");
    REQUIRE(again);
    CHECK(sameContent(*again, *document));
    Document other = *document;
    other.strips[0].width = 0.25;
    CHECK_FALSE(sameContent(other, *document));
    CHECK(jobOf(*document).strips.size() == 1);
    CHECK(figuresOf(stripMesh(jobOf(*document)).mesh, 8).triangles > 0);
    for (const char *const wrong :
         {"{}", "[4]", "[{}]", R"([{"tag": 2, "width": 0, "rows": 1}])", R"([{"tag": 2, "width": 1, "rows": 0}])",
          R"([{"tag": 2, "width": 1, "rows": 1}, {"tag": 2, "width": 1, "rows": 1}])",
          R"([{"tag": 2, "width": 1e999, "rows": 1}])", R"([{"tag": 2, "width": 1, "rows": 1, "type": "hexes"}])"}) {
        CHECK_FALSE(project(wrong));
    }
}
