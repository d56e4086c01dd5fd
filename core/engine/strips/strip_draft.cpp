#include "core/engine/base/ids.hpp"
#include "core/engine/strips/strip_ends.hpp"

#include <algorithm>
#include <utility>

namespace forefront {

StripDraft::StripDraft(const Domain &given, const SegmentElements &counts)
    : domain(given), removed(given.segments.size(), false), around_(given.nodes.size()) {
    for (std::uint32_t s = 0; s < domain.segments.size(); ++s) {
        elements.push_back(counts[s]);
        biases.push_back(counts.bias(s));
        around_[domain.segments[s].a].push_back(s);
        around_[domain.segments[s].b].push_back(s);
    }
    for (const ConstraintPoint &point : domain.points) {
        points_.insert(point.node);
    }
}

std::uint32_t StripDraft::addNode(Vec2 at) {
    domain.nodes.push_back(at);
    around_.emplace_back();
    return static_cast<std::uint32_t>(domain.nodes.size() - 1);
}

std::uint32_t StripDraft::addSegment(const DomainSegment &segment, std::uint32_t count) {
    const auto s = static_cast<std::uint32_t>(domain.segments.size());
    domain.segments.push_back(segment);
    elements.push_back(count);
    biases.emplace_back();
    removed.push_back(false);
    around_[segment.a].push_back(s);
    around_[segment.b].push_back(s);
    return s;
}

void StripDraft::remove(std::uint32_t s) {
    removed[s] = true;
    std::erase(around_[domain.segments[s].a], s);
    std::erase(around_[domain.segments[s].b], s);
}

void StripDraft::moveEnd(std::uint32_t s, std::uint32_t from, std::uint32_t to) {
    DomainSegment &segment = domain.segments[s];
    (segment.a == from ? segment.a : segment.b) = to;
    std::erase(around_[from], s);
    around_[to].push_back(s);
}

std::vector<std::uint32_t> StripDraft::addCurve(const Curve &curve, std::uint32_t chords, std::uint32_t from,
                                                std::uint32_t to, const DomainSegment &like, std::uint32_t count) {
    const auto own = static_cast<std::uint32_t>(domain.curves.size());
    domain.curves.push_back(curve);
    std::vector<std::uint32_t> added;
    std::uint32_t node = from;
    for (std::uint32_t k = 0; k < chords; ++k) {
        const double t0 = static_cast<double>(k) / chords, t1 = static_cast<double>(k + 1) / chords;
        const std::uint32_t next = k + 1 == chords ? to : addNode(curve.point(t1));
        DomainSegment segment = like;
        segment.a = node;
        segment.b = next;
        segment.stretch = {own, t0, t1};
        added.push_back(addSegment(segment, count));
        node = next;
    }
    return added;
}

Domain StripDraft::finished(std::vector<std::uint32_t> &numbers, std::vector<std::uint32_t> &nodeNumbers) {
    nodeNumbers.assign(domain.nodes.size(), kNoIndex);
    for (std::uint32_t n = 0, next = 0; n < nodeNumbers.size(); ++n) {
        if (!around_[n].empty() || points_.contains(n)) {
            nodeNumbers[n] = next;
            domain.nodes[next++] = domain.nodes[n];
        }
    }
    domain.nodes.resize(nodeNumbers.size() - static_cast<std::size_t>(std::ranges::count(nodeNumbers, kNoIndex)));
    numbers.assign(domain.segments.size(), kNoIndex);
    std::uint32_t count = 0;
    for (std::uint32_t s = 0; s < numbers.size(); ++s) {
        if (!removed[s]) {
            DomainSegment segment = domain.segments[s];
            segment.a = nodeNumbers[segment.a];
            segment.b = nodeNumbers[segment.b];
            domain.segments[count] = segment;
            elements[count] = elements[s];
            biases[count] = biases[s];
            numbers[s] = count++;
        }
    }
    domain.segments.resize(count);
    elements.resize(count);
    biases.resize(count);
    for (ConstraintPoint &point : domain.points) {
        point.node = nodeNumbers[point.node];
    }
    return std::move(domain);
}

} // namespace forefront
