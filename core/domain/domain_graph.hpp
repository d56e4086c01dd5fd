#pragma once

#include "core/domain/domain.hpp"
#include "core/domain/faces.hpp"
#include "core/geometry/plane_sweep.hpp"

#include <cstdint>
#include <vector>

namespace forefront {

/// What of a domain can take part in geometry: finite nodes that sound segments or constraint points refer to, sound
/// segments (indices in range, ends at different places), and finite markers. Of a valid domain, all of it.
struct DomainGraph {
    std::vector<Vec2> points;               ///< nodes, then hole markers, then region markers
    std::vector<std::uint32_t> node;        ///< per point that is a node: its index in the domain
    std::vector<std::uint32_t> pointOfNode; ///< per node of the domain: its point, or kNoIndex
    std::vector<PlaneEdge> edges;
    std::vector<std::uint32_t> segment;      ///< per edge: its index in the domain
    std::vector<std::uint32_t> holeMarker;   ///< per hole marker of the domain: its point, or kNoIndex
    std::vector<std::uint32_t> regionMarker; ///< likewise
};

DomainGraph graphOf(const Domain &domain);

/// What the faces of a domain are.
struct FaceLabels {
    std::vector<std::uint8_t> inside;  ///< per face
    std::vector<std::int32_t> tag;     ///< per face, by region markers; 1 where there is none
    std::vector<std::uint32_t> marker; ///< per face: the first region marker in it, or kNoIndex
};

/// Inside by the domain's rule, tags by its markers. Under EvenOdd an even number of boundary segments must meet in
/// every node.
FaceLabels labelFaces(const Domain &domain, const DomainGraph &graph, const Faces &faces);

} // namespace forefront
