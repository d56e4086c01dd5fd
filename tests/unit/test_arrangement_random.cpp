#include "core/drawing/arrangement/arrangement.hpp"
#include "core/drawing/arrangement/snapping/cluster.hpp"
#include "core/engine/domain/validate.hpp"
#include "core/engine/geometry/polygon.hpp"
#include "core/engine/geometry/predicates.hpp"
#include "tests/support/random_domains.hpp"
#include "tests/unit/arrangement_support.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <set>
#include <utility>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

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

/// Returns the features that cover a place.
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

TEST_CASE("arrange: random drawings become valid domains with the area given by their winding numbers") {
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
