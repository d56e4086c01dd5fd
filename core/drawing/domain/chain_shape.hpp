#pragma once

#include "core/drawing/document/document.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/engine/domain/curve_chains.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// What to do about curves that do not quite end at their nodes, as joining lines leaves them.
enum class LooseEnds : std::uint8_t {
    MoveCurve, ///< the whole curve is moved a little, unless that would move it far elsewhere: then as below
    MoveChord, ///< the chord there becomes a curve of its own and is moved; all nodes stay where they are
};

/// Makes shapes from chains of a domain's segments. Consecutive segments that follow one curve become one curved
/// segment, which remembers them as its chords.
class ChainShapes {
  public:
    /// Keeps a reference to the domain, which must outlive it.
    explicit ChainShapes(const Domain &domain, LooseEnds ends = LooseEnds::MoveCurve);

    /// Returns true if some curve does not quite end at its nodes.
    bool anyLooseEnd() const;
    /// Returns a shape, without id, name and use, along segments in order: segment k joins nodes k and k+1; the last of
    /// a closed chain leads back to the first node. A loop around one ellipse becomes a circle or an ellipse.
    Shape make(std::span<const std::uint32_t> nodes, std::span<const std::uint32_t> segments, bool closed) const;

  private:
    struct Link {
        std::uint32_t from, to; ///< nodes of the domain
        std::uint32_t segment;
        CurveStretch stretch; ///< none if the segment is straight
    };
    std::vector<Link> linksOf(std::span<const std::uint32_t> nodes, std::span<const std::uint32_t> segments) const;
    bool continues(const Link &before, const Link &after) const;
    struct Loose {
        bool start = false, end = false;
    };
    Loose looseEnds(const Curve &curve, Vec2 start, Vec2 end) const;
    Curve alongRun(std::span<const Link> run) const;
    void addRuns(std::span<const Link> run, Shape &shape) const;
    void addRun(std::span<const Link> run, Shape &shape) const;
    Curve curveOf(std::span<const Link> run) const;
    void recogniseLoop(Shape &shape) const;

    const Domain &domain_;
    LooseEnds ends_;
    CurveChains chains_;
    double tolerance_; ///< distance between a curve and its ends that counts as rounding
};

/// Returns a document that shows a domain. Without `ends`, fromDomain() chooses them so that no fault is added.
Document fromDomain(const Domain &domain, LooseEnds ends);

} // namespace forefront
