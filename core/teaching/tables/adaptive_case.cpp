#include "core/teaching/tables/adaptive_case.hpp"

#include "core/engine/domain/add_loop.hpp"
#include "core/engine/pipeline/pipeline.hpp"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace forefront {

namespace {

constexpr int kMaxRounds = 12;

/// Returns the case of row 3. The corner's field r^(2/3)·sin(2θ/3), with θ counter-clockwise from the wall above it, is
/// zero on both walls; the branch cut of θ lies outside the domain.
AdaptiveCase corner() {
    AdaptiveCase problem;
    addLoop(problem.domain, {{0, 0}, {90, 0}, {90, 30}, {45, 30}, {45, 60}, {0, 60}});
    problem.field = "hypot(x-45,y-30)^(2/3)*sin(2/3*(atan2(x-y-15,75-x-y)+3*pi/4))"
                    "+atan(3*(dist(22.5,30)-12))+atan(3*(dist(68,15)-7))"
                    "+atan(3*(dist(0,60)-9))+atan(3*(dist(0,0)-9))";
    problem.target.error = 0.0358;
    return problem;
}

/// Returns the case of row 4.
AdaptiveCase hole() {
    AdaptiveCase problem;
    addLoop(problem.domain, {{0, 0}, {90, 0}, {90, 60}, {0, 60}});
    constexpr int kSides = 24;
    std::vector<Vec2> circle;
    for (int i = 0; i < kSides; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / kSides;
        circle.push_back(Vec2{45, 30} + 6.0 * Vec2{std::cos(angle), std::sin(angle)});
    }
    addLoop(problem.domain, circle, 2);
    problem.field = "atan(6*(dist(45,30)-16))-atan(6*(dist(45,30)-24))"
                    "+atan(6*(dist(0,0)-12))+atan(6*(dist(90,60)-12))";
    problem.target.error = 0.05;
    return problem;
}

} // namespace

AdaptiveCase adaptiveCase(const TableCase &row) {
    AdaptiveCase problem = row.row == "3" ? corner() : hole();
    problem.target.sizeMin = row.rhoMin;
    return problem;
}

Result<AdaptedJob> adaptToTarget(const AdaptiveCase &problem, const NodalField &field, const Progress &progress) {
    Result<MeshingOutcome> first = meshDomain({problem.domain, {}, {}}, progress);
    if (!first) {
        return first.faults();
    }
    Result<AdaptOutcome> outcome = adaptMesh({problem.domain, {}, {}}, takeTriMesh(std::move(first->mesh)), field,
                                             problem.target, kMaxRounds, progress);
    if (!outcome) {
        return outcome.faults();
    }
    if (!outcome->met) {
        return error("not-met", "the estimated error does not meet the target");
    }
    AdaptedJob adapted;
    adapted.job.domain = problem.domain;
    adapted.job.spacing = std::move(outcome->spacing);
    adapted.job.options.method = Method::Classic;
    adapted.job.options.improve = ImproveLevel::None;
    adapted.rounds = outcome->rounds.size() - 1;
    return adapted;
}

} // namespace forefront
