#include "core/engine/domain/add_loop.hpp"
#include "core/teaching/page/recorded_run.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace recorded_improvements {

using Place = std::pair<std::int64_t, std::int64_t>;
using Triangles = std::vector<std::array<Place, 3>>;

/// Returns the triangles in an order that depends on their places alone.
Triangles sorted(Triangles triangles) {
    for (auto &corners : triangles) {
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    }
    std::sort(triangles.begin(), triangles.end());
    return triangles;
}

/// Replays a record as a page does: lasting numbers of nodes, places of elements in a list.
class Replay {
  public:
    Replay(const Mesh &front, double unit) : unit_(unit) {
        for (const Vec2 node : front.nodes) {
            places_.push_back(placeOf(node));
        }
        const MeshView view(front);
        for (std::size_t e = 0; e < view.elementCount(); ++e) {
            const auto corners = view.cornersOf(e);
            auto &slot = slots_.emplace_back();
            std::transform(corners.begin(), corners.end(), slot.begin(),
                           [](NodeId node) { return static_cast<std::int64_t>(index(node)); });
        }
    }
    Place placeOf(Vec2 p) const { return {std::llround(p.x / unit_), std::llround(p.y / unit_)}; }

    void take(const nlohmann::json &step) {
        const auto list = [&step](const char *name) {
            return step.contains(name) ? step[name].get<std::vector<std::int64_t>>() : std::vector<std::int64_t>();
        };
        const auto moved = list("m"), added = list("n"), changed = list("c");
        for (std::size_t i = 0; i < moved.size(); i += 3) {
            Place &place = places_.at(static_cast<std::size_t>(moved[i]));
            place = {place.first + moved[i + 1], place.second + moved[i + 2]};
        }
        for (std::size_t i = 0; i < added.size(); i += 2) {
            places_.emplace_back(added[i], added[i + 1]);
        }
        for (std::size_t i = 0; i < changed.size(); i += 4) {
            const auto slot = static_cast<std::size_t>(changed[i]);
            REQUIRE(slot <= slots_.size());
            slots_.resize(std::max(slots_.size(), slot + 1));
            slots_[slot] = {changed[i + 1], changed[i + 2], changed[i + 3]};
        }
        gone_ += list("r").size();
    }
    Triangles triangles() const {
        Triangles result;
        for (const auto &corners : slots_) {
            if (corners[0] >= 0) {
                auto &triangle = result.emplace_back();
                std::transform(corners.begin(), corners.end(), triangle.begin(),
                               [&](std::int64_t n) { return places_.at(static_cast<std::size_t>(n)); });
            }
        }
        return sorted(std::move(result));
    }
    std::size_t nodes() const { return places_.size() - gone_; }

  private:
    double unit_;
    std::vector<Place> places_;
    std::vector<std::array<std::int64_t, 3>> slots_;
    std::size_t gone_ = 0;
};

MeshingJob job(Method method, double size, bool crack) {
    MeshingJob made;
    addLoop(made.domain, {{0, 0}, {6, 0}, {6, 2}, {3.1, 2.2}, {3, 5}, {0, 4}});
    addLoop(made.domain, {{1, 1}, {2, 1}, {1.5, 2}}, 2);
    if (crack) {
        const auto first = static_cast<std::uint32_t>(made.domain.nodes.size());
        made.domain.nodes.insert(made.domain.nodes.end(), {{3.5, 1.0}, {5.0, 1.2}});
        made.domain.segments.push_back({first, first + 1, 5, SegmentRole::Constraint});
    }
    made.spacing.size = size;
    made.options.method = method;
    return made;
}

/// Records a run, and checks each of its steps against the mesh of the stepper. Returns the number of steps.
std::size_t checkRecord(const MeshingJob &job) {
    const Result<RecordedRun> run = recordRun(job, {}, {});
    REQUIRE_MESSAGE(run.ok(), messages(run.faults()));
    const RecordedImprovement &record = run->improvement;
    CHECK(record.steps.size() == record.total);
    CHECK(run->improveMoments() == std::max<std::size_t>(record.total, 1));
    Result<MeshStepper> stepper = MeshStepper::create(job);
    REQUIRE(stepper);
    stepper->stepImprovement();
    Replay replay(run->mesh, record.unit);
    for (std::size_t k = 0; k < record.steps.size(); ++k) {
        CAPTURE(k);
        const nlohmann::json step = nlohmann::json::parse(record.steps[k]);
        replay.take(step);
        stepper->seek(run->advances.size() + k + 1);
        const std::shared_ptr<const SessionSnapshot> now = stepper->snapshot({.mesh = true, .front = false});
        REQUIRE(now->improveStep == k + 1);
        const TriMesh &mesh = now->mesh->mesh;
        Triangles expected;
        for (const Element &element : mesh.elements) {
            auto &triangle = expected.emplace_back();
            std::transform(element.begin(), element.end(), triangle.begin(),
                           [&](NodeId n) { return replay.placeOf(mesh.nodes[index(n)]); });
        }
        CHECK(replay.triangles() == sorted(std::move(expected)));
        CHECK(replay.nodes() == mesh.nodes.size());
        CHECK(step["f"].size() == 2);
        CHECK(step["w"].get<std::string>().find("minimum α") != std::string::npos);
    }
    return record.steps.size();
}

} // namespace recorded_improvements

TEST_CASE("Recorded improvement: a page that replays the steps has the meshes of the stepper") {
    using namespace recorded_improvements;
    std::size_t steps = 0;
    for (const Method method : {Method::Classic, Method::Fast}) {
        for (const double size : {0.8, 0.35}) {
            for (const bool crack : {false, true}) {
                CAPTURE(size);
                CAPTURE(crack);
                MeshingJob each = job(method, size, crack);
                each.options.improve = crack ? ImproveLevel::Best : ImproveLevel::Default;
                steps += checkRecord(each);
            }
        }
    }
    CHECK(steps > 100);
}

TEST_CASE("Recorded improvement: what follows the improvement is a step, too") {
    using namespace recorded_improvements;
    MeshingJob refined = job(Method::Classic, 0.8, false);
    refined.options.leastAngle = 25.0;
    CHECK(checkRecord(refined) > 1);
}

TEST_CASE("Recorded improvement: a long one ends with a moment after all the steps that are left out") {
    using namespace recorded_improvements;
    RunPagePlan plan;
    plan.maxImproveBytes = 500;
    const Result<RecordedRun> run = recordRun(job(Method::Classic, 0.35, false), plan, {});
    REQUIRE(run);
    REQUIRE(run->improvement.steps.size() < run->improvement.total);
    CHECK(run->improveMoments() == run->improvement.steps.size() + 1);
    MeshingJob plain = job(Method::Classic, 0.8, false);
    plain.options.improve = ImproveLevel::None;
    const Result<RecordedRun> raw = recordRun(plain, {}, {});
    REQUIRE(raw);
    CHECK(raw->improveMoments() == 0);
}
