#pragma once

#include "core/drawing/document/document.hpp"
#include "core/engine/base/ids.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/geometry/box_tree.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

namespace forefront {

struct DomainFaces;

/// A face inside a domain.
struct MappedFace {
    double area = 0.0; ///< to its curves, without the holes in it
    Box2 box;
    std::int32_t tag = 1;            ///< of its region
    std::uint32_t marker = kNoIndex; ///< its first region marker
};

/// A segment between two faces, or between a face and the outside.
struct MappedEdge {
    Vec2 a, b;
    CurveStretch stretch;          ///< into Domain::curves
    std::uint32_t left = kNoIndex; ///< face left of a->b; kNoIndex: outside
    std::uint32_t right = kNoIndex;
    double deviation = 0.0;    ///< maximum distance between the segment and its curve
    std::uint32_t segment = 0; ///< index into Domain::segments
};

/// The faces inside a domain, to be drawn and picked. Immutable, so that threads can share it.
class FaceMap {
  public:
    FaceMap() = default;
    /// `faces`: the faces of the domain, which must be valid.
    FaceMap(std::shared_ptr<const Domain> domain, const DomainFaces &faces);

    std::span<const MappedFace> faces() const { return faces_; }
    std::span<const MappedEdge> edges() const { return edges_; }
    /// Returns the edges around a face and the holes in it, as indices into edges().
    std::span<const std::uint32_t> edgesOf(std::uint32_t face) const;
    /// Returns the outer outline of a face, counter-clockwise; curves as their chords.
    std::vector<Vec2> outlineOf(std::uint32_t face) const;
    /// Returns the domain of the faces; null if there are none.
    const Domain *domain() const { return domain_.get(); }
    /// Returns the curve of an edge, or null.
    const Curve *curveOf(const MappedEdge &edge) const {
        return edge.stretch.follows() ? &domain_->curves[edge.stretch.curve] : nullptr;
    }
    /// Returns the face that contains a point, or kNoIndex.
    std::uint32_t faceAt(Vec2 p) const;
    /// Returns the face of a region marker, or kNoIndex.
    std::uint32_t faceOf(const MarkedRegion &marker) const { return faceAt(marker.at); }
    /// Returns the same for region marker `index` of a document; at once if it is where the domain has it.
    std::uint32_t faceOf(const Document &document, std::uint32_t index) const;

  private:
    void addEdges(const DomainFaces &found, std::span<const std::uint32_t> numbers);
    void listEdges();
    void measure();

    std::shared_ptr<const Domain> domain_;
    std::vector<MappedFace> faces_;
    std::vector<MappedEdge> edges_;
    BoxTree tree_;                        ///< of the edges
    std::vector<std::uint32_t> starts_;   ///< per face, its first place in around_
    std::vector<std::uint32_t> around_;   ///< edges, face by face
    std::vector<std::uint32_t> ofMarker_; ///< per region marker of the domain, its face, or kNoIndex
};

/// Returns the faces of a faulty domain after a repair, as fillRegion() finds them; a map without faces if that fails
/// or the domain has many segments.
std::shared_ptr<const FaceMap> repairedFaceMap(const Domain &domain, std::stop_token stop = {});

/// Returns the faces of a domain, if necessary after a repair.
std::shared_ptr<const FaceMap> faceMapOf(std::shared_ptr<const Domain> domain);

} // namespace forefront
