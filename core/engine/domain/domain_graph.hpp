#pragma once

#include "core/engine/domain/domain.hpp"
#include "core/engine/domain/faces.hpp"
#include "core/engine/geometry/plane_sweep.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// The parts of a domain that have a geometry: segments with valid indices and distinct finite ends, the nodes they and
/// constraint points refer to, and finite markers. For a valid domain, all of it.
struct DomainGraph {
    std::vector<Vec2> points;               ///< nodes, then hole markers, region markers and other places
    std::vector<std::uint32_t> node;        ///< per point that is a node: its index in the domain
    std::vector<std::uint32_t> pointOfNode; ///< per node of the domain: its point, or kNoIndex
    std::vector<PlaneEdge> edges;
    std::vector<std::uint32_t> segment;      ///< per edge: its index in the domain
    std::vector<std::uint32_t> holeMarker;   ///< per hole marker of the domain: its point, or kNoIndex
    std::vector<std::uint32_t> regionMarker; ///< per region marker of the domain: its point, or kNoIndex
    std::vector<std::uint32_t> place;        ///< per other place: its point, or kNoIndex
};

/// Extracts the graph of a domain, which need not be valid. `places`: further places whose faces are to be found.
DomainGraph graphOf(const Domain &domain, std::span<const Vec2> places = {});

/// Returns the index of a region marker at exactly this place, or kNoIndex. `guess`: index to try first.
std::uint32_t regionMarkerAt(const Domain &domain, Vec2 place, std::size_t guess);

/// Attributes of the faces of a domain.
struct FaceLabels {
    std::vector<std::uint8_t> inside;  ///< per face
    std::vector<std::int32_t> tag;     ///< per face, by region markers; 1 if it has none
    std::vector<std::uint32_t> marker; ///< per face: the first region marker in it, or kNoIndex
};

/// Labels faces by the domain's inside rule and region markers. With EvenOdd, an even number of boundary segments must
/// meet at every node.
FaceLabels labelFaces(const Domain &domain, const DomainGraph &graph, const Faces &faces);

/// The faces of a domain and how they were found. Validation finds them, and discretisation needs them again.
struct DomainFaces {
    DomainGraph graph;
    PlaneSweepResult sweep;
    Faces faces;
    FaceLabels labels;
};

} // namespace forefront
