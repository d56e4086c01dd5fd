#include "core/engine/improve/cutout.hpp"
#include "core/engine/improve/improve.hpp"
#include "core/engine/improve/replace.hpp"
#include "core/engine/improve/restructure.hpp"
#include "core/engine/mesh/quality.hpp"
#include "core/engine/mesh/verify.hpp"
#include "tests/support/sanitizers.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <thread>

using namespace forefront;
using samples::node;

namespace {

using Triple = std::array<unsigned, 3>;

/// Rotates an element to begin with its lowest node.
Triple turned(Triple t) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return t;
}

/// Returns the elements of a cutout by local nodes.
std::set<Triple> elementsOf(const Cutout &cutout) {
    std::set<Triple> all;
    cutout.forEachElement([&](unsigned a, unsigned b, unsigned c) { CHECK(all.insert(turned({a, b, c})).second); });
    return all;
}

/// Returns the directed sides without a partner in the set.
std::set<std::pair<unsigned, unsigned>> rimOf(const std::set<Triple> &elements) {
    std::set<std::pair<unsigned, unsigned>> sides;
    for (const Triple &t : elements) {
        for (unsigned k = 0; k < 3; ++k) {
            CHECK(sides.insert({t[k], t[(k + 1) % 3]}).second);
        }
    }
    std::set<std::pair<unsigned, unsigned>> rim;
    for (const auto &[a, b] : sides) {
        if (!sides.contains({b, a})) {
            rim.insert({a, b});
        }
    }
    return rim;
}

/// Returns true if the ring of each inner node has no repeated node, and as many nodes as there are elements around it.
bool ringsFit(const Cutout &cutout) {
    const std::set<Triple> elements = elementsOf(cutout);
    for (unsigned n = 0; n < cutout.count(); ++n) {
        if (!cutout.inner(static_cast<Cutout::Local>(n))) {
            continue;
        }
        const Cutout::Node &at = cutout[n];
        const std::set<unsigned> ring(at.ring, at.ring + at.size);
        const auto around = std::count_if(elements.begin(), elements.end(),
                                          [n](const Triple &t) { return std::find(t.begin(), t.end(), n) != t.end(); });
        if (ring.size() != at.size || around != at.size || at.valence != at.size) {
            return false;
        }
    }
    return true;
}

/// A square with an inner line, a tagged point and two regions, and lengths for its nodes.
struct RestructureSample {
    TriMesh mesh;
    RawVector<float> rho;
};

RestructureSample sample(std::size_t n, std::uint64_t seed) {
    RestructureSample made{samples::constrainedSquare(n, 0.2, {}, seed), {}};
    made.rho.assign(made.mesh.nodes.size(), 1.1F / static_cast<float>(n));
    return made;
}

std::size_t irregular(const TriMesh &mesh) {
    const auto valence = measureQuality(mesh, nullptr).valence;
    std::size_t sum = 0;
    for (std::size_t v = 0; v < valence.size(); ++v) {
        sum += v == 6 ? 0 : valence[v];
    }
    return sum;
}

double areaOf(const TriMesh &mesh, std::int32_t region) {
    double area = 0.0;
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        const Element &n = mesh.elements[e];
        const Vec2 a = mesh.nodes[index(n[0])];
        area += mesh.region(e) == region ? 0.5 * cross(mesh.nodes[index(n[1])] - a, mesh.nodes[index(n[2])] - a) : 0.0;
    }
    return area;
}

/// Checks the parts of a mesh that no change of the nodes may move.
void checkKept(const TriMesh &mesh, const TriMesh &before) {
    const Diagnostics faults = verify(mesh);
    REQUIRE_MESSAGE(faults.empty(), samples::list(faults));
    REQUIRE(mesh.edges.size() == before.edges.size());
    for (std::size_t i = 0; i < mesh.edges.size(); ++i) {
        const TaggedEdge &is = mesh.edges[i], &was = before.edges[i];
        CHECK(is.tag == was.tag);
        CHECK(mesh.nodes[index(is.a)] == before.nodes[index(was.a)]);
        CHECK(mesh.nodes[index(is.b)] == before.nodes[index(was.b)]);
    }
    REQUIRE(mesh.points.size() == before.points.size());
    CHECK(mesh.nodes[index(mesh.points[0].node)] == before.nodes[index(before.points[0].node)]);
    for (const std::int32_t region : {1, 2}) {
        CHECK(areaOf(mesh, region) == doctest::Approx(areaOf(before, region)).epsilon(1e-9));
    }
}

/// Checks that neighbours, valences and rings are those of the mesh.
void checkFits(const ImproveWorkspace &work) {
    TriMesh copy = work.mesh;
    ThreadPool pool(1);
    const ImproveWorkspace fresh(copy, pool);
    CHECK(work.twin == fresh.twin);
    CHECK(work.fixed == fresh.fixed);
    CHECK(work.valence == fresh.valence);
    CHECK(work.alpha.size() == fresh.alpha.size());
    REQUIRE(work.rings.size() == fresh.rings.size());
    for (std::size_t n = 0; n < copy.nodes.size(); ++n) {
        CHECK(work.from(work.start[n]) == node(n));
        if (work.isFree(n)) {
            std::vector<NodeId> ring, walked;
            work.ringOfFree(n, [&](NodeId m) { ring.push_back(m); });
            work.aroundFree(node(n), [&](HalfEdge h) { walked.push_back(work.to(h)); });
            CHECK(ring == walked);
        }
    }
}

} // namespace

TEST_CASE("Cutout: has the elements around three rings of free nodes, with fixed nodes on the rim") {
    RestructureSample made = sample(14, 5);
    ThreadPool pool(1);
    const ImproveWorkspace work(made.mesh, pool);
    std::size_t taken = 0;
    for (std::size_t n = 0; n < made.mesh.nodes.size(); ++n) {
        Cutout cutout;
        if (!cutout.take(work, made.rho, node(n))) {
            continue;
        }
        ++taken;
        CHECK(cutout[0].id == node(n));
        CHECK(ringsFit(cutout));
        const std::set<Triple> elements = elementsOf(cutout);
        std::set<Element> real;
        for (const Element &e : made.mesh.elements) {
            real.insert({e[0], e[1], e[2]});
        }
        for (const Triple &t : elements) {
            const std::array<NodeId, 3> ids = {cutout[t[0]].id, cutout[t[1]].id, cutout[t[2]].id};
            CHECK((real.contains({ids[0], ids[1], ids[2]}) || real.contains({ids[1], ids[2], ids[0]}) ||
                   real.contains({ids[2], ids[0], ids[1]})));
        }
        for (unsigned i = 0; i < cutout.count(); ++i) {
            const auto local = static_cast<Cutout::Local>(i);
            CHECK((!cutout.inner(local) || work.isFree(cutout[i].id)));
            CHECK(distance(cutout.place(local), work.at(cutout[i].id)) < 1e-6);
        }
    }
    CHECK(taken > 50);
    CHECK_FALSE(Cutout().take(work, made.rho, node(0))); // a corner
}

TEST_CASE("Cutout: each change keeps the rim and the rings and changes the number of elements as documented") {
    std::map<int, std::size_t> done;
    for (std::uint64_t seed = 1; seed <= (forefront::testing::kSanitized ? 2 : 6); ++seed) {
        RestructureSample made = sample(12, seed);
        ThreadPool pool(1);
        const ImproveWorkspace work(made.mesh, pool);
        const auto look = [&](const Cutout &was, const Cutout &is, int more) {
            ++done[more];
            CHECK(ringsFit(is));
            const std::set<Triple> before = elementsOf(was), after = elementsOf(is);
            CHECK(rimOf(after) == rimOf(before));
            CHECK(static_cast<int>(after.size()) - static_cast<int>(before.size()) == more);
        };
        for (std::size_t n = 0; n < made.mesh.nodes.size(); ++n) {
            Cutout was;
            if (!was.take(work, made.rho, node(n))) {
                continue;
            }
            for (unsigned k = 0; k < was[0].size; ++k) {
                const Cutout::Local b = was[0].ring[k], c = was[0].ring[(k + 1U) % was[0].size];
                const auto attempt = [&](int more, auto &&change) {
                    Cutout is = was;
                    if (change(is)) {
                        look(was, is, more);
                        if (is.balanceValences()) {
                            look(was, is, more);
                        }
                    }
                };
                attempt(0, [&](Cutout &is) { return is.swapEdge(0, b); });
                attempt(0, [&](Cutout &is) { return is.swapEdge(b, c); });
                attempt(-2, [&](Cutout &is) { return is.merge(0, b); });
                attempt(-2, [&](Cutout &is) { return is.merge(b, c); });
                attempt(+2, [&](Cutout &is) { return is.divide(0, k, 2); });
            }
        }
    }
    CHECK(done[0] > 500);
    CHECK(done[-2] > 500);
    CHECK(done[+2] > 500);
}

TEST_CASE("Cutout: a regular piece of a mesh has no excess loss, and relaxing does not change it") {
    // Equilateral elements with side 1 in a rhombus.
    constexpr std::size_t kSide = 9;
    TriMesh mesh;
    for (std::size_t j = 0; j < kSide; ++j) {
        for (std::size_t i = 0; i < kSide; ++i) {
            mesh.nodes.push_back(
                {static_cast<double>(i) + 0.5 * static_cast<double>(j), 0.8660254037844386 * static_cast<double>(j)});
        }
    }
    for (std::size_t j = 0; j + 1 < kSide; ++j) {
        for (std::size_t i = 0; i + 1 < kSide; ++i) {
            const NodeId a = node(j * kSide + i), b = node(j * kSide + i + 1), c = node((j + 1) * kSide + i),
                         d = node((j + 1) * kSide + i + 1);
            mesh.elements.insert(mesh.elements.end(), {{a, b, c}, {b, d, c}});
        }
    }
    ThreadPool pool(1);
    const ImproveWorkspace work(mesh, pool);
    const std::vector<float> rho(mesh.nodes.size(), 1.0F);
    Cutout cutout;
    REQUIRE(cutout.take(work, rho, node(kSide * kSide / 2)));
    CHECK(cutout.count() == 37);
    CHECK(elementsOf(cutout).size() == 54);
    const Cutout::Loss loss = cutout.loss();
    CHECK(loss.sum < 0.0F);
    CHECK(loss.minAlpha == doctest::Approx(1.0));
    CHECK(loss.stretch == doctest::Approx(0.0).epsilon(1e-5));
    cutout.relax(3, {0.5F, 0.9F});
    for (unsigned n = 0; n < cutout.count(); ++n) {
        CHECK(distance(cutout.place(static_cast<Cutout::Local>(n)), work.at(cutout[n].id)) < 1e-5);
    }
}

TEST_CASE("Replacer: keeps neighbours, valences and rings up to date over many changes") {
    RestructureSample made = sample(20, 9);
    const TriMesh before = made.mesh;
    ThreadPool pool(1);
    ImproveWorkspace work(made.mesh, pool);
    Replacer replacer(work, made.rho);
    samples::Random random(4);
    std::size_t changed = 0, refused = 0;
    for (int i = 0; i < 1500; ++i) {
        const NodeId site = node(random.below(work.mesh.nodes.size()));
        Cutout was;
        if (!work.isFree(site) || !was.take(work, made.rho, site)) {
            continue;
        }
        Cutout is = was;
        const auto k = static_cast<unsigned>(random.below(was[0].size));
        const bool possible = i % 3 == 0   ? is.swapEdge(0, was[0].ring[k])
                              : i % 3 == 1 ? is.merge(0, was[0].ring[k])
                                           : is.divide(0, k, 2);
        if (!possible) {
            continue;
        }
        is.relax(2, {0.5F, 0.9F});
        if (i % 7 == 0) { // a fold
            is = was;
            is.relax(1, {9.0F, -40.0F});
        }
        const std::uint64_t hash = meshHash(work.mesh);
        if (replacer.replace(was, is, 0.05)) {
            ++changed;
        } else {
            ++refused;
            CHECK(meshHash(work.mesh) == hash);
        }
    }
    CHECK(changed > 400);
    CHECK(refused > 20);
    replacer.compact();
    checkFits(work);
    CHECK(made.rho.size() == made.mesh.nodes.size());
    checkKept(made.mesh, before);
    CHECK(measureQuality(made.mesh, nullptr).alphaMin >= 0.05);
}

TEST_CASE("Replacer: refuses a change that leaves an element below the floor") {
    RestructureSample made = sample(10, 2);
    ThreadPool pool(1);
    ImproveWorkspace work(made.mesh, pool);
    Replacer replacer(work, made.rho);
    Cutout was;
    REQUIRE(was.take(work, made.rho, node(6 * 11 + 7)));
    Cutout is = was;
    is.relax(1, {0.5F, 0.9F});
    const std::uint64_t hash = meshHash(made.mesh);
    CHECK_FALSE(replacer.replace(was, is, 0.999));
    CHECK(meshHash(made.mesh) == hash);
    CHECK(replacer.replace(was, is, static_cast<double>(is.loss().minAlpha) - 1e-4));
    CHECK(meshHash(made.mesh) != hash);
}

TEST_CASE("restructure: fewer irregular nodes, better shapes, fixed parts unchanged, no lower minimum α") {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        RestructureSample made = sample(40, seed);
        improve(made.mesh); // as smooth as it can be with the nodes it has
        const TriMesh before = made.mesh;
        ThreadPool pool(2);
        ImproveWorkspace work(made.mesh, pool);
        const double minimum = work.measureAlpha();
        const RestructureCounts counts = restructure(work, made.rho, minimum, {});
        checkFits(work);
        CHECK(counts.swapped > 0);
        CHECK(counts.merged + counts.divided > 0);
        CHECK(made.mesh.nodes.size() == before.nodes.size() - counts.merged + counts.divided);
        CHECK(made.mesh.elements.size() == before.elements.size() - 2 * counts.merged + 2 * counts.divided);
        CHECK(irregular(made.mesh) < irregular(before));
        CHECK(measureQuality(made.mesh, nullptr).alphaMean > measureQuality(before, nullptr).alphaMean);
        CHECK(measureQuality(made.mesh, nullptr).alphaMin >= minimum);
        checkKept(made.mesh, before);
    }
}

TEST_CASE("restructure: one, two, three and eight threads make the same mesh bit for bit") {
    const RestructureSample raw = sample(120, 3);
    std::set<std::uint64_t> hashes;
    for (const unsigned threads : {1U, 2U, 3U, 8U}) {
        TriMesh mesh = raw.mesh;
        ThreadPool pool(threads);
        ImproveWorkspace work(mesh, pool);
        restructure(work, raw.rho, 0.01, {});
        hashes.insert(meshHash(mesh));
    }
    CHECK(hashes.size() == 1);
}

TEST_CASE("restructure: lengths beyond the range of float leave the mesh as it is") {
    for (const float rho : {0.0F, 1e-45F, std::numeric_limits<float>::infinity()}) {
        RestructureSample made = sample(12, 1);
        const std::uint64_t hash = meshHash(made.mesh);
        ThreadPool pool(1);
        ImproveWorkspace work(made.mesh, pool);
        restructure(work, RawVector<float>(made.rho.size(), rho), 0.0, {});
        CHECK(meshHash(made.mesh) == hash);
    }
}

TEST_CASE("improve: the best level, cancelled at any stage, leaves a valid mesh and fixed parts unchanged") {
    const RestructureSample raw = sample(24, 6);
    int stages = 0;
    for (int stopAt = 0; stopAt <= stages; ++stopAt) {
        TriMesh mesh = raw.mesh;
        std::stop_source stop;
        Progress progress;
        progress.stop = stop.get_token();
        int calls = 0;
        double last = 0.0;
        progress.report = [&](std::string_view, double fraction) {
            CHECK(fraction >= last);
            CHECK(fraction <= 1.0);
            last = fraction;
            if (++calls == stopAt) {
                stop.request_stop();
            }
        };
        const ImproveReport report = improve(mesh, {ImproveLevel::Best, 2, nullptr}, progress);
        stages = std::max(stages, calls);
        checkKept(mesh, raw.mesh);
        CHECK(report.alphaMinAfter <= measureQuality(mesh, nullptr).alphaMin);
        CHECK(measureQuality(mesh, nullptr).alphaMin >= measureQuality(raw.mesh, nullptr).alphaMin);
    }
    CHECK(stages >= 9);
}

TEST_CASE("restructure: leaves a valid mesh when stopped within a round") {
    RestructureSample made = sample(60, 8);
    const TriMesh before = made.mesh;
    std::stop_source stop;
    stop.request_stop();
    Progress progress;
    progress.stop = stop.get_token();
    ThreadPool pool(1);
    ImproveWorkspace work(made.mesh, pool);
    const RestructureCounts counts = restructure(work, made.rho, 0.01, progress);
    CHECK(counts.swapped + counts.merged + counts.divided == 0);
    CHECK(meshHash(made.mesh) == meshHash(before));
}

TEST_CASE("restructure: leaves a valid mesh when another thread stops it between two changes") {
    const RestructureSample made = sample(150, 8);
    ThreadPool pool(1);
    const auto changesUntil = [&](std::chrono::steady_clock::duration delay) {
        TriMesh mesh = made.mesh;
        ImproveWorkspace work(mesh, pool);
        std::stop_source stop;
        Progress progress;
        progress.stop = stop.get_token();
        const std::jthread stopper([&stop, delay](const std::stop_token &done) {
            const auto end = std::chrono::steady_clock::now() + delay;
            while (std::chrono::steady_clock::now() < end && !done.stop_requested()) {
                std::this_thread::sleep_for(std::chrono::microseconds(200));
            }
            stop.request_stop();
        });
        const RestructureCounts counts = restructure(work, made.rho, 0.01, progress);
        checkKept(mesh, made.mesh);
        return counts.swapped + counts.merged + counts.divided;
    };
    const auto begin = std::chrono::steady_clock::now();
    const std::size_t all = changesUntil(std::chrono::hours(1));
    const auto whole = std::chrono::steady_clock::now() - begin;
    // A busy machine may stop a run before its first change or after its last, so repeat until one is interrupted, with
    // delays spread evenly over the duration of a full run.
    bool cutOff = false;
    double part = 0.0;
    for (int tries = 0; tries < 1000 && !cutOff; ++tries) {
        part = std::fmod(part + std::numbers::phi - 1.0, 1.0);
        const auto delay = std::chrono::duration_cast<std::chrono::steady_clock::duration>(part * whole);
        const std::size_t changes = changesUntil(delay);
        cutOff = changes > 0 && changes < all;
    }
    CHECK(cutOff);
}

TEST_CASE("improve: the best level keeps the area of tiny meshes with few free nodes") {
    for (int corners = 3; corners <= 12; ++corners) {
        for (const double shift : {0.0, 0.2, 0.45}) {
            TriMesh mesh; // a fan of held nodes around a free one
            for (int k = 0; k < corners; ++k) {
                const double angle = 2.0 * std::numbers::pi * k / corners;
                mesh.nodes.push_back({std::cos(angle), 0.7 * std::sin(angle)});
            }
            mesh.nodes.push_back({shift * 0.8, shift * 0.3});
            for (int k = 0; k < corners; ++k) {
                mesh.elements.push_back({node(static_cast<std::size_t>(k)),
                                         node(static_cast<std::size_t>((k + 1) % corners)),
                                         node(static_cast<std::size_t>(corners))});
                mesh.edges.push_back(
                    {node(static_cast<std::size_t>(k)), node(static_cast<std::size_t>((k + 1) % corners)), 1});
            }
            if (!verify(mesh).empty()) {
                continue; // the node lies outside of the triangle
            }
            const TriMesh before = mesh;
            improve(mesh, {ImproveLevel::Best, 1, nullptr});
            CAPTURE(corners);
            CHECK(samples::list(verify(mesh)) == "");
            CHECK(areaOf(mesh, 1) == doctest::Approx(areaOf(before, 1)).epsilon(1e-12));
            CHECK(measureQuality(mesh, nullptr).alphaMin >= measureQuality(before, nullptr).alphaMin);
            CHECK(mesh.edges.size() == before.edges.size());
        }
    }
}

TEST_CASE("Cutout: keeps the last free node of a triangle") {
    TriMesh mesh;
    mesh.nodes = {{0, 0}, {1, 0}, {0.4, 0.9}, {0.45, 0.3}};
    mesh.elements = {{node(0), node(1), node(3)}, {node(1), node(2), node(3)}, {node(2), node(0), node(3)}};
    ThreadPool pool(1);
    const ImproveWorkspace work(mesh, pool);
    const std::vector<float> rho(4, 1.0F);
    Cutout cutout;
    REQUIRE(cutout.take(work, rho, node(3)));
    for (const Cutout::Local other : {cutout[0].ring[0], cutout[0].ring[1], cutout[0].ring[2]}) {
        Cutout changed = cutout;
        CHECK_FALSE(changed.merge(0, other));
    }
}
