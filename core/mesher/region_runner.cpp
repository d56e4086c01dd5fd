#include "core/mesher/region_runner.hpp"

#include "core/base/thread_pool.hpp"
#include "core/grid/hierarchical_grid.hpp"
#include "core/mesher/fast_advancer.hpp"
#include "core/mesher/mesher.hpp"
#include "core/mesher/region_results.hpp"

#include <algorithm>
#include <optional>

namespace forefront {

namespace {

/// One region with its part of Γ and what has been made in it.
struct RegionRun {
    std::optional<FrontPart> part;
    std::optional<FrontState> state;
};

/// Advances between looks at the stop token.
constexpr int kBatch = 4096;

class RegionRunner {
  public:
    RegionRunner(FrontState &state, const SpacingField &spacing, double slack, unsigned threads,
                 const Progress &progress, double estimatedElements)
        : state_(state), spacing_(spacing), slack_(slack), pool_(threads), progress_(progress),
          estimatedElements_(estimatedElements), bounds_(boundsOf(state.nodes)) {}

    bool run() {
        const FrontRegions &regions = *state_.regions;
        for (std::size_t phase = 0; phase + 2 < regions.phases.size(); ++phase) {
            const std::size_t first = regions.phases[phase], last = regions.phases[phase + 1];
            std::vector<RegionRun> runs(last - first);
            RegionResults results(state_, runs.size());
            pool_.run(runs.size(), [&](std::size_t task, unsigned thread) {
                prepare(runs[task], first + task, results.firstNew());
                advance(runs[task], first + task, thread == 0);
                if (!progress_.cancelled()) {
                    results.finished(task, *runs[task].state);
                }
            });
            if (progress_.cancelled()) {
                return false;
            }
            putTogether(runs, first, results);
        }
        state_.region = static_cast<std::uint32_t>(regions.boxes.size() - 1);
        state_.walk = {};
        state_.walkOrder.clear(state_.care.fineClasses);
        offerAll(state_.walkOrder, state_.front, regions.boxes.back());
        return true;
    }

  private:
    static Box2 boundsOf(const std::vector<Vec2> &nodes) {
        Box2 box;
        for (const Vec2 p : nodes) {
            box.add(p);
        }
        return box;
    }

    /// Takes what the region needs of the whole.
    void prepare(RegionRun &run, std::size_t region, std::uint32_t firstNew) const {
        run.part.emplace(state_.front.part(state_.regions->boxes[region]));
        run.state.emplace(state_, std::move(run.part->front), static_cast<std::uint32_t>(region), firstNew);
    }

    void advance(RegionRun &run, std::size_t region, bool reports) {
        const Box2 &box = state_.regions->boxes[region];
        FrontState &state = *run.state;
        const std::vector<std::size_t> &phases = state_.regions->phases;
        if (region >= phases[1] && region < phases[2]) { // the strips: other phases only make what these cannot
            const auto share = static_cast<std::size_t>(Mesher::kRoom * estimatedElements_ /
                                                        static_cast<double>(phases[2] - phases[1]));
            state.elements.reserve(share);
            state.nodes.reserve(share / 2);
        }
        HierarchicalGrid grid({{std::max(box.min.x, bounds_.min.x), std::max(box.min.y, bounds_.min.y)},
                               {std::min(box.max.x, bounds_.max.x), std::min(box.max.y, bounds_.max.y)}},
                              slack_, FastAdvancer<HierarchicalGrid, NoTrace>::kCellPerLength);
        for (std::uint32_t i = 0; i < state.front.capacity(); ++i) {
            if (state.front.next(SlotId{i}) != kNoSlot) { // else its segment leads out of the part
                grid.insert(state.front, SlotId{i});
            }
        }
        state.walkOrder.clear(state.care.fineClasses);
        offerAll(state.walkOrder, state.front, box);
        FastAdvancer<HierarchicalGrid, NoTrace> advancer(state, grid, spacing_, slack_, NoTrace{});
        AdvanceDelta delta;
        bool going = true;
        while (going && !progress_.cancelled()) {
            for (int i = 0; i < kBatch && going; ++i) {
                going = advancer.advance(delta);
            }
            report(state, reports);
        }
    }

    void report(const FrontState &state, bool reports) {
        if (reports) {
            progress_("advancing the front",
                      std::min(0.99, static_cast<double>(done_ + state.elements.size()) / (estimatedElements_ + 1.0)));
        }
    }

    void putTogether(std::vector<RegionRun> &runs, std::size_t firstRegion, const RegionResults &results) {
        for (std::size_t k = 0; k < runs.size(); ++k) {
            RegionRun &run = runs[k];
            // Nb: of all Γ, as it is when one region follows the other.
            const std::uint64_t others = state_.front.segments() - run.part->segments;
            run.state->work.frontSum += run.state->work.advances * others;
            state_.work.add(run.state->work);
            run.part->front = std::move(run.state->front);
            state_.front.adopt(*run.part, state_.regions->boxes[firstRegion + k], results.firstNew(), results.shift(k));
            run.part.reset();
        }
        done_ = state_.elements.size();
    }

    FrontState &state_;
    const SpacingField &spacing_;
    double slack_;
    ThreadPool pool_;
    const Progress &progress_;
    double estimatedElements_;
    Box2 bounds_;
    std::size_t done_ = 0; ///< elements of the phases before
};

} // namespace

bool runRegions(FrontState &state, const SpacingField &spacing, double slack, unsigned threads,
                const Progress &progress, double estimatedElements) {
    return RegionRunner(state, spacing, slack, threads, progress, estimatedElements).run();
}

} // namespace forefront
