#include "core/engine/quads/quad_cleanup.hpp"

#include "core/engine/quads/quad_smooth.hpp"

#include <algorithm>
#include <cmath>

namespace forefront {

namespace {

// The loss of an element: 0 for a square as large as the node spacing asks. The weights were measured on graded
// domains: a higher weight of the size raises δ and lowers the scaled Jacobian.
constexpr double kSizeLoss = 0.35;
constexpr double kMaxSizeLoss = 4.0; ///< of a side
constexpr double kLeastLoss = 0.15;  ///< of the worst corner
constexpr double kPoor = 0.7;        ///< scaled Jacobian below which an element loses more
constexpr double kPoorLoss = 2.0;
constexpr double kFlat = 0.05; ///< scaled Jacobian below which an element counts as flat
constexpr double kFlatLoss = 5.0;
// While curing: an element that is not convex loses more than the few convex ones that can take its place, each of
// which loses less than kCuringLoss, however sharp a given corner makes them.
constexpr double kCuringLoss = 100.0, kNotConvexLoss = 400.0;
constexpr double kConvex = 1e-6; ///< minimum scaled Jacobian of an element that counts as convex
// The loss of a node whose valence is off by one, and for each further element.
constexpr double kValenceLoss = 0.1, kMoreValenceLoss = 0.25;
constexpr double kDoubletLoss = 1.0;
constexpr double kFlatCornerLoss = 2.0; ///< of a straight angle that is one element's corner

constexpr double kMinGain = 1e-3;      ///< of a change
constexpr double kMinCuringGain = 5.0; ///< more than a change gains that leaves the flat element as it is
constexpr unsigned kRegionRings = 2;   ///< elements around a change that are smoothed and compared
constexpr std::size_t kMaxTrials = 12; ///< per node and pass
constexpr double kSpring = 0.5;
constexpr unsigned kCuringRounds = 3;
constexpr double kCuredShape = 0.4; ///< minimum scaled Jacobian that curing aims at
constexpr double kGoodShape = 0.75; ///< minimum scaled Jacobian that guarded smoothing and polishing aim at

ImproveChange changeOf(QuadChange::Kind kind) {
    switch (kind) {
    case QuadChange::Kind::Collapse:
        return ImproveChange::Collapse;
    case QuadChange::Kind::Rotate:
        return ImproveChange::Rotate;
    case QuadChange::Kind::Split:
        return ImproveChange::Split;
    case QuadChange::Kind::Doublet:
        return ImproveChange::Doublet;
    case QuadChange::Kind::Raise:
        return ImproveChange::Raise;
    case QuadChange::Kind::Insert:
        return ImproveChange::Insert;
    case QuadChange::Kind::Inset:
        return ImproveChange::Inset;
    }
    return ImproveChange::Pass;
}

} // namespace

double QuadCleanup::elementLoss(const QuadCell &cell) const {
    const unsigned n = cornersOf(cell);
    std::array<Vec2, 4> side{};
    std::array<double, 4> length2{}, lengths{};
    for (unsigned k = 0; k < n; ++k) {
        side[k] = mesh_.nodes[nextCorner(cell, k)] - mesh_.nodes[cell[k]];
        length2[k] = lengthSquared(side[k]);
        lengths[k] = std::sqrt(length2[k]);
    }
    double shape = 0.0, size = 0.0, least = 2.0;
    for (unsigned k = 0; k < n; ++k) {
        const unsigned j = k == 0 ? n - 1 : k - 1;
        const double area = cross(side[j], side[k]);
        shape += 1.0 - 2.0 * area / (length2[j] + length2[k] + 1e-300);
        least = std::min(least, area / (lengths[j] * lengths[k] + 1e-300));
        const double rho = 0.5 * (double{mesh_.rho[cell[k]]} + double{mesh_.rho[nextCorner(cell, k)]});
        const double t = lengths[k] / rho, x = t - 1.0 / (t + 1e-300);
        size += std::min(0.25 * x * x, kMaxSizeLoss);
    }
    double poor = std::max(0.0, kPoor - least) * kPoorLoss;
    if (least < kFlat) {
        poor += !curing_          ? kFlatLoss
                : least < kConvex ? kNotConvexLoss - kCuringLoss * least
                                  : kCuringLoss * (1.0 - least / kFlat);
    }
    return (shape + kSizeLoss * size) / n + kLeastLoss * (1.0 - least) + poor;
}

double QuadCleanup::nodeLoss(std::uint32_t node) const {
    double loss = 0.0;
    const bool fixed = mesh_.isFixed(node);
    mesh_.forEachSector(node, [&](std::uint32_t count, std::uint32_t target) {
        if (count == target || count == 0) {
            return;
        }
        const unsigned off = count > target ? count - target : target - count;
        loss += off == 1 ? kValenceLoss : kMoreValenceLoss * (off - 1);
        if (fixed) {
            loss += count == 1 ? kFlatCornerLoss : 0.0;
        } else {
            loss += count == 2 ? kDoubletLoss : 0.0;
        }
    });
    return loss;
}

double QuadCleanup::regionLoss() const {
    double sum = 0.0;
    for (const std::uint32_t cell : regionCells_) {
        sum += isAlive(mesh_.cells[cell]) ? elementLoss(mesh_.cells[cell]) : 0.0;
    }
    for (const std::uint32_t node : regionNodes_) {
        sum += mesh_.valence(node) > 0 ? nodeLoss(node) : 0.0;
    }
    return sum;
}

/// Collects the elements within a few rings of those that a change removes, and the nodes inside.
void QuadCleanup::gatherRegion(const QuadChange &change) {
    nodeStamps_.resize(std::max(nodeStamps_.size(), mesh_.nodes.size() + QuadChange::kMaxNodes), 0);
    cellStamps_.resize(std::max(cellStamps_.size(), mesh_.cells.size() + QuadChange::kMost), 0);
    ++stamp_;
    regionNodes_.clear();
    regionCells_.clear();
    const auto addNodes = [&](const QuadCell &cell) {
        for (unsigned k = 0; k < cornersOf(cell); ++k) {
            if (nodeStamps_[cell[k]] != stamp_) {
                nodeStamps_[cell[k]] = stamp_;
                regionNodes_.push_back(cell[k]);
            }
        }
    };
    for (unsigned i = 0; i < change.removedCount; ++i) {
        addNodes(mesh_.cells[change.removed[i]]);
    }
    std::size_t from = 0;
    for (unsigned ring = 1; ring <= kRegionRings; ++ring) {
        const std::size_t to = regionNodes_.size();
        for (std::size_t i = from; i < to; ++i) {
            for (const std::uint32_t cell : mesh_.around[regionNodes_[i]]) {
                if (cellStamps_[cell] != stamp_) {
                    cellStamps_[cell] = stamp_;
                    regionCells_.push_back(cell);
                    if (ring < kRegionRings) {
                        addNodes(mesh_.cells[cell]);
                    }
                }
            }
        }
        from = to;
    }
}

void QuadCleanup::make(const QuadChange &change) {
    oldPlaces_.clear();
    for (const std::uint32_t node : regionNodes_) {
        oldPlaces_.push_back(mesh_.nodes[node]);
    }
    const std::uint32_t face = mesh_.faceOf(change.removed[0]);
    const float rho = mesh_.rho[mesh_.cells[change.removed[0]][0]];
    for (unsigned i = 0; i < change.removedCount; ++i) {
        oldCells_[i] = mesh_.cells[change.removed[i]];
        mesh_.take(change.removed[i]);
    }
    for (unsigned k = 0; k < change.nodeCount; ++k) {
        newNodes_[k] = mesh_.newNode(change.places[k], rho);
        regionNodes_.push_back(newNodes_[k]);
    }
    for (unsigned i = 0; i < change.addedCount; ++i) {
        QuadCell cell = change.added[i];
        for (std::uint32_t &node : cell) {
            for (unsigned k = 0; k < change.nodeCount; ++k) {
                node = node == QuadChange::newNode(k) ? newNodes_[k] : node;
            }
        }
        const bool reuse = i < change.removedCount;
        newCells_[i] = reuse ? change.removed[i] : mesh_.newCell();
        mesh_.put(newCells_[i], cell, face);
        if (!reuse) {
            regionCells_.push_back(newCells_[i]);
        }
    }
    if (change.moved != kNoIndex) {
        mesh_.nodes[change.moved] = change.to;
    }
}

void QuadCleanup::unmake(const QuadChange &change) {
    const std::uint32_t face = mesh_.faceOf(newCells_[0]);
    for (unsigned i = change.addedCount; i-- > 0;) {
        mesh_.take(newCells_[i]);
        if (i >= change.removedCount) {
            mesh_.release(newCells_[i]);
        }
    }
    for (unsigned i = 0; i < change.removedCount; ++i) {
        mesh_.put(change.removed[i], oldCells_[i], face);
    }
    for (unsigned k = change.nodeCount; k-- > 0;) {
        mesh_.releaseNode(newNodes_[k]);
    }
    for (std::size_t i = 0; i < oldPlaces_.size(); ++i) {
        mesh_.nodes[regionNodes_[i]] = oldPlaces_[i];
    }
}

/// Makes room for the records of all nodes. New ones count as changed since they were last tried, whoever comes first.
void QuadCleanup::growRecords() {
    triedAt_.resize(mesh_.nodes.size(), 0);
    changedAt_.resize(mesh_.nodes.size(), 1);
}

void QuadCleanup::tell(ImproveChange change) {
    if (watch_ != nullptr) {
        watch_->changed(change, mesh_, {});
    }
}

/// Tells of a change of the elements around a node, with its trial's smoothing.
void QuadCleanup::tell(const QuadChange &change, std::size_t refused) {
    if (watch_ == nullptr) {
        return;
    }
    toldCells_.assign(change.removed.begin(), change.removed.begin() + change.removedCount);
    toldCells_.insert(toldCells_.end(), newCells_.begin(), newCells_.begin() + change.addedCount);
    watch_->changed(changeOf(change.kind), mesh_, {false, regionNodes_, toldCells_, refused});
}

/// Keeps a change: the node and the elements that it has left over can be used again.
void QuadCleanup::settle(const QuadChange &change, std::size_t refused) {
    tell(change, refused);
    ++changes_;
    ++clock_;
    growRecords();
    for (const std::uint32_t node : regionNodes_) {
        changedAt_[node] = clock_;
        if (node != change.killed && mesh_.isIrregular(node)) {
            pending_.push_back(node);
        }
    }
    if (change.killed != kNoIndex) {
        mesh_.releaseNode(change.killed);
    }
    for (unsigned i = change.addedCount; i < change.removedCount; ++i) {
        mesh_.release(change.removed[i]);
    }
}

/// Makes a change, and undoes it unless it pays. `refused`: changes tried before at the same place.
bool QuadCleanup::attempt(const QuadChange &change, std::size_t refused) {
    gatherRegion(change);
    const double before = regionLoss();
    make(change);
    // In the narrow triangle that an element with a flat corner is, squaring the corners would push nodes outside.
    const unsigned sweeps = change.kind == QuadChange::Kind::Inset ? 0 : effort_.trialSweeps;
    for (unsigned sweep = 0; sweep < sweeps; ++sweep) {
        for (const std::uint32_t node : regionNodes_) {
            if (!mesh_.isFixed(node) && mesh_.valence(node) > 0) {
                mesh_.nodes[node] = squaringPlace(mesh_, node, kSpring);
            }
        }
    }
    for (unsigned round = 0; curing_ && round < kCuringRounds; ++round) {
        for (const std::uint32_t node : regionNodes_) {
            polishNode(mesh_, node, kCuredShape);
        }
    }
    if (regionLoss() < before - (curing_ ? kMinCuringGain : kMinGain)) {
        settle(change, refused);
        return true;
    }
    unmake(change);
    return false;
}

/// Tries the changes around an irregular node. Returns true if one was kept.
bool QuadCleanup::treat(std::uint32_t node) {
    growRecords();
    if (triedAt_[node] >= changedAt_[node] || mesh_.valence(node) == 0 || !mesh_.isIrregular(node)) {
        return false;
    }
    triedAt_[node] = clock_;
    found_.clear();
    findChanges(mesh_, node, effort_.generous, found_);
    for (std::size_t i = 0; i < std::min(found_.size(), kMaxTrials); ++i) {
        if (attempt(found_[i], i)) {
            return true;
        }
    }
    return false;
}

/// Treats all irregular nodes, and those that become irregular. Returns false if nothing was changed or it was
/// cancelled.
bool QuadCleanup::pass(const Progress &progress, double from, double to) {
    constexpr std::size_t kMaxAgain = 6; // treatments per irregular node, on average
    pending_.clear();
    for (std::uint32_t n = 0; n < mesh_.nodes.size(); ++n) {
        if (mesh_.valence(n) > 0 && mesh_.isIrregular(n)) {
            pending_.push_back(n);
        }
    }
    const std::size_t before = changes_, most = kMaxAgain * pending_.size();
    for (std::size_t i = 0; i < std::min(pending_.size(), most); ++i) {
        if (i % 64 == 0) {
            if (progress.cancelled()) {
                return false;
            }
            progress("cleaning up quadrilaterals",
                     std::lerp(from, to, static_cast<double>(i) / static_cast<double>(pending_.size())));
        }
        treat(pending_[i]);
    }
    return changes_ > before;
}

void QuadCleanup::removeDoublets() {
    QuadChange change;
    for (std::uint32_t n = 0; n < mesh_.nodes.size(); ++n) {
        if (describeDoublet(mesh_, n, change)) {
            gatherRegion(change);
            make(change);
            settle(change, 0);
        }
    }
}

/// Tries the changes around an element with a flat or reflex corner and, if none helps, a smaller element inside it:
/// then each of its corners belongs to two elements.
bool QuadCleanup::cure(std::uint32_t cell) {
    const QuadCell corners = mesh_.cells[cell];
    std::size_t refused = 0;
    for (unsigned k = 0; k < cornersOf(corners); ++k) {
        found_.clear();
        findChanges(mesh_, corners[k], true, found_);
        for (const QuadChange &change : found_) { // all of them: the one that helps may be the least regular
            if (attempt(change, refused++)) {
                return true;
            }
        }
    }
    QuadChange change;
    return describeInset(mesh_, cell, change) && attempt(change, refused);
}

/// Cures elements that are flat or inverted after everything else: near sharp corners and in narrow places of the
/// boundary.
void QuadCleanup::cureFlatElements(const Progress &progress) {
    constexpr unsigned kRounds = 4;
    curing_ = true;
    bool changed = true;
    for (unsigned round = 0; round < kRounds && changed; ++round) {
        changed = false;
        for (std::uint32_t cell = 0; cell < mesh_.cells.size() && !progress.cancelled(); ++cell) {
            if (isAlive(mesh_.cells[cell]) && mesh_.shapeOf(cell) < kFlat) {
                changed = cure(cell) || changed;
            }
        }
    }
    curing_ = false;
}

/// Smooths the whole mesh, sweep by sweep if the watch wants that: the places are the same.
void QuadCleanup::smooth(unsigned sweeps, void (*smoothing)(QuadWorkspace &, unsigned)) {
    if (watch_ == nullptr || !watch_->wantsSweeps()) {
        smoothing(mesh_, sweeps);
        tell(ImproveChange::Sweep);
        return;
    }
    for (unsigned s = 0; s < sweeps; ++s) {
        smoothing(mesh_, 1);
        tell(ImproveChange::Sweep);
    }
}

bool QuadCleanup::run(const Progress &progress) {
    constexpr auto freely = [](QuadWorkspace &mesh, unsigned sweeps) { smoothFreely(mesh, sweeps, kSpring); };
    constexpr auto guarded = [](QuadWorkspace &mesh, unsigned sweeps) {
        smoothGuarded(mesh, sweeps, kSpring, kGoodShape);
    };
    constexpr unsigned kPolishRounds = 4;
    const auto polish = [&] {
        polishShapes(mesh_, kGoodShape, kPolishRounds);
        tell(ImproveChange::Polish);
    };
    removeDoublets();
    tell(ImproveChange::Pass);
    smooth(effort_.firstSweeps, freely);
    for (unsigned k = 0; k < effort_.passes; ++k) {
        const double share = 0.9 / effort_.passes;
        const bool changed = pass(progress, share * k, share * (k + 1));
        tell(ImproveChange::Pass);
        mesh_.renewSpacing(spacing_);
        smooth(effort_.sweeps, freely);
        if (!changed) {
            break;
        }
    }
    progress("cleaning up quadrilaterals", 0.9);
    smooth(effort_.lastSweeps, guarded);
    polish();
    cureFlatElements(progress);
    tell(ImproveChange::Pass);
    polish();
    return !progress.cancelled();
}

} // namespace forefront
