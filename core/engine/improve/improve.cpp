#include "core/engine/improve/improve.hpp"

#include "core/engine/base/cpu_clock.hpp"
#include "core/engine/base/free_memory.hpp"
#include "core/engine/improve/cleanup.hpp"
#include "core/engine/improve/growth_limit.hpp"
#include "core/engine/improve/restructure.hpp"
#include "core/engine/improve/shape_polish.hpp"
#include "core/engine/improve/smooth.hpp"
#include "core/engine/improve/spatial_order.hpp"
#include "core/engine/improve/swap_pass.hpp"
#include "core/engine/mesh/log_product.hpp"
#include "core/engine/mesh/quality.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

namespace forefront {

namespace {

/// A round swaps edges, then smooths, then may add and remove nodes. Early rounds allow poor elements, so that the mesh
/// can flow; the last round has a higher floor.
struct Round {
    int sweeps;
    SmoothingAims aims;
    double floor;
    bool restructures = false;
};

constexpr double kEarlyFloor = 0.4, kLateFloor = 0.7;
// Measured on graded meshes of size ratios 30 to 600: more weight on spacing, above all in the last round, raises δ and
// lowers α. In small meshes, where they take no time, more sweeps raise δ of coarse graded meshes from .947 to .950.
constexpr std::size_t kSmallMesh = 100'000; ///< elements
constexpr Round kSmallRounds[] = {{3, {0.5F, 0.9F}, kEarlyFloor}, {5, {0.3F, 1.1F}, kLateFloor}};
constexpr Round kDefaultRounds[] = {{2, {0.7F, 0.7F}, kEarlyFloor}, {2, {0.5F, 0.9F}, kLateFloor}};
constexpr Round kBestRounds[] = {
    {1, kBestAims, kEarlyFloor, true}, {1, kBestAims, kEarlyFloor, true}, {10, kBestAims, kLateFloor}};
constexpr std::size_t kNodesPerSpare = 32; ///< one spare node is reserved for this many nodes

/// The rounds of an improvement and the cleanup that ends it.
struct Plan {
    std::span<const Round> rounds;
    std::optional<ShapeGoal> goal; ///< of the cleanup; none: no cleanup
    double minFloor = 0.0;         ///< minimum of the floors of the rounds
    bool polishes = false;         ///< the shapes at the end, with that floor
    bool limitsGrowth = false;     ///< at the end, with the floor of `goal`

    bool restructures() const {
        return std::any_of(rounds.begin(), rounds.end(), [](const Round &round) { return round.restructures; });
    }
};

/// Ratio of the areas of neighbours that level Best keeps to where level Default does not do better.
constexpr double kMaxGrowth = 2.0;

constexpr ShapeGoal kDefaultGoal{0.8, 35.0, 6};
constexpr Plan kSmallPlan{kSmallRounds, kDefaultGoal};
constexpr Plan kDefaultPlan{kDefaultRounds, kDefaultGoal};
// Adding and removing nodes, and the weight on shapes, leave the areas of some neighbours more uneven than level
// Default does.
constexpr Plan kBestPlan{kBestRounds, ShapeGoal{0.85, 39.0, 12}, 0.0, false, true};

/// A mesh whose geometric mean of α stays below this is improved further: it is irregular, or most of it lies at its
/// boundary, so that adding and removing nodes pays off. Below kUnimprovableMean, narrow places of the domain are the
/// cause.
constexpr double kPoorMean = 0.95, kUnimprovableMean = 0.93;
constexpr double kWorthwhileGain = 5e-4; ///< of that mean, each time
constexpr double kNextGain = 0.25;       ///< maximum ratio of a gain to the one before; measured: rarely above 0.15
constexpr int kMaxRepeats = 4;
/// The floor keeps the shapes that level Default has reached, so a second cleanup is not needed. On maps, one with the
/// goal of level Best took half of the time of further improvement and lowered the mean by .002 to .003.
constexpr Round kFurtherRounds[] = {
    {1, kBestAims, kEarlyFloor, true}, {1, kBestAims, kEarlyFloor, true}, {3, kBestAims, kLateFloor}};
constexpr Plan kFurtherPlan{kFurtherRounds, std::nullopt, 0.8};
/// With a floor of .8, which elements at the boundary have often just reached, polishing gains half as much.
constexpr Plan kPolishPlan{{}, std::nullopt, 0.75, true};

class Improvement {
  public:
    Improvement(TriMesh &mesh, const Plan &plan, const ImproveOptions &options, ThreadPool &pool,
                const Progress &progress)
        : plan_(plan), options_(options), progress_(progress),
          work_(mesh, pool, progress.stop, plan.restructures() ? mesh.nodes.size() / kNodesPerSpare : 0) {
        work_.watch = options.watch;
    }

    ImproveReport run() {
        stages_ = (plan_.goal ? 1 : 0) + (plan_.polishes ? 1 : 0) + (plan_.limitsGrowth ? 1 : 0);
        for (const Round &round : plan_.rounds) {
            stages_ += round.restructures ? 3 : 2;
        }
        if (progress_.cancelled()) {
            return report_;
        }
        const double minAlpha = work_.measureAlpha(progress_.stop);
        bool proceeding = !progress_.cancelled();
        if (proceeding) {
            report_.alphaMinBefore = report_.alphaMinAfter = minAlpha;
        }
        const double growth = proceeding && plan_.limitsGrowth ? growthOf(work_) : 0.0;
        std::optional<NodeSmoother> smoother;
        for (const Round &round : plan_.rounds) {
            proceeding = proceeding && swapAndSmooth(round, smoother) &&
                         (!round.restructures || restructureRound(round, smoother));
        }
        smoother.reset(); // frees its memory
        if (proceeding && plan_.goal) {
            const CleanupCounts cleaned = cleanUpWorst(work_, *plan_.goal, report_.alphaMinBefore, progress_);
            report_.swaps += cleaned.swaps;
            report_.moves += cleaned.moves;
            proceeding = next();
        }
        if (proceeding && plan_.limitsGrowth) {
            const double floor = std::max(plan_.goal->alpha, report_.alphaMinBefore);
            report_.moves += limitGrowth(work_, {std::min(growth, kMaxGrowth), floor, plan_.goal->angle}, progress_);
            work_.report(ImproveChange::Growth);
            proceeding = next();
        }
        if (proceeding && plan_.polishes) {
            report_.moves += polishShapes(work_, std::max(plan_.minFloor, report_.alphaMinBefore), progress_);
            work_.measureAlpha(progress_.stop);
            proceeding = next();
        }
        if (proceeding) {
            report_.alphaMinAfter = work_.minAlpha();
        }
        return report_;
    }

  private:
    /// Reports the end of a stage. Returns false when cancelled.
    bool next() {
        progress_("improving", static_cast<double>(++done_) / static_cast<double>(stages_));
        return !progress_.cancelled();
    }

    /// Elements below the floor may only rise, and none falls below it, so the minimum α never falls.
    double floorOf(const Round &round) const { return std::max({round.floor, report_.alphaMinBefore, plan_.minFloor}); }

    bool swapAndSmooth(const Round &round, std::optional<NodeSmoother> &smoother) {
        const double floor = floorOf(round);
        report_.swaps += swapEdges(work_, {true, floor}, progress_);
        if (!next()) {
            return false;
        }
        if (!smoother) {
            if (options_.threads > 1) { // One thread reuses its memory; without this, maps improve in 6/7 of the time.
                releaseFreeMemory();    // It is about to peak.
            }
            smoother.emplace(work_, options_.spacing, progress_.stop);
        } else {
            smoother->renewSpacing(progress_.stop);
        }
        report_.moves += smoother->sweep(round.sweeps, round.aims, floor, progress_);
        return next();
    }

    bool restructureRound(const Round &round, std::optional<NodeSmoother> &smoother) {
        smoother->renewSpacing(progress_.stop);
        RawVector<float> rho = std::move(*smoother).takeSpacing();
        smoother.reset();
        if (progress_.cancelled()) {
            return false;
        }
        const RestructureCounts counts = restructure(work_, std::move(rho), floorOf(round), progress_);
        report_.swaps += counts.swapped;
        report_.merges += counts.merged;
        report_.divisions += counts.divided;
        work_.measureAlpha(progress_.stop);
        return next();
    }

    const Plan &plan_;
    const ImproveOptions &options_;
    const Progress &progress_;
    ImproveWorkspace work_;
    ImproveReport report_;
    int stages_ = 1, done_ = 0;
};

void reportOrder(const ImproveOptions &options, const TriMesh &mesh) {
    if (options.watch != nullptr) {
        options.watch->changed(ImproveChange::Renumber, mesh, mesh.nodes, {});
    }
}

/// Improves a mesh by a plan. Sorts large meshes meanwhile where that pays off; a plan that changes the numbers of
/// nodes and elements leaves them as they are.
ImproveReport improveBy(const Plan &plan, TriMesh &mesh, const ImproveOptions &options, const Progress &progress) {
    CpuClock clock;
    ThreadPool pool(options.threads);
    std::optional<SpatialOrder> order;
    if (!plan.restructures() && mesh.elements.size() > kSmallMesh && SpatialOrder::helps(mesh)) {
        order.emplace(mesh, pool);
        reportOrder(options, mesh);
    }
    ImproveReport report = Improvement(mesh, plan, options, pool, progress).run();
    if (order) {
        order->restore();
        reportOrder(options, mesh);
    }
    report.seconds = clock.lap() + pool.workerSeconds();
    return report;
}

/// Returns the minimum α, exactly as measureQuality() does.
double minAlpha(const TriMesh &mesh) {
    double minimum = mesh.elements.empty() ? 0.0 : 2.0;
    for (const Element &n : mesh.elements) {
        minimum =
            std::min(minimum, shapeFactor(mesh.nodes[index(n[0])], mesh.nodes[index(n[1])], mesh.nodes[index(n[2])]));
    }
    return minimum;
}

double geometricMeanAlpha(const TriMesh &mesh) {
    LogProduct product;
    for (const Element &n : mesh.elements) {
        product.multiply(shapeFactor(mesh.nodes[index(n[0])], mesh.nodes[index(n[1])], mesh.nodes[index(n[2])]));
    }
    return std::exp(product.logarithm() / static_cast<double>(mesh.elements.size()));
}

/// Returns a progress that reports into a part of another, which must outlive it.
Progress partOf(const Progress &whole, double from, double to) {
    Progress part;
    part.stop = whole.stop;
    if (whole.report) {
        part.report = [&whole, from, to](std::string_view stage, double fraction) {
            whole(stage, from + (to - from) * fraction);
        };
    }
    return part;
}

/// Adds the report of further improvement.
void append(ImproveReport &report, const ImproveReport &further) {
    report.swaps += further.swaps;
    report.moves += further.moves;
    report.merges += further.merges;
    report.divisions += further.divisions;
    report.alphaMinAfter = std::max(report.alphaMinAfter, further.alphaMinAfter);
    report.seconds += further.seconds;
}

/// Adds and removes nodes of a poor mesh, then moves nodes for the shapes alone if it stays poor, and so on as long as
/// that pays off.
void improveFurther(TriMesh &mesh, const ImproveOptions &options, const Progress &progress, ImproveReport &report) {
    double mean = geometricMeanAlpha(mesh);
    double gain = mean < kUnimprovableMean ? 0.0 : 1.0;
    // In a small mesh, another try is cheap.
    const auto isWithinReach = [&] {
        return mesh.elements.size() <= kSmallMesh || kPoorMean - mean < kNextGain * gain;
    };
    for (int time = 0; time < kMaxRepeats && mean < kPoorMean && gain >= kWorthwhileGain && isWithinReach(); ++time) {
        const double before = mean;
        for (const Plan *plan : {&kFurtherPlan, &kPolishPlan}) {
            if (mean < kPoorMean) {
                append(report, improveBy(*plan, mesh, options, progress));
                if (progress.cancelled()) {
                    return;
                }
                mean = geometricMeanAlpha(mesh);
            }
        }
        gain = mean - before;
    }
}

} // namespace

ImproveReport improve(TriMesh &mesh, const ImproveOptions &options, const Progress &progress) {
    if (progress.cancelled()) {
        return {};
    }
    if (mesh.elements.empty() || mesh.elements.size() > ImproveWorkspace::kMaxElements ||
        options.level == ImproveLevel::None) {
        ImproveReport report;
        report.alphaMinBefore = report.alphaMinAfter = minAlpha(mesh);
        return report;
    }
    const Plan &plan = mesh.elements.size() <= kSmallMesh ? kSmallPlan : kDefaultPlan;
    const bool best = options.level == ImproveLevel::Best;
    const double share = best ? 0.3 : 1.0;
    ImproveReport report = improveBy(plan, mesh, options, partOf(progress, 0.0, 0.7 * share));
    if (!progress.cancelled()) {
        improveFurther(mesh, options, partOf(progress, 0.7 * share, share), report);
    }
    // It starts from the result of level Default, so that it knows the growth there.
    if (best && !progress.cancelled()) {
        append(report, improveBy(kBestPlan, mesh, options, partOf(progress, share, 1.0)));
    }
    if (options.watch != nullptr) {
        options.watch->changed(ImproveChange::Remainder, mesh, mesh.nodes, {});
    }
    return report;
}

} // namespace forefront
