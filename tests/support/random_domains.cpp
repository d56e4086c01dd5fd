#include "tests/support/random_domains.hpp"

#include "core/engine/geometry/plane_sweep.hpp"
#include "tests/support/domain_builder.hpp"

namespace forefront::testing {

namespace {

using std::numbers::pi;

/// Adds a star that fills most of a disc and returns the disc that is free inside it.
Disc addStar(DomainBuilder &builder, RandomSource &random, Disc disc, std::int32_t tag) {
    const int count = random.integer(5, 40);
    const double low = random.between(0.45, 0.9);
    builder.loop(star(random, disc.centre, disc.radius, low, 1.0, count), tag);
    return {disc.centre, innerRadius(disc.radius, low, count)};
}

void starWithHoles(DomainBuilder &builder, RandomSource &random, Disc disc) {
    const Disc inner = addStar(builder, random, disc, 1);
    for (const Disc &hole : scatter(random, inner, random.integer(0, 8), 0.02, random.between(0.05, 0.5))) {
        builder.loop(star(random, hole.centre, hole.radius, random.between(0.2, 0.9), 1.0, random.integer(3, 14)),
                     random.integer(2, 4));
    }
}

void nestedIslands(DomainBuilder &builder, RandomSource &random, Disc disc) {
    for (int depth = random.integer(2, 6); depth > 0 && disc.radius > 0.0; --depth) {
        disc = addStar(builder, random, disc, depth);
        disc.radius *= random.between(0.6, 0.99);
    }
}

void comb(DomainBuilder &builder, RandomSource &random, Disc disc) {
    const int teeth = random.integer(2, 25);
    const double gap = random.chance(0.5) ? random.between(0.2, 0.8) : random.between(0.01, 0.05);
    const double turn = random.chance(0.3) ? 0.0 : random.between(0.0, 6.28), cosine = std::cos(turn);
    const double pitch = 1.3 * disc.radius / teeth, length = random.between(0.1, 1.2) * disc.radius;
    const Vec2 corner{-0.65 * disc.radius, -0.65 * disc.radius};
    std::vector<Vec2> outline{corner + Vec2{pitch * teeth, 0.0}};
    const double root = 0.1 * disc.radius;
    for (int i = teeth; i-- > 0;) { // up and down each tooth, from right to left
        const double left = pitch * (i + 0.5 * gap), right = pitch * (i + 1.0 - 0.5 * gap);
        const double top = root + length * random.between(0.5, 1.0);
        for (const Vec2 p : {Vec2{right, root}, {right, top}, {left, top}, {left, root}}) {
            outline.push_back(corner + p);
        }
    }
    outline.push_back(corner);
    for (Vec2 &p : outline) {
        p = disc.centre + Vec2{cosine * p.x - std::sin(turn) * p.y, std::sin(turn) * p.x + cosine * p.y};
    }
    builder.loop(outline, 1);
}

void spiral(DomainBuilder &builder, RandomSource &random, Disc disc) {
    const double turns = random.between(0.8, 5.0), start = random.between(0.05, 0.3);
    const double width = random.chance(0.5) ? random.between(0.3, 0.8) : random.between(0.02, 0.1);
    const int count = static_cast<int>(turns * random.integer(8, 24));
    // Radius start + (1 - start)·angle/(turns + 1): the band reaches `width` of the way to its next turn.
    const double phase = random.between(0.0, 6.28), step = (1.0 - start) / (turns + 1.0);
    const auto at = [&](int i, double shift) {
        const double angle = turns * i / count;
        return polar(disc.centre, disc.radius * (start + step * (angle + shift)), phase + 2.0 * pi * angle);
    };
    std::vector<Vec2> outline;
    for (int i = 0; i <= count; ++i) {
        outline.push_back(at(i, width));
    }
    for (int i = count; i >= 0; --i) {
        outline.push_back(at(i, 0.0));
    }
    builder.loop(outline, random.integer(1, 3));
}

void spikes(DomainBuilder &builder, RandomSource &random, Disc disc) {
    const int count = random.integer(3, 24);
    const double thin = std::pow(10.0, random.between(-3.5, -0.4));
    std::vector<Vec2> outline;
    for (int i = 0; i < count; ++i) {
        const double angle = 2.0 * pi * i / count, half = thin * pi / count;
        const double tip = random.chance(0.5) ? random.between(0.7, 1.0) : random.between(0.05, 0.4);
        outline.push_back(polar(disc.centre, 0.55 * disc.radius, angle - half));
        outline.push_back(polar(disc.centre, tip * disc.radius, angle + half * random.between(-0.9, 0.9)));
        outline.push_back(polar(disc.centre, 0.55 * disc.radius, angle + half));
    }
    builder.loop(outline, 1);
}

void sizeRatio(DomainBuilder &builder, RandomSource &random, Disc disc) {
    const Disc inner = addStar(builder, random, disc, 1);
    const double tiny = 1e-4 * disc.radius;
    const std::vector<Disc> places = scatter(random, inner, 3, 0.1, 0.3);
    for (std::size_t i = 0; i < places.size(); ++i) {
        const double size = i == 0 ? tiny : tiny * std::pow(10.0, random.between(0.0, 3.0));
        const Vec2 centre = places[i].centre;
        builder.loop(star(random, centre, size, 0.6, 1.0, random.integer(3, 12)), 2);
        if (random.chance(0.5)) { // a second hole very close to it
            builder.loop(star(random, centre + Vec2{2.0 * size + tiny, 0.0}, size, 0.8, 1.0, random.integer(4, 9)), 3);
        }
    }
}

void severalOutlines(DomainBuilder &builder, RandomSource &random, Disc disc) {
    const std::vector<Disc> parts = scatter(random, disc, random.integer(2, 6), 0.05, 0.4);
    for (const Disc &part : parts) {
        switch (random.integer(0, 3)) {
        case 0:
            starWithHoles(builder, random, part);
            break;
        case 1:
            comb(builder, random, {part.centre, 0.9 * part.radius / std::sqrt(2.0)});
            break;
        case 2:
            nestedIslands(builder, random, part);
            break;
        default: { // a fan of triangles that touch in its middle
            const int blades = random.integer(2, 6);
            const std::uint32_t hub = builder.node(part.centre);
            for (int i = 0; i < blades; ++i) {
                const double angle = 2.0 * pi * i / blades;
                const std::uint32_t a = builder.node(polar(part.centre, part.radius, angle));
                const std::uint32_t b =
                    builder.node(polar(part.centre, part.radius, angle + 0.6 * 2.0 * pi / (blades + 1)));
                builder.join({hub, a, b}, true, 1 + i % 3);
            }
        }
        }
    }
}

/// Polylines that start in the middle of the disc and stay in it: a straight, bent or branched one.
void addPolylines(DomainBuilder &builder, RandomSource &random, Disc disc) {
    const std::uint32_t hub = builder.node(disc.centre);
    const int branches = random.integer(1, 4);
    for (int i = 0; i < branches; ++i) {
        std::vector<std::uint32_t> chain{hub};
        const int length = random.integer(1, 4);
        for (int k = 1; k <= length; ++k) { // each branch stays in its sector
            const double angle = 2.0 * pi * (i + random.between(0.0, 0.7)) / branches / (branches == 1 ? 3.0 : 1.0);
            chain.push_back(builder.node(polar(disc.centre, disc.radius * k / length, angle)));
        }
        builder.join(chain, false, random.integer(5, 7), SegmentRole::Constraint);
    }
}

void constraints(DomainBuilder &builder, RandomSource &random, Disc disc) {
    const int count = random.integer(6, 40);
    const auto outline = builder.loop(star(random, disc.centre, disc.radius, 0.5, 1.0, count), 1);
    const double ring = innerRadius(disc.radius, 0.5, count); // > 0 from 6 nodes on
    if (random.chance(0.7)) {                                 // from a boundary node straight inwards
        const std::uint32_t from = outline[static_cast<std::size_t>(random.integer(0, count - 1))];
        const Vec2 arm = builder.domain.nodes[from] - disc.centre;
        const Vec2 to = disc.centre + (0.8 * ring / length(arm)) * arm;
        builder.segment(from, builder.node(to), 4, SegmentRole::Constraint);
    }
    for (const Disc &place : scatter(random, {disc.centre, 0.78 * ring}, random.integer(1, 7), 0.02, 0.4)) {
        switch (random.integer(0, 3)) {
        case 0:
            addPolylines(builder, random, place);
            break;
        case 1:
            builder.domain.points.push_back({builder.node(place.centre), random.integer(1, 3)});
            break;
        case 2:
            builder.loop(star(random, place.centre, place.radius, 0.6, 1.0, random.integer(5, 12)), 3);
            break;
        default: {
            const bool crossed = random.chance(0.5);
            const auto loop = builder.loop(star(random, place.centre, place.radius, 0.6, 1.0, random.integer(5, 12)), 5,
                                           SegmentRole::Constraint);
            if (crossed) { // spokes to the middle divide it
                const std::uint32_t hub = builder.node(place.centre);
                for (std::size_t i = 0; i < loop.size(); i += 2) {
                    builder.segment(hub, loop[i], 6, SegmentRole::Constraint);
                }
            } else {
                builder.domain.regionMarkers.push_back({place.centre, random.integer(2, 5)});
            }
        }
        }
    }
}

void lattice(DomainBuilder &builder, RandomSource &random, Disc disc) {
    const int columns = random.integer(1, 12), rows = random.integer(1, 12);
    const double density = random.between(0.3, 1.0);
    std::vector<std::uint8_t> filled(static_cast<std::size_t>((columns + 2) * (rows + 2)), 0);
    const auto cell = [&](int i, int j) -> std::uint8_t & {
        return filled[static_cast<std::size_t>((j + 1) * (columns + 2) + i + 1)];
    };
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            cell(i, j) = random.chance(density) ? 1 : 0;
        }
    }
    cell(0, 0) = 1;
    const Vec2 pitch{std::ldexp(disc.radius, -3), std::ldexp(disc.radius, random.integer(-6, -3))};
    std::vector<std::uint32_t> nodes(static_cast<std::size_t>((columns + 1) * (rows + 1)), 0xffffffffU);
    const auto nodeAt = [&](int i, int j) {
        std::uint32_t &id = nodes[static_cast<std::size_t>(j * (columns + 1) + i)];
        return id != 0xffffffffU ? id : id = builder.node(disc.centre + Vec2{pitch.x * i, pitch.y * j});
    };
    for (int j = 0; j <= rows; ++j) {
        for (int i = 0; i <= columns; ++i) {
            if (cell(i, j) != cell(i, j - 1)) {
                builder.segment(nodeAt(i, j), nodeAt(i + 1, j), 1);
            }
            if (cell(i, j) != cell(i - 1, j)) {
                builder.segment(nodeAt(i, j), nodeAt(i, j + 1), 2);
            }
        }
    }
    if (random.chance(0.5)) {
        builder.domain.regionMarkers.push_back({disc.centre + 0.5 * pitch, 3});
    }
}

void build(DomainBuilder &builder, RandomSource &random, DomainFamily family) {
    const Disc disc{{0.0, 0.0}, std::pow(10.0, random.integer(-2, 2))};
    switch (family) {
    case DomainFamily::StarWithHoles:
        return starWithHoles(builder, random, disc);
    case DomainFamily::NestedIslands:
        return nestedIslands(builder, random, disc);
    case DomainFamily::Comb:
        return comb(builder, random, disc);
    case DomainFamily::Spiral:
        return spiral(builder, random, disc);
    case DomainFamily::Spikes:
        return spikes(builder, random, disc);
    case DomainFamily::SizeRatio:
        return sizeRatio(builder, random, disc);
    case DomainFamily::FarAway: {
        build(builder, random, static_cast<DomainFamily>(random.integer(0, 5)));
        const double away = 1e5 * std::pow(10.0, random.integer(0, 2));
        for (Vec2 &p : builder.domain.nodes) {
            p += Vec2{away, -3.0 * away};
        }
        return;
    }
    case DomainFamily::Constraints:
        return constraints(builder, random, disc);
    case DomainFamily::SeveralOutlines:
        return severalOutlines(builder, random, disc);
    case DomainFamily::Lattice:
        return lattice(builder, random, disc);
    }
}

void shuffle(Domain &domain, RandomSource &random) {
    for (std::size_t i = domain.segments.size(); i > 1; --i) {
        const auto k = static_cast<std::size_t>(random.integer(0, static_cast<int>(i - 1)));
        std::swap(domain.segments[i - 1], domain.segments[k]);
        if (random.chance(0.3)) {
            std::swap(domain.segments[i - 1].a, domain.segments[i - 1].b);
        }
    }
}

/// Rounding far from the origin can make thin parts collapse; such a domain is not used.
bool isSimple(const Domain &domain) {
    std::vector<PlaneEdge> edges;
    for (const DomainSegment &segment : domain.segments) {
        edges.push_back({segment.a, segment.b});
    }
    const PlaneSweepResult sweep = sweepPlane(domain.nodes, edges);
    bool simple = sweep.droppedCount == 0 && sweep.order.size() == domain.nodes.size();
    for (const ConstraintPoint &point : domain.points) {
        simple = simple && sweep.on[point.node] == 0xffffffffU;
    }
    return simple;
}

} // namespace

const char *nameOf(DomainFamily family) {
    static constexpr const char *kNames[] = {"star with holes",  "nested islands", "comb",     "spiral",
                                             "spikes",           "size ratio",     "far away", "constraints",
                                             "several outlines", "lattice"};
    return kNames[static_cast<std::size_t>(family)];
}

Domain randomDomain(DomainFamily family, std::uint64_t seed) {
    RandomSource random(seed * kDomainFamilies + static_cast<std::uint64_t>(family));
    for (;;) {
        DomainBuilder builder;
        build(builder, random, family);
        shuffle(builder.domain, random);
        if (!builder.domain.segments.empty() && isSimple(builder.domain)) {
            return std::move(builder.domain);
        }
    }
}

Domain randomDomain(std::uint64_t seed) {
    return randomDomain(static_cast<DomainFamily>(seed % kDomainFamilies), seed / kDomainFamilies);
}

} // namespace forefront::testing
