#include "core/engine/mesh/mesh_view.hpp"
#include "core/engine/mesh/quality.hpp"
#include "core/engine/mesher/timeline.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/engine/quads/coloured_mesher.hpp"
#include "core/engine/quads/quad_mesh.hpp"
#include "core/engine/session/mesh_stepper.hpp"
#include "tests/support/quad_jobs.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace forefront {

using namespace testing;

TEST_CASE("Quads stepped: the end is the mesh of meshDomain, with and without steps of the clean-up") {
    for (const auto &[name, job] : steppedJobs()) {
        CAPTURE(name);
        const std::uint64_t expected = hashOfMeshed(job);
        for (const bool steps : {false, true}) {
            CAPTURE(steps);
            MeshStepper stepper = quadStepper(job);
            if (steps) {
                stepper.stepImprovement();
            }
            CHECK(stepper.finish());
            CHECK(meshHash(stepper.mesh()) == expected);
            CHECK(stepper.front().empty());
            const std::shared_ptr<const SessionSnapshot> end = stepper.snapshot();
            CHECK(end->atEnd());
            CHECK((end->improveSteps > 0) == steps);
        }
    }
}

TEST_CASE("Quads stepped: after N advances forward and N back, the state is the same, at every N") {
    for (const auto &[name, job] : steppedJobs()) {
        if (name == "second order" || name == "not improved") {
            continue; // their fronts are that of the disc
        }
        for (const std::uint32_t rows : {rowsOfFront(false), rowsOfFront(true)}) {
            CAPTURE(name);
            CAPTURE(rows);
            std::shared_ptr<const ColouredBoundary> boundary;
            const std::unique_ptr<ColouredMesher> mesher = colouredMesher(job, rows, boundary);
            std::vector<std::uint64_t> hashes{mesher->stateHash()};
            std::vector<AdvanceDelta> deltas;
            while (mesher->advance(1, &deltas) == 1) {
                hashes.push_back(mesher->stateHash());
            }
            REQUIRE(deltas.size() > 20);
            for (std::size_t n = deltas.size(); n-- > 0;) {
                mesher->retreat(deltas[n]);
                REQUIRE(mesher->stateHash() == hashes[n]);
            }
            std::vector<AdvanceDelta> again;
            CHECK(mesher->advance(deltas.size(), &again) == deltas.size());
            CHECK(mesher->stateHash() == hashes.back());
            CHECK(mesher->finished());
        }
    }
}

TEST_CASE("Quads stepped: jumps to checkpoints lead to the same states") {
    const MeshingJob job = steppedJobs()["graded"];
    std::shared_ptr<const ColouredBoundary> boundary;
    Timeline plain(colouredMesher(job, rowsOfFront(true), boundary));
    std::vector<std::uint64_t> hashes{plain.mesher().stateHash()};
    while (plain.forward(1) == 1) {
        hashes.push_back(plain.mesher().stateHash());
    }
    Timeline jumping(colouredMesher(job, rowsOfFront(true), boundary), 64);
    jumping.forward(hashes.size());
    REQUIRE(jumping.complete());
    REQUIRE(jumping.checkpoints() > 4);
    const std::size_t last = hashes.size() - 1;
    for (std::size_t k = 0; k < 40; ++k) {
        const std::uint64_t target = (k * 7919 + 3) % (last + 1);
        jumping.approach(target);
        if (jumping.position() < target) {
            jumping.forward(target - jumping.position());
        } else {
            jumping.back(jumping.position() - target);
        }
        REQUIRE(jumping.position() == target);
        CHECK(jumping.mesher().stateHash() == hashes[target]);
    }
}

TEST_CASE("Quads stepped: every grid makes the same steps") {
    MeshingJob job = steppedJobs()["corner"];
    std::vector<std::uint64_t> last;
    for (const GridKind grid : {GridKind::None, GridKind::Uniform, GridKind::Hierarchical}) {
        job.options.grid = grid;
        std::shared_ptr<const ColouredBoundary> boundary;
        const std::unique_ptr<ColouredMesher> mesher = colouredMesher(job, rowsOfFront(false), boundary);
        std::vector<std::uint64_t> hashes;
        std::vector<AdvanceDelta> deltas;
        while (mesher->advance(1, &deltas) == 1) {
            hashes.push_back(mesher->stateHash());
        }
        CHECK((last.empty() || last == hashes));
        last = hashes;
    }
}

TEST_CASE("Quads stepped: each advance makes what its explanation says") {
    for (const auto &[name, job] : steppedJobs()) {
        CAPTURE(name);
        MeshStepper stepper = quadStepper(job);
        std::map<SquareKind, std::size_t> made;
        while (stepper.advance() == 1) {
            const std::shared_ptr<const AdvanceExplanation> told = stepper.explanation();
            REQUIRE(told);
            CHECK(told->coloured);
            CHECK(told->advance == stepper.position());
            CHECK(told->made.size() == told->elements);
            const unsigned expected = told->deferred ? 0 : told->square == SquareKind::None ? 1 : 2;
            CHECK(told->elements == expected);
            const auto accepted = std::ranges::count(told->candidates, Verdict::Accepted, &CandidateTrace::verdict);
            CHECK(accepted == (told->deferred ? 0 : 1));
            for (const CandidateTrace &candidate : told->candidates) {
                CHECK((candidate.colour == 0 || candidate.colour == 1));
                if (candidate.verdict == Verdict::Accepted) {
                    CHECK(candidate.square == told->square);
                }
            }
            ++made[told->square];
            for (std::size_t cursor = 0; cursor <= told->events.size(); ++cursor) {
                const std::string words = caption(*told, cursor);
                CAPTURE(words);
                CHECK(words.starts_with("Edge "));
                CHECK_FALSE(words.ends_with(": "));
            }
        }
        CHECK(made[SquareKind::Row] > 0);
        CHECK((made[SquareKind::Opening] > 0 || name == "mixed"));
    }
}

TEST_CASE("Quads stepped: a caption names the square made and why others were refused") {
    MeshStepper stepper = quadStepper(steppedJobs()["graded"]);
    std::map<std::string, bool> seen = {{"row continued: a square with one new node", false},
                                        {"row opened: a square with two new nodes", false},
                                        {"gap closed: a square without a new node", false},
                                        {"half a square, with node ", false},
                                        {"the square that continues the row refused: badly shaped", false},
                                        {"the square that continues the row refused: too near the front", false},
                                        {"refused: would join three nodes of one colour", false},
                                        {"a diagonal, its nodes have one colour", false},
                                        {"a leg of row 2", false}};
    while (stepper.advance() == 1) {
        const std::shared_ptr<const AdvanceExplanation> told = stepper.explanation();
        for (const std::size_t cursor : {std::size_t{0}, told->events.size()}) {
            for (auto &[words, found] : seen) {
                found = found || caption(*told, cursor).find(words) != std::string::npos;
            }
        }
    }
    for (const auto &[words, found] : seen) {
        INFO(words);
        CHECK(found);
    }
}

TEST_CASE("Quads stepped: the front shows whole squares, and halves until their second half is made") {
    MeshStepper stepper = quadStepper(steppedJobs()["disc"]);
    const std::shared_ptr<const SessionSnapshot> start = stepper.snapshot();
    for (const FrontSegmentView &segment : *start->front) {
        CHECK((segment.colour == 0 || segment.colour == 1));
    }
    std::size_t halves = 0;
    while (stepper.advance() == 1) {
        const Mesh mesh = stepper.mesh();
        const std::size_t triangles = mesh.triangles().size(), quads = mesh.elementCount() - triangles;
        halves += stepper.explanation()->elements;
        CHECK(2 * quads + triangles == halves);
        CHECK(triangles < 20);
    }
    CHECK(halves > 100);
}

TEST_CASE("Quads stepped: a half stays of a square whose second half is refused, counted and told") {
    const MeshingJob job = steppedJobs()["gear"];
    std::shared_ptr<const ColouredBoundary> boundary;
    MeshStepper stepper = quadStepper(job);
    std::size_t kept = 0;
    while (stepper.advance() == 1) {
        const std::shared_ptr<const AdvanceExplanation> told = stepper.explanation();
        const bool refused = std::ranges::any_of(told->candidates, [](const CandidateTrace &candidate) {
            return candidate.square == SquareKind::Closing && candidate.verdict == Verdict::CrossesFront;
        });
        const CandidateTrace &last = told->candidates.back();
        if (refused && told->searchRadius == 0.0 && last.verdict == Verdict::Accepted) { // it was not searched for
            ++kept;
            const std::string words = caption(*told, told->events.size());
            CAPTURE(words);
            CHECK(words.find("half a square, with node ") != std::string::npos);
            CHECK(words.find("the square that closes the gap refused: crosses the front") != std::string::npos);
            CHECK(last.position == told->apex);
        }
    }
    CHECK(kept > 0);
    const std::unique_ptr<ColouredMesher> mesher = colouredMesher(job, rowsOfFront(false), boundary);
    static_cast<void>(mesher->advance(1'000'000, nullptr));
    const ColouredWork &work = mesher->squares();
    const std::uint64_t squares = work.rows + work.openings + work.closings;
    CHECK(2 * squares + work.searched + work.forced == mesher->state().elements.size());
}

TEST_CASE("Quads stepped: the figures of a position are those of its mesh, or none") {
    MeshStepper stepper = quadStepper(steppedJobs()["disc"]);
    for (const std::uint64_t position : {1, 2, 30, 60}) {
        stepper.seek(position);
        const std::shared_ptr<const SessionSnapshot> bare = stepper.snapshot({.mesh = false});
        CHECK(bare->quality.alphaMean == 0.0);
        CHECK(bare->quality.elements == 0);
        const std::shared_ptr<const SessionSnapshot> whole = stepper.snapshot();
        const MeshQuality expected = measureQuality(stepper.mesh(), whole->spacing.get());
        CHECK(whole->quality.elements == expected.elements);
        CHECK(whole->quality.alphaMin == expected.alphaMin);
        CHECK(whole->quality.alphaMean == expected.alphaMean);
        CHECK(whole->quality.nodes == bare->quality.nodes);
    }
}

TEST_CASE("Quads stepped: the advance that made a place names no diagonal and no number of a half") {
    MeshStepper stepper = quadStepper(steppedJobs()["corner"]);
    REQUIRE(stepper.finish());
    const std::uint64_t known = stepper.known();
    stepper.seek(known);
    const Mesh mesh = stepper.mesh();
    std::size_t sides = 0;
    for (double x = 0.05; x < 1.0; x += 0.07) {
        for (double y = 0.05; y < 2.0; y += 0.07) {
            stepper.seek(known);
            const std::optional<Birth> birth = stepper.seekBirth({x, y}, 0.012);
            REQUIRE(birth);
            CHECK(birth->element == kNoElement);
            if (birth->kind != Birth::Kind::Edge) {
                continue;
            }
            const MeshView view(mesh);
            bool side = false;
            for (std::size_t e = 0; e < view.elementCount(); ++e) {
                const std::span<const NodeId> nodes = view.cornersOf(e);
                for (std::size_t k = 0; k < nodes.size(); ++k) {
                    const NodeId p = nodes[k], q = nodes[(k + 1) % nodes.size()];
                    side = side || (p == birth->a && q == birth->b) || (p == birth->b && q == birth->a);
                }
            }
            CHECK(side);
            ++sides;
        }
    }
    CHECK(sides > 5);
}

TEST_CASE("Quads stepped: a caption tells a join of triangles only where there was one") {
    ImproveStep step;
    step.change = ImproveChange::Walk;
    step.quads = true;
    step.number = 2;
    step.elements.resize(3);
    step.removedEdges.resize(2);
    step.addedEdges.resize(2);
    CHECK(caption(step, 9).find("triangle moved through 2 elements, where its way ends") != std::string::npos);
    step.removedEdges.resize(3);
    CHECK(caption(step, 9).find("two triangles joined through the 2 elements between them") != std::string::npos);
    step.removedEdges.resize(5);
    CHECK(caption(step, 9).find("3 pairs of triangles joined through the elements between them") != std::string::npos);
    step.elements.resize(1);
    step.addedEdges.clear();
    step.removedEdges.resize(1);
    CHECK(caption(step, 9).find("two neighbouring triangles joined") != std::string::npos);
}

} // namespace forefront
