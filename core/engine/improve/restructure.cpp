#include "core/engine/improve/restructure.hpp"

#include "core/engine/improve/cutout.hpp"
#include "core/engine/improve/replace.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <utility>

namespace forefront {

namespace {

enum class Change : std::uint8_t { Swap, Merge, Divide };

/// A change to try on a cutout.
struct Trial {
    Change change;
    Cutout::Local a;
    unsigned b;    ///< Swap, Merge: the other end of the edge; Divide: the first position in the ring
    float promise; ///< the lower, the more promising
};

// Measured on graded meshes and discs: twice the time for more trials, sweeps and rounds raises α by 0.0003.
constexpr std::size_t kTrials = 4;
constexpr int kSweeps = 2;
constexpr int kRounds = 4;
constexpr float kMinGain = 0.04F;
/// Number of neighbours that move to the new node.
constexpr unsigned kTaken = 2;

/// Lists the most promising changes at the first node of a cutout that do not move valences away from 6.
class Trials {
  public:
    Trials(const Cutout &cutout, float stretch) : cutout_(cutout), stretch_(stretch) {
        const unsigned size = cutout[0].size;
        for (unsigned k = 0; k < size; ++k) {
            const Cutout::Local b = ring(k), c = ring(k + 1), d = ring(k + size - 1);
            addAtSpoke(k, b, c, d);
            if (cutout.inner(b)) {
                addAcross(b, c);
            }
        }
        std::stable_sort(all_.begin(), all_.end(),
                         [](const Trial &p, const Trial &q) { return p.promise < q.promise; });
        all_.resize(std::min(all_.size(), kTrials));
    }

    const std::vector<Trial> &best() const { return all_; }

  private:
    Cutout::Local ring(unsigned k) const { return cutout_[0].ring[k % cutout_[0].size]; }
    int valence(Cutout::Local n) const { return cutout_[n].valence; }
    static int off(int valence) { return (valence - 6) * (valence - 6); }
    /// Returns the change of (valence − 6)² when the valence of n changes.
    int step(Cutout::Local n, int by) const { return valence(n) == 0 ? 0 : off(valence(n) + by) - off(valence(n)); }
    int merged(Cutout::Local a, Cutout::Local b) const {
        return (valence(b) == 0 ? 0 : step(b, valence(a) - 4)) - off(valence(a));
    }

    /// Lists a change unless it increases `disorder`, Σ(valence − 6)². `crowding`: orders equal ones; where edges are
    /// too short, merging comes before dividing.
    void add(Change change, Cutout::Local a, unsigned b, int disorder, float crowding) {
        constexpr float kStretchWeight = 10.0F;
        if (disorder <= 0) {
            all_.push_back({change, a, b, static_cast<float>(disorder) + kStretchWeight * crowding});
        }
    }

    void addAtSpoke(unsigned k, Cutout::Local b, Cutout::Local c, Cutout::Local d) {
        add(Change::Swap, 0, b, step(0, -1) + step(b, -1) + step(c, +1) + step(d, +1), 0.0F);
        add(Change::Merge, 0, b, merged(0, b) + step(c, -1) + step(d, -1), stretch_);
        const int size = valence(0), taken = static_cast<int>(kTaken);
        if (size > taken + 2) {
            add(Change::Divide, 0, k,
                off(taken + 3) + off(size - taken + 1) - off(size) + step(d, +1) + step(ring(k + kTaken), +1),
                -stretch_);
        }
    }

    /// Adds the changes at the edge bc, across from the first node.
    void addAcross(Cutout::Local b, Cutout::Local c) {
        const Cutout::Local beyond = cutout_.before(b, c);
        add(Change::Swap, b, c, step(b, -1) + step(c, -1) + step(0, +1) + step(beyond, +1), 0.0F);
        if (cutout_.inner(c)) {
            add(Change::Merge, b, c, merged(b, c) + step(0, -1) + step(beyond, -1), stretch_);
        }
    }

    const Cutout &cutout_;
    float stretch_;
    std::vector<Trial> all_;
};

bool apply(Cutout &cutout, const Trial &trial) {
    switch (trial.change) {
    case Change::Swap:
        return cutout.swapEdge(trial.a, static_cast<Cutout::Local>(trial.b));
    case Change::Merge:
        return cutout.merge(trial.a, static_cast<Cutout::Local>(trial.b)) && cutout.balanceValences();
    case Change::Divide:
        return cutout.divide(trial.a, trial.b, kTaken) && cutout.balanceValences();
    }
    return false;
}

ImproveChange reported(Change change) {
    return change == Change::Swap    ? ImproveChange::RelaxedSwap
           : change == Change::Merge ? ImproveChange::Merge
                                     : ImproveChange::Divide;
}

/// The best change at a site.
struct Gain {
    float gain = 0.0F;
    Change change = Change::Swap;
    std::unique_ptr<std::pair<Cutout, Cutout>> cutouts; ///< before and after; null: no change improves the site
};

class Restructuring {
  public:
    Restructuring(ImproveWorkspace &work, RawVector<float> rho, double floor)
        : work_(work), floor_(floor), rho_(std::move(rho)), replacer_(work, rho_) {}

    RestructureCounts run(const Progress &progress) {
        for (int round = 0; round < kRounds && !progress.cancelled(); ++round) {
            marks_.resize(work_.mesh.nodes.size(), 0);
            const std::vector<NodeId> sites = findSites();
            const std::size_t block = blockFor(sites.size());
            for (std::size_t begin = 0; begin < sites.size() && !progress.cancelled(); begin += block) {
                changeAt({sites.data() + begin, std::min(block, sites.size() - begin)});
            }
        }
        replacer_.compact();
        work_.report(ImproveChange::Renumber);
        return counts_;
    }

  private:
    /// Marks of a node: no change was found there since it last changed; it changed in this block.
    static constexpr std::uint8_t kQuiet = 1, kTouched = 2;

    /// Returns the number of sites of a block, so few that their changes seldom overlap.
    static std::size_t blockFor(std::size_t sites) { return std::clamp<std::size_t>(sites / 16, 128, 512); }

    bool isSite(std::size_t n) const { return work_.isFree(n) && work_.valence[n] != 6 && (marks_[n] & kQuiet) == 0; }

    /// Returns the sites in an order in which those of a block are seldom adjacent.
    std::vector<NodeId> findSites() const {
        std::vector<NodeId> sites;
        for (std::size_t n = 0; n < work_.mesh.nodes.size(); ++n) {
            if (isSite(n)) {
                sites.push_back(NodeId{static_cast<std::uint32_t>(n)});
            }
        }
        // A larger stride avoids more overlaps, but leaves nothing in the caches for the next block.
        constexpr std::size_t kMaxStride = 8;
        const std::size_t block = blockFor(sites.size());
        const std::size_t stride = std::clamp<std::size_t>(sites.size() / block, 1, kMaxStride);
        std::vector<NodeId> spread;
        spread.reserve(sites.size());
        for (std::size_t window = 0; window < sites.size(); window += stride * block) {
            const std::size_t end = std::min(window + stride * block, sites.size());
            for (std::size_t first = window; first < std::min(window + stride, end); ++first) {
                for (std::size_t i = first; i < end; i += stride) {
                    spread.push_back(sites[i]);
                }
            }
        }
        return spread;
    }

    void changeAt(std::span<const NodeId> sites) {
        constexpr std::size_t kTask = 16;
        std::vector<Gain> gains(sites.size());
        work_.pool.forChunks(sites.size(), kTask, [&](std::size_t begin, std::size_t end, std::size_t) {
            for (std::size_t i = begin; i < end; ++i) {
                gains[i] = isSite(index(sites[i])) ? inspect(sites[i]) : Gain{};
            }
        });
        std::vector<std::size_t> order;
        for (std::size_t i = 0; i < sites.size(); ++i) {
            if (gains[i].cutouts) {
                order.push_back(i);
            } else if (isSite(index(sites[i]))) {
                marks_[index(sites[i])] |= kQuiet;
            }
        }
        std::stable_sort(order.begin(), order.end(),
                         [&](std::size_t i, std::size_t j) { return gains[i].gain > gains[j].gain; });
        for (const std::size_t i : order) {
            keep(sites[i], gains[i]);
        }
        for (const NodeId n : touched_) {
            marks_[index(n)] = 0;
        }
        touched_.clear();
    }

    Gain inspect(NodeId site) const {
        Gain found;
        Cutout base;
        if (!base.take(work_, rho_, site)) {
            return found;
        }
        const Cutout::Loss before = base.loss();
        if (!std::isfinite(before.sum) || !std::isfinite(before.stretch)) { // lengths beyond the range of float
            return found;
        }
        const Trials trials(base, before.stretch);
        float best = kMinGain;
        for (const Trial &trial : trials.best()) {
            Cutout changed = base;
            if (!apply(changed, trial)) {
                continue;
            }
            changed.relax(kSweeps, kBestAims);
            const Cutout::Loss after = changed.loss();
            const float gain = before.sum - after.sum;
            if (gain > best && static_cast<double>(after.minAlpha) >= floor_) {
                best = gain;
                found = {gain, trial.change, std::make_unique<std::pair<Cutout, Cutout>>(base, changed)};
            }
        }
        return found;
    }

    /// Makes the change unless it overlaps another change of this block; then the site is tried again in the next
    /// round.
    void keep(NodeId site, const Gain &gain) {
        const auto &[before, after] = *gain.cutouts;
        for (unsigned n = 0; n < before.count(); ++n) {
            if ((marks_[index(before[n].id)] & kTouched) != 0) {
                return;
            }
        }
        if (!replacer_.replace(before, after, floor_)) {
            marks_[index(site)] |= kQuiet;
            return;
        }
        work_.report(reported(gain.change), replacer_.changed());
        marks_.resize(work_.mesh.nodes.size(), 0);
        for (unsigned n = 0; n < before.count(); ++n) {
            if (before.inner(static_cast<Cutout::Local>(n))) {
                marks_[index(before[n].id)] |= kTouched;
                touched_.push_back(before[n].id);
            }
        }
        ++(gain.change == Change::Swap    ? counts_.swapped
           : gain.change == Change::Merge ? counts_.merged
                                          : counts_.divided);
    }

    ImproveWorkspace &work_;
    double floor_;
    RawVector<float> rho_;
    Replacer replacer_;
    RestructureCounts counts_;
    std::vector<std::uint8_t> marks_; ///< per node
    std::vector<NodeId> touched_;
};

} // namespace

RestructureCounts restructure(ImproveWorkspace &work, RawVector<float> rho, double floor, const Progress &progress) {
    return Restructuring(work, std::move(rho), floor).run(progress);
}

} // namespace forefront
