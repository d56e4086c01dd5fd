#pragma once

#include "core/mesher/front_state.hpp"
#include "core/mesher/trace.hpp"

namespace forefront {

/// Records nothing and costs nothing: every call vanishes at compile time.
struct NoTrace {
    static constexpr bool kRecords = false;

    template <class Base>
    void begin(const FrontState &, const Base &) {}
    void end(const FrontState &, const AdvanceDelta &, Vec2) {}
};

/// Records one advance into an AdvanceExplanation.
struct Recorder {
    static constexpr bool kRecords = true;

    AdvanceExplanation &out;

    void event(Step step, std::uint32_t candidate = kNoIndex, std::uint32_t test = kNoIndex) {
        out.events.push_back({step, candidate, test, static_cast<std::uint32_t>(out.cells.size()),
                              static_cast<std::uint32_t>(out.candidates.size())});
    }
    /// Step 2, before anything is searched.
    template <class Base>
    void begin(const FrontState &state, const Base &base) {
        out.advance = state.work.advances + 1;
        out.a = base.a;
        out.b = base.b;
        out.nodeA = base.nodeA;
        out.nodeB = base.nodeB;
        event(Step::TakeBase);
    }
    /// Steps 9 and 10, after Γ has changed.
    void end(const FrontState &state, const AdvanceDelta &delta, Vec2 apex) {
        out.deferred = delta.kind == AdvanceDelta::Kind::Deferral;
        if (!out.deferred) {
            out.apex = apex;
            out.elements = delta.elements();
            const std::size_t first = state.elements.size() - delta.elements();
            out.element = ElementId{static_cast<std::uint32_t>(first)};
            for (std::size_t e = first; e < state.elements.size(); ++e) {
                const auto at = [&](unsigned k) { return state.nodes[index(state.elements[e][k]) - state.firstNode]; };
                out.made.push_back({at(0), at(1), at(2)});
            }
        }
        event(Step::Update);
        if (state.front.empty()) {
            event(Step::Finish);
        }
    }
};

} // namespace forefront
