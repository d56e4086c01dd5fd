#include "core/improve/improve.hpp"

#include "core/improve/repair.hpp"
#include "core/improve/smooth.hpp"
#include "core/improve/swap.hpp"

#include <algorithm>
#include <optional>

namespace forefront {

namespace {

/// Elements below this α are worked on one by one at the end.
constexpr double kWorst = 0.8;
/// Early sweeps let elements fall this far, so that the mesh can flow; the last ones hold the better floor.
constexpr double kEarlyFloor = 0.4;
constexpr double kLateFloor = 0.75;
constexpr int kRounds = 3;
constexpr int kSweepsEarly = 3;
constexpr int kSweepsLate = 2;

double leastAlpha(const Mesh &mesh) {
    double least = mesh.elements.empty() ? 0.0 : 2.0;
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        least = std::min(least, alphaOf(mesh, e));
    }
    return least;
}

} // namespace

ImproveReport improve(Mesh &mesh, const ImproveOptions &options, const Progress &progress) {
    ImproveReport report;
    report.alphaMinBefore = report.alphaMinAfter = leastAlpha(mesh);
    if (mesh.elements.empty() || options.level == ImproveLevel::None || progress.cancelled()) {
        return report;
    }
    constexpr const char *kStage = "improving";
    ImproveWorkspace work(mesh);
    std::optional<NodeSmoother> smoother(std::in_place, work);
    const int stages = 2 * kRounds + 1;
    int done = 0;
    const auto next = [&] {
        progress(kStage, static_cast<double>(++done) / static_cast<double>(stages));
        return !progress.cancelled();
    };
    bool going = true;
    for (int round = 0; round < kRounds && going; ++round) {
        const bool last = round + 1 == kRounds;
        work.floor = std::max(last ? kLateFloor : kEarlyFloor, report.alphaMinBefore);
        report.swaps += swapEdges(work, !last, progress);
        going = next();
        const int sweeps = last ? kSweepsLate : kSweepsEarly;
        for (int sweep = 0; sweep < sweeps && going; ++sweep) {
            report.moves += smoother->sweep(work.floor);
            going = !progress.cancelled();
        }
        going = going && next();
    }
    smoother.reset(); // its memory
    if (going) {
        const RepairCounts repaired = repairWorst(work, kWorst, progress);
        report.swaps += repaired.swaps;
        report.moves += repaired.moves;
        next();
    }
    report.alphaMinAfter = leastAlpha(mesh);
    return report;
}

} // namespace forefront
