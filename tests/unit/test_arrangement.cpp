#include "core/arrangement/arrangement.hpp"
#include "core/arrangement/cluster.hpp"
#include "core/arrangement/face_points.hpp"
#include "core/domain/domain_graph.hpp"
#include "core/domain/validate.hpp"
#include "core/geometry/polygon.hpp"
#include "core/geometry/predicates.hpp"
#include "tests/support/random_domains.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <set>

using namespace forefront;
using namespace forefront::testing;

namespace {

std::vector<Vec2> rectangle(double x, double y, double width, double height) {
    return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

/// A feature of one polygon.
void addPolygon(ArrangementInput &input, std::int32_t tag, const std::vector<std::vector<Vec2>> &rings,
                const std::string &name = {}) {
    const std::uint32_t shape = input.addShape(input.addFeature(tag, name));
    for (const std::vector<Vec2> &ring : rings) {
        input.addRing(input.addContour(shape, FillRule::NonZero, &ring != &rings.front()), ring, tag);
    }
}

/// A painted path: all of one feature.
void addPath(ArrangementInput &input, FillRule rule, const std::vector<std::vector<Vec2>> &subpaths) {
    if (input.features.empty()) {
        input.addFeature(1);
    }
    const std::uint32_t contour = input.addContour(input.addShape(0), rule);
    for (const std::vector<Vec2> &subpath : subpaths) {
        input.addRing(contour, subpath, 1);
    }
}

struct FacesOf {
    DomainGraph graph;
    Faces faces;
    FaceLabels labels;
    explicit FacesOf(const Domain &domain) : graph(graphOf(domain)) {
        const PlaneSweepResult sweep = sweepPlane(graph.points, graph.edges);
        REQUIRE(sweep.droppedCount == 0);
        faces = findFaces(graph.points, graph.edges, sweep);
        labels = labelFaces(domain, graph, faces);
    }
};

/// Area inside, by region tag.
std::map<std::int32_t, double> areas(const Domain &domain) {
    const FacesOf of(domain);
    std::map<std::int32_t, double> result;
    for (std::size_t e = 0; e < of.graph.edges.size(); ++e) {
        const double area = 0.5 * cross(of.graph.points[of.graph.edges[e].a], of.graph.points[of.graph.edges[e].b]);
        for (const auto &[face, sign] : {std::pair{of.faces.left[e], 1.0}, {of.faces.right[e], -1.0}}) {
            if (of.labels.inside[face] != 0) {
                result[of.labels.tag[face]] += sign * area;
            }
        }
    }
    return result;
}

Arrangement arranged(ArrangementInput input) {
    input.markRegions = true;
    Result<Arrangement> result = arrange(input);
    REQUIRE(result.ok());
    const Diagnostics faults = validate(result->domain);
    for (const Diagnostic &fault : faults) {
        FAIL_CHECK(toString(fault));
    }
    REQUIRE(result->stretches.size() == result->domain.segments.size());
    REQUIRE(result->nodePiece.size() == result->domain.nodes.size());
    return std::move(*result);
}

const ArrangementChange *find(const Arrangement &arrangement, ChangeKind kind) {
    const auto found = std::find_if(arrangement.changes.begin(), arrangement.changes.end(),
                                    [&](const ArrangementChange &change) { return change.kind == kind; });
    return found != arrangement.changes.end() ? &*found : nullptr;
}

using Areas = std::map<std::int32_t, double>;

} // namespace

TEST_CASE("arrange: a path is filled by its rule") {
    const std::vector<std::vector<Vec2>> squares{rectangle(0, 0, 10, 10), rectangle(2, 2, 6, 6)};
    ArrangementInput nonZero, evenOdd;
    addPath(nonZero, FillRule::NonZero, squares);
    addPath(evenOdd, FillRule::EvenOdd, squares);
    CHECK(areas(arranged(nonZero).domain) == Areas{{1, 100.0}});
    CHECK(arranged(nonZero).domain.segments.size() == 4);
    CHECK(areas(arranged(evenOdd).domain) == Areas{{1, 64.0}});
}

// One pair of features after the other, a search for what lies inside what takes minutes here.
TEST_CASE("arrange: a thousand features inside each other keep an area each") {
    constexpr int kDepth = 1000;
    for (const OverlapRule rule : {OverlapRule::Later, OverlapRule::Smaller}) {
        ArrangementInput input;
        input.overlap = rule;
        for (int i = 0; i < kDepth; ++i) { // every other one turned around, so that neither rule sees them in order
            const double half = i % 2 == 0 ? i + 1.0 : kDepth - i + 1.0;
            addPolygon(input, i + 1, {rectangle(-half, -half, 2.0 * half, 2.0 * half)});
        }
        const Arrangement result = arranged(input);
        CHECK(find(result, ChangeKind::OverlapsDecided) == nullptr);
        const Areas found = areas(result.domain);
        REQUIRE(found.size() == kDepth);
        for (const auto &[tag, area] : found) {
            const int i = tag - 1;
            const double half = i % 2 == 0 ? i + 1.0 : kDepth - i + 1.0;
            CHECK(area == doctest::Approx(4.0 * (half * half - (half - 1.0) * (half - 1.0))));
        }
    }
}

TEST_CASE("arrange: painted paths are united, and where they only touch their border stays") {
    ArrangementInput nested, beside;
    addPath(nested, FillRule::EvenOdd, {rectangle(0, 0, 10, 10)});
    addPath(nested, FillRule::EvenOdd, {rectangle(2, 2, 3, 3)});
    CHECK(areas(arranged(nested).domain) == Areas{{1, 100.0}});
    CHECK(arranged(nested).domain.segments.size() == 4);
    CHECK(find(arranged(nested), ChangeKind::InnerOutlines)->count == 4);
    addPath(beside, FillRule::NonZero, {rectangle(0, 0, 1, 1)});
    addPath(beside, FillRule::NonZero, {rectangle(1, 0, 1, 1)});
    const Arrangement both = arranged(beside);
    CHECK(both.domain.segments.size() == 7);
    CHECK(both.changes.empty());
    CHECK(std::count_if(both.domain.segments.begin(), both.domain.segments.end(),
                        [](const DomainSegment &s) { return s.role == SegmentRole::Constraint; }) == 1);
}

TEST_CASE("arrange: a polygon fills another one's hole, and a hole beside the outline opens it") {
    ArrangementInput covered, flush;
    addPolygon(covered, 1, {rectangle(0, 0, 10, 10), rectangle(4, 4, 2, 2)});
    addPolygon(covered, 1, {rectangle(3, 3, 4, 4)});
    CHECK(areas(arranged(covered).domain)[1] == doctest::Approx(100.0));
    addPolygon(flush, 1, {rectangle(0, 0, 4, 4), {{4, 0}, {4, 4}, {2, 3}, {2, 1}}});
    CHECK(areas(arranged(flush).domain)[1] == doctest::Approx(10.0));
}

TEST_CASE("arrange: where features overlap the later or the smaller one wins, and one inside another keeps its area") {
    ArrangementInput neighbours;
    addPolygon(neighbours, 1, {rectangle(0, 0, 4, 4)}, "A");
    addPolygon(neighbours, 2, {rectangle(3, 1, 3, 2)}, "B");
    const Arrangement later = arranged(neighbours);
    CHECK(areas(later.domain) == Areas{{1, 14.0}, {2, 6.0}});
    const ArrangementChange *overlap = find(later, ChangeKind::OverlapsDecided);
    REQUIRE(overlap != nullptr);
    CHECK(overlap->count == 1);
    CHECK(overlap->displacement == doctest::Approx(2.0));
    CHECK(overlap->between == "A and B");

    ArrangementInput turned;
    addPolygon(turned, 2, {rectangle(3, 1, 3, 2)}, "B");
    addPolygon(turned, 1, {rectangle(0, 0, 4, 4)}, "A");
    CHECK(areas(arranged(turned).domain) == Areas{{1, 16.0}, {2, 4.0}});
    turned.overlap = OverlapRule::Smaller;
    CHECK(areas(arranged(turned).domain) == Areas{{1, 14.0}, {2, 6.0}});

    for (const bool innerFirst : {false, true}) {
        ArrangementInput nest;
        addPolygon(nest, innerFirst ? 2 : 1, {innerFirst ? rectangle(1, 1, 2, 2) : rectangle(0, 0, 4, 4)});
        addPolygon(nest, innerFirst ? 1 : 2, {innerFirst ? rectangle(0, 0, 4, 4) : rectangle(1, 1, 2, 2)});
        CHECK(areas(arranged(nest).domain) == Areas{{1, 12.0}, {2, 4.0}});
        CHECK(arranged(nest).changes.empty());
    }

    ArrangementInput three;
    addPolygon(three, 1, {rectangle(0, 0, 2, 2)});
    addPolygon(three, 2, {rectangle(2, 0, 2, 2)});
    addPolygon(three, 3, {rectangle(1, -1, 2, 2)});
    CHECK(areas(arranged(three).domain) == Areas{{1, 3.0}, {2, 3.0}, {3, 4.0}});
}

TEST_CASE("arrange: overlaps are reported by area, the largest first, at places inside them") {
    ArrangementInput input;
    addPolygon(input, 1, {rectangle(0, 0, 10, 1)}, "A");
    addPolygon(input, 2, {rectangle(1, 0.5, 1, 1)}, "B");
    addPolygon(input, 3, {rectangle(4, 0.5, 4, 1)}, "C");
    const Arrangement result = arranged(input);
    const ArrangementChange *overlap = find(result, ChangeKind::OverlapsDecided);
    REQUIRE(overlap != nullptr);
    CHECK(overlap->count == 2);
    CHECK(overlap->displacement == doctest::Approx(2.5));
    CHECK(overlap->between == "A and C");
    REQUIRE(overlap->places.size() == 2);
    CHECK(Box2{{4, 0.5}, {8, 1}}.contains(overlap->places[0]));
    CHECK(Box2{{1, 0.5}, {2, 1}}.contains(overlap->places[1]));
}

TEST_CASE("arrange: what is valid stays as it is, in its order") {
    ArrangementInput input;
    addPolygon(input, 3, {rectangle(0.1, 0.2, 1.3, 0.7), rectangle(0.3, 0.4, 0.1, 0.2)});
    input.addChain(std::vector<Vec2>{{0.6, 0.4}, {1.1, 0.5}}, 5);
    input.addPoint({0.7, 0.7}, 6);
    input.tolerance = 1e-6;
    const Arrangement result = arranged(input);
    CHECK(result.changes.empty());
    REQUIRE(result.domain.nodes.size() == 11);
    REQUIRE(result.domain.segments.size() == 9);
    for (std::size_t s = 0; s < result.domain.segments.size(); ++s) {
        CHECK(result.domain.nodes[result.domain.segments[s].a] == input.pieces[s].a);
        CHECK(result.domain.nodes[result.domain.segments[s].b] == input.pieces[s].b);
        CHECK(result.domain.segments[s].tag == input.pieces[s].tag);
        CHECK(result.stretches[s].piece == s);
    }
    CHECK(result.domain.segments.back().role == SegmentRole::Constraint);
    CHECK(result.domain.points.size() == 1);
    CHECK(result.domain.points.front().tag == 6);
}

TEST_CASE("arrange: tags and curve parameters survive splitting") {
    ArrangementInput input;
    addPolygon(input, 7, {rectangle(0, 0, 4, 4)});
    input.curves = {Curve::line({0, 0}, {0, 1}), Curve::line({0, 0}, {8, 0})};
    input.pieces[0].stretch = {1, 0.0, 0.5};
    input.addChain(std::vector<Vec2>{{1, -1}, {1, 2}}, 9);
    const Arrangement result = arranged(input);
    CHECK(result.domain.segments.size() == 6);
    CHECK(result.domain.segments[0].tag == 7);
    REQUIRE(result.domain.curves.size() == 1); // without the one that nothing follows
    CHECK(result.domain.curves[0] == input.curves[1]);
    const CurveStretch first = result.domain.segments[0].stretch, second = result.domain.segments[1].stretch;
    CHECK(first.curve == 0);
    CHECK(first.t0 == 0.0);
    CHECK(first.t1 == doctest::Approx(0.125).epsilon(1e-9));
    CHECK(second.curve == 0);
    CHECK(second.t0 == first.t1); // exactly, so that the chain continues
    CHECK(second.t1 == 0.5);
    CHECK_FALSE(result.domain.segments[2].stretch.follows());
    CHECK(result.domain.segments.back().tag == 9);
    const ArrangementChange *outside = find(result, ChangeKind::OutsideLines);
    REQUIRE(outside != nullptr);
    CHECK(outside->count == 1);
    REQUIRE(find(result, ChangeKind::CrossingSegments) != nullptr);
}

TEST_CASE("arrange: slivers thinner than the tolerance collapse, needles vanish") {
    ArrangementInput input;
    addPolygon(input, 1, {rectangle(0, 0, 1, 1)});
    addPolygon(input, 2, {{{1.0005, 0}, {2, 0}, {2, 1}, {1.0004, 1}, {1.0003, 0.5}}});
    addPolygon(input, 3, {{{0, 1}, {0.5, 1.4}, {0.5, 3}, {0.5005, 1.4}, {1, 1}}});
    input.tolerance = 1e-3;
    const Arrangement result = arranged(input);
    CHECK(find(result, ChangeKind::WeldedNodes)->count >= 2);
    CHECK(find(result, ChangeKind::FoldedOutlines) != nullptr);
    for (const ArrangementChange &change : result.changes) {
        CHECK(change.displacement <= 1e-3);
    }
    const Areas found = areas(result.domain);
    CHECK(found.at(1) == doctest::Approx(1.0).epsilon(1e-3));
    CHECK(found.at(2) == doctest::Approx(1.0).epsilon(1e-3));
    CHECK(found.at(3) == doctest::Approx(0.2).epsilon(5e-3));
    CHECK(FacesOf(result.domain).faces.count == 4);
}

TEST_CASE("arrange: an outline that is not closed is refused with its place") {
    ArrangementInput input;
    addPolygon(input, 1, {rectangle(0, 0, 1, 1)});
    input.pieces.pop_back();
    const Result<Arrangement> result = arrange(input);
    REQUIRE_FALSE(result.ok());
    CHECK(result.faults().front().code == "open-contour");
    CHECK(result.faults().front().at == Vec2{0, 1});
}

TEST_CASE("pointInFace: finds room in faces of awkward shape") {
    const std::vector<Vec2> comb{{0, 0}, {10, 0}, {10, 5}, {9, 0.1}, {8, 5}, {7, 0.1}, {6, 5}, {0, 1}};
    std::vector<FaceEdge> edges;
    for (std::size_t k = 0; k < comb.size(); ++k) {
        edges.push_back({comb[k], comb[(k + 1) % comb.size()]});
    }
    const auto at = pointInFace(edges);
    REQUIRE(at.has_value());
    CHECK(locate(comb, *at) == PointPlace::Inside);
    edges.push_back({{at->x, -0.1}, {at->x, 4.9}, true}); // a line through it
    const auto beside = pointInFace(edges);
    REQUIRE(beside.has_value());
    CHECK(beside->x != at->x);
    CHECK(locate(comb, *beside) == PointPlace::Inside);
    CHECK(!pointInFace(std::vector<FaceEdge>{{{0, 0}, {2, 0}}, {{2, 0}, {0, 0}}}));
    CHECK(!pointInFace({}));
}

TEST_CASE("notesOf: one line per kind, with count, displacement and places") {
    const std::vector<ArrangementChange> changes{{ChangeKind::WeldedNodes, 12, 8.3e-7, {{1, 2}, {3, 4}, {5, 6}}, 0, {}},
                                                 {ChangeKind::OverlapsDecided, 1, 2.0, {{1, 1}}, 0, "A and B"}};
    const Diagnostics notes = notesOf(changes);
    REQUIRE(notes.size() == 2);
    CHECK(notes[0].message == "moved 12 nodes onto others, at most 8.3e-07 away");
    CHECK(notes[0].at == Vec2{1, 2});
    CHECK(placesOf(changes[0]) == ", first at (1, 2), (3, 4), (5, 6)");
    CHECK(notes[0].severity == Severity::Note);
    CHECK(notes[1].message == "resolved 1 overlap of features, 2 in area, between A and B");
    CHECK(placesOf(changes[1]) == " at (1, 1)");
}

namespace {

/// Shapes that overlap, touch, coincide and fold, with a tolerance and a scale and place in the plane.
struct RandomDrawing {
    ArrangementInput input;
    double size = 1.0;
    Vec2 offset;

    explicit RandomDrawing(RandomSource &random) {
        constexpr std::array kSizes{1.0, 1e8, 1e-8, 37.0};
        size = kSizes[static_cast<std::size_t>(random.integer(0, 3))];
        offset = random.chance(0.3) ? Vec2{1e5 * size, -3e4 * size} : Vec2{};
        constexpr std::array kTolerances{0.0, 1e-6, 1e-6, 1e-4, 1e-2};
        input.tolerance = size * kTolerances[static_cast<std::size_t>(random.integer(0, 4))];
        const int count = random.integer(1, 7);
        for (int i = 0; i < count; ++i) {
            addShape(random);
        }
    }

    Vec2 place(Vec2 p) const { return offset + size * p; }

    std::vector<Vec2> ring(RandomSource &random) {
        std::vector<Vec2> nodes;
        const Vec2 centre{random.between(0.2, 0.8), random.between(0.2, 0.8)};
        switch (random.integer(0, 4)) {
        case 0: // on a lattice: coincident edges, collinear overlaps
        {
            const int x = random.integer(0, 6), y = random.integer(0, 6);
            for (const Vec2 p : rectangle(x, y, random.integer(1, 4), random.integer(1, 4))) {
                nodes.push_back(place(0.1 * p));
            }
            break;
        }
        case 1: // any polygon, crossing itself
            for (int k = random.integer(3, 9); k > 0; --k) {
                nodes.push_back(place({random.unit(), random.unit()}));
            }
            break;
        case 2: // a circle: tangencies with lattice and circles of the same centre
        {
            const Vec2 middle{0.1 * random.integer(2, 8), 0.1 * random.integer(2, 8)};
            const double radius = 0.1 * random.integer(1, 3);
            const int sides = 4 * random.integer(1, 12);
            for (int k = 0; k < sides; ++k) {
                const double angle = 2.0 * 3.14159265358979324 * k / sides;
                nodes.push_back(place(middle + radius * Vec2{std::cos(angle), std::sin(angle)}));
            }
            break;
        }
        case 3: // a needle
            nodes = {place(centre), place(centre + Vec2{random.between(-0.5, 0.5), random.between(-0.5, 0.5)}),
                     place(centre + Vec2{random.between(-1e-6, 1e-6), random.between(-1e-6, 1e-6)})};
            break;
        default: // an earlier ring again, whole or moved by about the tolerance
            if (earlier.empty()) {
                return ring(random);
            }
            nodes = earlier[static_cast<std::size_t>(random.integer(0, static_cast<int>(earlier.size()) - 1))];
            if (random.chance(0.5)) {
                std::reverse(nodes.begin(), nodes.end());
            }
            if (random.chance(0.5)) {
                for (Vec2 &node : nodes) {
                    node += input.tolerance * Vec2{random.between(-0.4, 0.4), random.between(-0.4, 0.4)};
                }
            }
            break;
        }
        earlier.push_back(nodes);
        return nodes;
    }

    void addShape(RandomSource &random) {
        const auto tag = static_cast<std::int32_t>(input.features.size()) + 1;
        const std::uint32_t shape = input.addShape(input.addFeature(tag));
        if (random.chance(0.5)) {
            const std::uint32_t contour =
                input.addContour(shape, random.chance(0.5) ? FillRule::EvenOdd : FillRule::NonZero);
            for (int k = random.integer(1, 3); k > 0; --k) {
                input.addRing(contour, ring(random), tag);
            }
            return;
        }
        for (int k = random.integer(1, 3), first = k; k > 0; --k) {
            input.addRing(input.addContour(shape, FillRule::NonZero, k != first), ring(random), tag);
        }
    }

    std::vector<std::vector<Vec2>> earlier;
};

/// Winding number of one contour at a place, from its pieces alone.
int windingAt(const ArrangementInput &input, std::uint32_t contour, Vec2 p) {
    int winding = 0;
    for (const ArrangementPiece &piece : input.pieces) {
        if (piece.role == PieceRole::Outline && piece.contour == contour && (piece.a.y <= p.y) != (piece.b.y <= p.y)) {
            const int side = orientation(piece.a, piece.b, p);
            winding += piece.a.y <= p.y ? (side > 0 ? 1 : 0) : (side < 0 ? -1 : 0);
        }
    }
    return winding;
}

/// The features that cover a place.
std::set<std::uint32_t> featuresAt(const ArrangementInput &input, Vec2 p) {
    std::vector<int> outer(input.shapes.size(), 0), hole(input.shapes.size(), 0);
    for (std::uint32_t c = 0; c < input.contours.size(); ++c) {
        const int winding = windingAt(input, c, p);
        const ArrangementContour &contour = input.contours[c];
        const bool inside = contour.rule == FillRule::NonZero ? winding != 0 : winding % 2 != 0;
        (contour.hole ? hole : outer)[contour.shape] += inside ? 1 : 0;
    }
    std::set<std::uint32_t> features;
    for (std::uint32_t s = 0; s < input.shapes.size(); ++s) {
        if (outer[s] > 0 && hole[s] == 0) {
            features.insert(input.shapes[s].feature);
        }
    }
    return features;
}

std::set<std::array<double, 4>> segmentSet(const Domain &domain) {
    std::set<std::array<double, 4>> set;
    for (const DomainSegment &segment : domain.segments) {
        Vec2 a = domain.nodes[segment.a], b = domain.nodes[segment.b];
        if (comesBefore(b, a)) {
            std::swap(a, b);
        }
        set.insert({a.x, a.y, b.x, b.y});
    }
    return set;
}

/// Compares faces and features of the result with winding numbers of the input at places away from all pieces.
void compareAtSamples(RandomSource &random, const RandomDrawing &drawing, const Arrangement &result) {
    const ArrangementInput &input = drawing.input;
    Domain domain = result.domain;
    std::vector<Vec2> samples;
    for (int k = 0; k < 60; ++k) {
        const Vec2 p = drawing.place({random.between(-0.1, 1.1), random.between(-0.1, 1.1)});
        const bool clear = std::all_of(input.pieces.begin(), input.pieces.end(), [&](const ArrangementPiece &piece) {
            return distanceToSegment(piece.a, piece.b, p) > 1.5 * std::max(input.tolerance, 1e-9 * drawing.size);
        });
        if (clear) {
            samples.push_back(p);
        }
    }
    domain.holeMarkers = samples; // only to find their faces
    const FacesOf of(domain);
    for (std::size_t k = 0; k < samples.size(); ++k) {
        CAPTURE(samples[k].x);
        CAPTURE(samples[k].y);
        const std::set<std::uint32_t> features = featuresAt(input, samples[k]);
        const std::uint32_t face = of.faces.ofPoint[of.graph.holeMarker[k]];
        REQUIRE(face != kNoIndex);
        REQUIRE((of.labels.inside[face] != 0) == !features.empty());
        if (!features.empty()) {
            const auto tag = of.labels.tag[face];
            REQUIRE(features.count(static_cast<std::uint32_t>(tag) - 1) == 1);
        }
    }
}

} // namespace

TEST_CASE("arrange: random drawings become valid domains with the area that their winding numbers say") {
    const char *wanted = std::getenv("FOREFRONT_ARRANGEMENTS"); // 2,000 outside of quick runs
    const int runs = wanted != nullptr ? std::atoi(wanted) : 200;
    int meshed = 0;
    for (int run = 0; run < runs; ++run) {
        CAPTURE(run);
        RandomSource random(static_cast<std::uint64_t>(run) + 77);
        const RandomDrawing drawing(random);
        ArrangementInput input = drawing.input;
        input.markRegions = true;
        const Result<Arrangement> result = arrange(input);
        REQUIRE(result.ok());
        if (result->domain.segments.empty()) {
            continue; // needles alone
        }
        ++meshed;
        for (const Diagnostic &fault : validate(result->domain)) {
            FAIL_CHECK(toString(fault));
        }
        for (const ArrangementChange &change : result->changes) {
            if (change.kind != ChangeKind::OverlapsDecided) {
                CHECK(change.displacement <= std::max(input.tolerance * (1.0 + 1e-9), 1e-9 * drawing.size));
            }
        }
        compareAtSamples(random, drawing, *result);

        // The same again from the result's own outlines.
        ArrangementInput again;
        again.tolerance = result->radius;
        const std::uint32_t contour = again.addContour(again.addShape(again.addFeature(1)), FillRule::EvenOdd);
        for (const DomainSegment &segment : result->domain.segments) {
            again.pieces.push_back(
                {result->domain.nodes[segment.a], result->domain.nodes[segment.b], contour, 1,
                 segment.role == SegmentRole::Boundary ? PieceRole::Outline : PieceRole::Constraint});
        }
        const Result<Arrangement> twice = arrange(again);
        REQUIRE(twice.ok());
        CHECK(segmentSet(twice->domain) == segmentSet(result->domain));
        CHECK(twice->changes.empty());

        input.overlap = OverlapRule::Smaller;
        const Result<Arrangement> bySize = arrange(input);
        for (std::size_t i = input.pieces.size(); i > 1; --i) {
            std::swap(input.pieces[i - 1],
                      input.pieces[static_cast<std::size_t>(random.integer(0, static_cast<int>(i) - 1))]);
        }
        const Result<Arrangement> shuffled = arrange(input);
        REQUIRE(shuffled.ok());
        CHECK(segmentSet(shuffled->domain) == segmentSet(bySize->domain));
    }
    CHECK(meshed > runs / 2);
}
