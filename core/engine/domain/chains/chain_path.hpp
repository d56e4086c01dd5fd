#pragma once

#include "core/engine/domain/curve_chains.hpp"
#include "core/engine/domain/domain.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// The treatment of curves that do not quite end at their nodes after lines were joined.
enum class LooseEnds : std::uint8_t {
    MoveCurve, ///< the whole curve is moved a little, unless that would move it far elsewhere: then as below
    MoveChord, ///< the chord there becomes a curve of its own and is moved; all nodes stay where they are
};

/// A chain of segments as a path of straight and curved parts. Part k leads from node k to node k + 1, the last one of
/// a closed path back to the first node.
struct ChainPath {
    bool closed = false;
    std::vector<Vec2> nodes;
    std::vector<std::int32_t> tags; ///< per part
    /// Per part, its curve, which ends at its nodes; of kind Line for a straight part. Empty: all parts are straight.
    std::vector<Curve> curves;
    /// Per part, the parameters between 0 and 1 at which its curve is divided into chords; 1 alone: it is a single
    /// chord. Empty for a straight part; no lists if all parts are straight.
    std::vector<std::vector<double>> cuts;
    /// For a path around one circle: its centre and the node; around one ellipse: its centre and the ends of two
    /// conjugate semi-axes, the node first. Empty for other paths. The only curve is the one that these give.
    std::vector<Vec2> round;
    /// Where a chord comes from.
    struct Chord {
        std::uint32_t node = 0; ///< of the domain, at which the chord begins
        std::uint32_t segment = 0;
    };
    std::vector<Chord> chords; ///< of all parts; a straight part has one
    std::uint32_t end = 0;     ///< last node of the domain along the chain
};

/// Makes paths of chains of a domain's segments. Consecutive segments that follow one curve become one part, which
/// remembers them as its chords.
class ChainPaths {
  public:
    /// Keeps a reference to the domain, which must outlive it.
    explicit ChainPaths(const Domain &domain, LooseEnds ends = LooseEnds::MoveCurve);

    /// Returns true if some curve does not quite end at its nodes.
    bool anyLooseEnd() const;
    /// Returns the path along segments in order: segment k joins nodes k and k + 1; the last of a closed chain leads
    /// back to the first node. A closed path starts where a curve ends.
    ChainPath make(std::span<const std::uint32_t> nodes, std::span<const std::uint32_t> segments, bool closed) const;

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
    void addRuns(std::span<const Link> run, ChainPath &path) const;
    void addRun(std::span<const Link> run, ChainPath &path) const;
    void addCurve(std::span<const Link> run, ChainPath &path) const;
    Curve curveOf(std::span<const Link> run) const;

    const Domain &domain_;
    LooseEnds ends_;
    CurveChains chains_;
    double tolerance_; ///< distance between a curve and its ends that counts as rounding
};

} // namespace forefront
