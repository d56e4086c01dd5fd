#pragma once

#include "core/engine/base/result.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/domain/segment_elements.hpp"
#include "core/engine/spacing/sites/size_site.hpp"
#include "core/engine/strips/strip_lines.hpp"

#include <cstdint>
#include <set>
#include <vector>

namespace forefront {

/// A domain while lines are replaced by strips. Segments that are removed stay in the list until the end.
class StripDraft {
  public:
    StripDraft(const Domain &domain, const SegmentElements &elements);

    Domain domain;
    std::vector<std::uint32_t> elements;
    std::vector<ElementBias> biases;
    std::vector<bool> removed; ///< per segment

    std::uint32_t addNode(Vec2 at);
    std::uint32_t addSegment(const DomainSegment &segment, std::uint32_t count);
    void remove(std::uint32_t s);
    /// Makes a segment end at another node.
    void moveEnd(std::uint32_t s, std::uint32_t from, std::uint32_t to);
    const std::vector<std::uint32_t> &at(std::uint32_t node) const { return around_[node]; }
    std::uint32_t otherEnd(std::uint32_t s, std::uint32_t node) const {
        return domain.segments[s].a == node ? domain.segments[s].b : domain.segments[s].a;
    }
    bool isPoint(std::uint32_t node) const { return points_.contains(node); }
    /// Adds segments along a curve from one node to another. Returns them.
    std::vector<std::uint32_t> addCurve(const Curve &curve, std::uint32_t chords, std::uint32_t from, std::uint32_t to,
                                        const DomainSegment &like, std::uint32_t count);

    /// Returns the domain without removed segments and unused nodes; `elements` and `biases` follow. `numbers`
    /// receives, per segment of the draft, its index in the result.
    Domain finished(std::vector<std::uint32_t> &numbers, std::vector<std::uint32_t> &nodeNumbers);

  private:
    std::vector<std::vector<std::uint32_t>> around_; ///< per node: segments
    std::set<std::uint32_t> points_;                 ///< nodes of constraint points
};

/// The corners of a strip at one of its ends: nodes of the draft, seen along the strip.
struct StripEnd {
    std::uint32_t left = 0, right = 0;
    std::vector<std::uint32_t> segments; ///< across the strip
};

/// Makes an end of a strip, see widenedDomain(). `start`: of its two ends. `sites` receives the edges that the front
/// meets.
Result<StripEnd> addStripEnd(StripDraft &draft, const StripSpec &spec, const StripLine &line, bool start, double growth,
                             std::vector<SizeSite> &sites);

} // namespace forefront
