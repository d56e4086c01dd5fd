#include "core/engine/mesher/strip_runner.hpp"

#include "core/engine/base/thread_pool.hpp"
#include "core/engine/grid/hierarchical_grid.hpp"
#include "core/engine/mesher/fast_advancer.hpp"
#include "core/engine/mesher/mesher.hpp"
#include "core/engine/mesher/strip_results.hpp"

#include <algorithm>
#include <atomic>
#include <optional>
#include <span>
#include <vector>

namespace forefront {

namespace {

/// A strip with its part of Γ and its state, nodes and elements among it.
struct StripRun {
    std::optional<FrontPart> part;
    std::optional<FrontState> state;
};

/// Returns the slots of Γ whose segments or points lie at least partly in each strip of a phase.
std::vector<std::vector<SlotId>> slotsByStrip(const GenerationFront &front, const FrontStrips &strips,
                                              std::size_t phase) {
    const std::size_t first = strips.phases[phase], end = strips.phases[phase + 1];
    std::vector<std::vector<SlotId>> lists(end - first);
    for (std::uint32_t i = 0; i < front.capacity(); ++i) {
        const SlotId id{i};
        if (!front[id].alive) {
            continue;
        }
        const Box2 box = boxOf(front.start(id), front.end(id));
        std::size_t strip = strips.stripAt(phase, box.min);
        while (strip > first && strips.boxes[strip - 1].overlaps(box)) {
            --strip;
        }
        for (; strip < end && strips.boxes[strip].overlaps(box); ++strip) {
            lists[strip - first].push_back(id);
        }
    }
    return lists;
}

/// Advances between checks for cancellation.
constexpr int kBatch = 4096;

class StripRunner {
  public:
    StripRunner(FrontState &state, const SpacingField &spacing, unsigned threads, const Progress &progress,
                double estimatedElements, std::uint64_t maxElements)
        : state_(state), spacing_(spacing), pool_(threads), progress_(progress), estimatedElements_(estimatedElements),
          maxElements_(maxElements), bounds_(boundsOf(state.nodes)) {}

    bool run() {
        const FrontStrips &strips = *state_.strips;
        for (std::size_t phase = 0; phase + 2 < strips.phases.size(); ++phase) {
            const std::size_t first = strips.phases[phase], last = strips.phases[phase + 1];
            std::vector<StripRun> runs(last - first);
            const std::vector<std::vector<SlotId>> slots = slotsByStrip(state_.front, strips, phase);
            StripResults results(state_, runs.size());
            pool_.run(runs.size(), [&](std::size_t task, unsigned thread) {
                prepare(runs[task], slots[task], first + task, results.firstNew());
                advance(runs[task], first + task, thread == 0);
                if (!stopped()) {
                    results.finished(task, *runs[task].state);
                }
            });
            if (stopped()) {
                return false;
            }
            merge(runs, first, results);
        }
        state_.strip = static_cast<std::uint32_t>(strips.boxes.size() - 1);
        state_.walk = {};
        state_.walkOrder.clear(state_.walkRules);
        offerAll(state_.walkOrder, state_.front, strips.boxes.back());
        return true;
    }

  private:
    bool stopped() const { return progress_.cancelled() || made_ > maxElements_; }

    static Box2 boundsOf(const std::vector<Vec2> &nodes) {
        Box2 box;
        for (const Vec2 p : nodes) {
            box.add(p);
        }
        return box;
    }

    /// Copies the parts of the whole that the strip needs.
    void prepare(StripRun &run, std::span<const SlotId> slots, std::size_t strip, std::uint32_t firstNew) const {
        run.part.emplace(state_.front.part(slots));
        run.state.emplace(state_, std::move(run.part->front), static_cast<std::uint32_t>(strip), firstNew);
    }

    void advance(StripRun &run, std::size_t strip, bool reports) {
        const Box2 &box = state_.strips->boxes[strip];
        FrontState &state = *run.state;
        const std::vector<std::size_t> &phases = state_.strips->phases;
        if (strip >= phases[1] && strip < phases[2]) { // this phase makes nearly all elements
            const auto share = static_cast<std::size_t>(Mesher::kReserve * estimatedElements_ /
                                                        static_cast<double>(phases[2] - phases[1]));
            state.elements.reserve(share);
            state.nodes.reserve(share / 2);
        }
        HierarchicalGrid grid({{std::max(box.min.x, bounds_.min.x), std::max(box.min.y, bounds_.min.y)},
                               {std::min(box.max.x, bounds_.max.x), std::min(box.max.y, bounds_.max.y)}},
                              FastAdvancer<HierarchicalGrid, NoTrace>::kCellPerLength);
        for (std::uint32_t i = 0; i < state.front.capacity(); ++i) {
            if (state.front.next(SlotId{i}) != kNoSlot) { // else its segment leads out of the part
                grid.insert(state.front, SlotId{i});
            }
        }
        state.walkOrder.clear(state.walkRules);
        offerAll(state.walkOrder, state.front, box);
        FastAdvancer<HierarchicalGrid, NoTrace> advancer(state, grid, spacing_, NoTrace{});
        AdvanceDelta delta;
        bool going = true;
        while (going && !stopped()) {
            const std::size_t before = state.elements.size();
            for (int i = 0; i < kBatch && going; ++i) {
                going = advancer.advance(delta);
            }
            made_ += state.elements.size() - before;
            if (reports) {
                progress_("advancing the front",
                          std::min(0.99, static_cast<double>(made_) / (estimatedElements_ + 1.0)));
            }
        }
    }

    void merge(std::vector<StripRun> &runs, std::size_t firstStrip, const StripResults &results) {
        for (std::size_t k = 0; k < runs.size(); ++k) {
            StripRun &run = runs[k];
            // Nb counts all of Γ, as when one strip follows the other.
            const std::uint64_t others = state_.front.segments() - run.part->segments;
            run.state->work.frontSum += run.state->work.advances * others;
            state_.work.add(run.state->work);
            run.part->front = std::move(run.state->front);
            state_.front.adopt(*run.part, state_.strips->boxes[firstStrip + k], results.firstNew(), results.shift(k));
            run.part.reset();
        }
    }

    FrontState &state_;
    const SpacingField &spacing_;
    ThreadPool pool_;
    const Progress &progress_;
    double estimatedElements_;
    std::uint64_t maxElements_;
    Box2 bounds_;
    std::atomic<std::uint64_t> made_ = 0; ///< elements, in all strips so far
};

} // namespace

bool runStrips(FrontState &state, const SpacingField &spacing, unsigned threads, const Progress &progress,
               double estimatedElements, std::uint64_t maxElements) {
    return StripRunner(state, spacing, threads, progress, estimatedElements, maxElements).run();
}

} // namespace forefront
