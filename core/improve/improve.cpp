#include "core/improve/improve.hpp"

#include "core/base/cpu_clock.hpp"
#include "core/base/free_memory.hpp"
#include "core/improve/repair.hpp"
#include "core/improve/restructure.hpp"
#include "core/improve/smooth.hpp"
#include "core/improve/swap_pass.hpp"
#include "core/mesh/quality.hpp"

#include <algorithm>
#include <optional>
#include <span>

namespace forefront {

namespace {

/// Swaps, then sweeps; then, where asked for, nodes come and go. Early rounds let elements fall far, so that the mesh
/// can flow; the last holds a better floor.
struct Round {
    int sweeps;
    SmoothingAims aims;
    double floor;
    bool restructures = false;
};

constexpr double kEarlyFloor = 0.4, kLateFloor = 0.7;
// Measured on graded meshes of size ratios 30 to 600: the later and the more the aim is spacing, the higher δ and the
// lower α. Where a mesh is small enough for it to take no time, more sweeps bring coarse graded meshes from δ .947 to
// .950.
constexpr std::size_t kSmallMesh = 100'000; ///< elements
constexpr Round kSmallRounds[] = {{3, {0.5F, 0.9F}, kEarlyFloor}, {5, {0.3F, 1.1F}, kLateFloor}};
constexpr Round kDefaultRounds[] = {{2, {0.7F, 0.7F}, kEarlyFloor}, {2, {0.5F, 0.9F}, kLateFloor}};
constexpr Round kBestRounds[] = {
    {1, kBestAims, kEarlyFloor, true}, {1, kBestAims, kEarlyFloor, true}, {10, kBestAims, kLateFloor}};
constexpr std::size_t kRoom = 32; ///< nodes that may become one more before memory must be asked for anew
constexpr ShapeGoal kDefaultGoal{0.8, 35.0, 6};
constexpr ShapeGoal kBestGoal{0.85, 39.0, 12};

class Improvement {
  public:
    Improvement(Mesh &mesh, const ImproveOptions &options, const Progress &progress)
        : options_(options), progress_(progress), pool_(options.threads),
          work_(mesh, pool_, progress.stop, options.level == ImproveLevel::Best ? mesh.nodes.size() / kRoom : 0) {}

    ImproveReport run() {
        const bool best = options_.level == ImproveLevel::Best;
        const std::span<const Round> rounds = best ? std::span<const Round>(kBestRounds)
                                              : work_.mesh.elements.size() <= kSmallMesh ? kSmallRounds
                                                                                         : kDefaultRounds;
        stages_ = 1;
        for (const Round &round : rounds) {
            stages_ += round.restructures ? 3 : 2;
        }
        if (progress_.cancelled()) {
            return report();
        }
        const double least = work_.measureAlpha(progress_.stop);
        bool going = !progress_.cancelled();
        if (going) {
            report_.alphaMinBefore = report_.alphaMinAfter = least;
        }
        std::optional<NodeSmoother> smoother;
        for (const Round &round : rounds) {
            going = going && swapAndSweep(round, smoother) && (!round.restructures || comeAndGo(round, smoother));
        }
        smoother.reset(); // its memory
        if (going) {
            const RepairCounts repaired =
                repairWorst(work_, best ? kBestGoal : kDefaultGoal, report_.alphaMinBefore, progress_);
            report_.swaps += repaired.swaps;
            report_.moves += repaired.moves;
            going = next();
        }
        if (going) {
            report_.alphaMinAfter = work_.leastAlpha();
        }
        return report();
    }

  private:
    const ImproveReport &report() {
        report_.seconds = clock_.lap() + pool_.workerSeconds();
        return report_;
    }

    bool next() {
        progress_("improving", static_cast<double>(++done_) / static_cast<double>(stages_));
        return !progress_.cancelled();
    }

    bool swapAndSweep(const Round &round, std::optional<NodeSmoother> &smoother) {
        // No element gets below the floor, unless it was below and rises: so the least α never falls.
        const double floor = std::max(round.floor, report_.alphaMinBefore);
        report_.swaps += swapEdges(work_, {true, floor}, progress_);
        if (!next()) {
            return false;
        }
        if (!smoother) {
            giveBackFreeMemory(); // of what has been, since now the most is needed
            smoother.emplace(work_, options_.spacing, progress_.stop);
        } else {
            smoother->renewSpacing(progress_.stop);
        }
        report_.moves += smoother->sweep(round.sweeps, round.aims, floor, progress_);
        return next();
    }

    bool comeAndGo(const Round &round, std::optional<NodeSmoother> &smoother) {
        smoother->renewSpacing(progress_.stop);
        RawVector<float> rho = std::move(*smoother).takeSpacing();
        smoother.reset();
        if (progress_.cancelled()) {
            return false;
        }
        const RestructureCounts counts =
            restructure(work_, std::move(rho), std::max(round.floor, report_.alphaMinBefore), progress_);
        report_.swaps += counts.turned;
        report_.merges += counts.merged;
        report_.divisions += counts.divided;
        work_.measureAlpha(progress_.stop);
        return next();
    }

    CpuClock clock_;
    const ImproveOptions &options_;
    const Progress &progress_;
    ThreadPool pool_;
    ImproveWorkspace work_;
    ImproveReport report_;
    int stages_ = 1, done_ = 0;
};

/// The least α, as measure() finds it.
double leastAlpha(const Mesh &mesh) {
    double least = mesh.elements.empty() ? 0.0 : 2.0;
    for (const Element &n : mesh.elements) {
        least = std::min(least, shapeFactor(mesh.nodes[index(n[0])], mesh.nodes[index(n[1])], mesh.nodes[index(n[2])]));
    }
    return least;
}

} // namespace

ImproveReport improve(Mesh &mesh, const ImproveOptions &options, const Progress &progress) {
    if (progress.cancelled()) {
        return {};
    }
    if (mesh.elements.empty() || mesh.elements.size() > ImproveWorkspace::kMostElements ||
        options.level == ImproveLevel::None) {
        ImproveReport report;
        report.alphaMinBefore = report.alphaMinAfter = leastAlpha(mesh);
        return report;
    }
    return Improvement(mesh, options, progress).run();
}

} // namespace forefront
