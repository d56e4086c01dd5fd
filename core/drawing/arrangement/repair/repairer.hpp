#pragma once

#include "core/drawing/arrangement/curves/joined_lines.hpp"
#include "core/drawing/arrangement/repair/repair.hpp"
#include "core/engine/domain/domain_graph.hpp"
#include "core/engine/domain/faces.hpp"

#include <cstdint>
#include <map>
#include <stop_token>
#include <utility>
#include <vector>

namespace forefront {

/// Repairs one domain; see repair().
class Repairer {
  public:
    explicit Repairer(const Domain &domain) : given_(domain) {}

    Result<Repaired> run(double tolerance, const std::stop_token &stop);

  private:
    /// A joined edge: its origin, and whether it is kept.
    struct Edge {
        std::uint32_t source = kNoIndex; ///< the given segment whose tag it takes
        std::uint32_t line = kNoIndex;   ///< the part of that segment which runs along it
        std::uint32_t boundaries = 0;    ///< number of boundary segments along it; 0: a constraint
        bool shared = false;             ///< boundaries that cancelled out
        bool dropped = false;
    };

    bool valid(const DomainSegment &segment) const;
    void collectLines();
    JoinedLines join(double tolerance, const std::stop_token &stop) const;
    bool keepsNodes(const JoinedLines &kept, double resolution, const std::stop_token &stop) const;
    void takeLines(JoinedLines lines);
    void collectEdges();
    void resolveRepeats();
    void dropOutside(const std::stop_token &stop);
    bool closed(const Domain &joined, const Faces &faces, const FaceLabels &labels) const;
    std::vector<std::uint8_t> outsideEdges(const Domain &joined, const Faces &faces, const FaceLabels &labels) const;
    std::vector<std::vector<std::uint32_t>> loopsOfEdges(std::map<std::uint32_t, double> &size) const;
    std::vector<std::pair<Vec2, std::uint32_t>> openHoles(const DomainGraph &graph, const Faces &faces,
                                                          FaceLabels &labels) const;
    void dropEdge(std::uint32_t edge);
    void dropPoints(const DomainGraph &graph, const Faces &faces, const FaceLabels &labels);
    void dropHoleMarkers(const DomainGraph &graph, const Faces &faces);
    Domain joinedDomain() const;

    void build();
    void mapNodes();
    void addNodes();
    void addSegments();
    std::uint32_t nodeNumber(std::uint32_t joinedNode);
    std::uint32_t renumbered(std::uint32_t node) const;
    void locateChanges();
    DomainPart partOfLine(std::uint32_t line) const;

    const Domain &given_;
    JoinedLines lines_;                    ///< valid segments, some of them in parts, then constraint points
    std::vector<std::uint32_t> segmentOf_; ///< per line that is a segment or part of one
    std::vector<std::uint32_t> pointOf_;   ///< per line that is a constraint point
    SnappedLines &joined_ = lines_.snapped;
    std::vector<Edge> edges_;                 ///< per joined edge
    std::vector<std::uint8_t> pointDropped_;  ///< per input constraint point
    std::vector<std::uint8_t> markerDropped_; ///< per input hole marker
    std::vector<std::uint32_t> joinedNode_;   ///< per input node: the joined node it became, or kNoIndex
    std::vector<std::uint32_t> number_;       ///< per joined node: its index in the result, or kNoIndex
    std::vector<std::uint32_t> ownNumber_; ///< per input node that was not joined: its index in the result, or kNoIndex
    ChangeList changes_;
    Repaired result_;
};

} // namespace forefront
