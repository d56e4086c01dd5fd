#include "core/engine/mesher/recorder.hpp"

#include "core/engine/front/order_key.hpp"
#include "core/engine/mesh/quality.hpp"
#include "core/engine/mesher/fan.hpp"

#include <algorithm>

namespace forefront {

void Recorder::event(Step step, std::uint32_t candidate, std::uint32_t test) {
    out_.events.push_back({step, candidate, test, static_cast<std::uint32_t>(out_.cells.size()),
                           static_cast<std::uint32_t>(out_.candidates.size()), out_.delivered});
}

void Recorder::eventWithTies(Step step, std::uint32_t candidate, std::size_t equal) {
    event(step, candidate);
    out_.events.back().equal = static_cast<std::uint32_t>(equal);
}

void Recorder::takeFirst(const FrontState &state, SlotId slotA) {
    roundsTies_ = true;
    rules_ = state.rules;
    first_ = firstBases(state.front, {rules_.base, rules_.seed}, slotA);
}

void Recorder::begin(const FrontState &state, const Base &base) {
    const bool walked = out_.walked;
    out_ = {};
    out_.walked = walked;
    out_.advance = state.work.advances + 1;
    out_.a = base.a;
    out_.b = base.b;
    out_.nodeA = base.nodeA;
    out_.nodeB = base.nodeB;
    out_.rules = rules_;
    out_.earlierDeferred = first_.earlierDeferred;
    eventWithTies(Step::TakeBase, kNoIndex, first_.equal);
}

void Recorder::evaluateSpacing(const Base &base) {
    out_.fieldRho = base.fieldRho;
    out_.rho = base.rho;
    out_.ideal = base.ideal;
    event(Step::EvaluateSpacing);
    event(Step::IdealPoint);
}

void Recorder::rank(const Base &base, std::span<const Candidate> candidates, double radius, bool withdrawn) {
    out_.searchRadius = radius;
    firstOfSearch_ = static_cast<std::uint32_t>(out_.candidates.size());
    recorded_.clear();
    const auto add = [&](Vec2 position, NodeId node, Verdict verdict) {
        CandidateTrace candidate;
        candidate.position = position;
        candidate.node = node;
        candidate.alpha = shapeFactor(base.a, base.b, position);
        candidate.rho = base.rho;
        candidate.deltaAC = spacingConformity(distance(base.a, position), base.rho);
        candidate.deltaCB = spacingConformity(distance(base.b, position), base.rho);
        candidate.score = rules_.score(candidate.alpha, candidate.deltaAC, candidate.deltaCB);
        candidate.verdict = verdict;
        out_.candidates.push_back(std::move(candidate));
    };
    for (std::size_t k = 0; k < candidates.size(); ++k) {
        const Candidate &c = candidates[k];
        // Where Γ passes through a node several times, each pass is tested, next to each other in the order.
        if (k > 0 && c.node != kNoNode && c.node == candidates[k - 1].node) {
            ++out_.candidates.back().passes;
        } else {
            add(c.position, c.node, Verdict::NotTried);
        }
        recorded_.push_back(static_cast<std::uint32_t>(out_.candidates.size() - 1));
    }
    if (withdrawn) {
        add(base.ideal, kNoNode, Verdict::Withdrawn);
    }
    event(Step::FindCandidates);
    event(Step::Score);
    const auto asGood = [&](const CandidateTrace &c) {
        return orderKey(c.score) == orderKey(candidates.front().score);
    };
    const auto ranked = out_.candidates.begin() + firstOfSearch_;
    const auto equal =
        roundsTies_ ? std::count_if(ranked, out_.candidates.end() - (withdrawn ? 1 : 0), asGood) : std::ptrdiff_t{0};
    eventWithTies(Step::Sort, candidates.empty() ? kNoIndex : firstOfSearch_, static_cast<std::size_t>(equal));
}

void Recorder::proposeFan(const Fan &fan) {
    CandidateTrace candidate;
    if (fan.segments > 1) {
        candidate.over.assign(fan.at.begin(), fan.at.begin() + fan.segments + 1);
    }
    candidate.position = fan.apex;
    // A group is as good as its worst element; A and B are the ends of its chain.
    candidate.alpha = shapeFactor(fan.at[0], fan.at[1], fan.apex);
    for (unsigned i = 1; i < fan.segments; ++i) {
        candidate.alpha = std::min(candidate.alpha, shapeFactor(fan.at[i], fan.at[i + 1], fan.apex));
    }
    candidate.rho = fan.size;
    candidate.deltaAC = spacingConformity(distance(fan.at[0], fan.apex), fan.size);
    candidate.deltaCB = spacingConformity(distance(fan.at[fan.segments], fan.apex), fan.size);
    propose(std::move(candidate), fan.rho, true);
}

void Recorder::proposeCorner(const FrontState &state, const Fan &corner, unsigned base) {
    const unsigned opposite = 2 - 2 * base;
    const Vec2 a = corner.at[base], b = corner.at[base + 1], c = corner.at[opposite];
    CandidateTrace candidate;
    candidate.over.assign(corner.at.begin() + base, corner.at.begin() + base + corner.segments);
    candidate.position = c;
    candidate.node = corner.nodes[opposite];
    candidate.alpha = shapeFactor(a, b, c);
    const FrontSlot &first = state.front[corner.slots[base]];
    const double fieldRho = 0.5 * (first.rho + state.front[corner.slots[base + 1]].rho);
    const double size = clampedToBase(fieldRho, first.length);
    candidate.rho = size;
    candidate.deltaAC = spacingConformity(distance(a, c), size);
    candidate.deltaCB = spacingConformity(distance(b, c), size);
    propose(std::move(candidate), fieldRho, false);
}

void Recorder::propose(CandidateTrace candidate, double fieldRho, bool newNode) {
    out_.fieldRho = fieldRho;
    out_.rho = candidate.rho;
    out_.ideal = candidate.position;
    event(Step::EvaluateSpacing);
    if (newNode) {
        event(Step::IdealPoint);
    }
    candidate.score = candidate.alpha * candidate.deltaAC * candidate.deltaCB;
    underTest_ = static_cast<std::uint32_t>(out_.candidates.size());
    out_.candidates.push_back(std::move(candidate));
    event(Step::FindCandidates);
    event(Step::Score);
    event(Step::Sort, underTest_);
}

void Recorder::beginTest(std::size_t k) {
    underTest_ = recorded_[k];
    event(Step::Test, underTest_);
}

void Recorder::testSegment(Vec2 from, Vec2 to, Vec2 a, Vec2 b, bool meets) {
    out_.tests.push_back({from, to, a, b, underTest_, meets});
    event(Step::Test, underTest_, static_cast<std::uint32_t>(out_.tests.size() - 1));
}

void Recorder::blockIdeal(Vec2 a, Vec2 b, double distance, double clearance) {
    underTest_ = static_cast<std::uint32_t>(out_.candidates.size() - 1);
    block(a, b);
    out_.candidates[underTest_].blockDistance = distance;
    out_.candidates[underTest_].blockClearance = clearance;
}

void Recorder::block(Vec2 a, Vec2 b) {
    CandidateTrace &candidate = out_.candidates[underTest_];
    candidate.blocked = true;
    candidate.blockA = a;
    candidate.blockB = b;
}

void Recorder::endTest(Verdict verdict) {
    CandidateTrace &candidate = out_.candidates[underTest_];
    candidate.verdict = verdict;
    candidate.blocked = candidate.blocked && verdict != Verdict::Accepted; // by an earlier pass of Γ through the node
    event(Step::Test, underTest_);
}

void Recorder::end(const FrontState &state, const AdvanceDelta &delta, Vec2 apex) {
    out_.deferred = delta.kind == AdvanceDelta::Kind::Deferral;
    if (!out_.deferred) {
        out_.apex = apex;
        out_.elements = delta.elements();
        const std::size_t first = state.elements.size() - delta.elements();
        out_.element = ElementId{static_cast<std::uint32_t>(first)};
        for (std::size_t e = first; e < state.elements.size(); ++e) {
            const auto at = [&](unsigned k) { return state.nodes[index(state.elements[e][k]) - state.firstNode]; };
            out_.made.push_back({at(0), at(1), at(2)});
        }
    }
    event(Step::Update);
    if (state.front.empty()) {
        event(Step::Finish);
    }
}

} // namespace forefront
