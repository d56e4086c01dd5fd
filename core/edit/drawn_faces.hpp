#pragma once

#include "core/domain/domain.hpp"
#include "core/edit/box_tree.hpp"

#include <cstdint>
#include <vector>

namespace forefront {

/// The faces that the segments of a domain cut the plane into, whatever their role. Segments must have proper indices,
/// finite ends and some length (see isTraceable); where they cross, the faces are some faces. Half-edge 2s runs along
/// segment s, 2s+1 against it; both know the cycle of half-edges around the face on their left, and cycles of one face
/// are joined. The domain must outlive it.
class DrawnFaces {
  public:
    explicit DrawnFaces(const Domain &domain);

    /// Identifies the face left of a half-edge.
    std::uint32_t face(std::uint32_t halfEdge) { return faces_.root(cycle_[halfEdge]); }
    std::uint32_t unbounded() { return faces_.root(0); }
    /// Face at p, where p lies on a segment: the one an instant to the right of p.
    std::uint32_t faceAt(Vec2 p) { return faces_.root(cycleBelow(p, kNoIndex)); }

  private:
    /// Disjoint sets of the numbers below n.
    class Sets {
      public:
        explicit Sets(std::size_t n);
        std::uint32_t root(std::uint32_t k);
        void join(std::uint32_t a, std::uint32_t b) { parent_[root(a)] = root(b); }

      private:
        std::vector<std::uint32_t> parent_;
    };

    std::uint32_t origin(std::uint32_t h) const { return h & 1U ? segments_[h >> 1].b : segments_[h >> 1].a; }
    std::uint32_t target(std::uint32_t h) const { return origin(h ^ 1U); }
    Vec2 at(std::uint32_t node) const { return nodes_[node]; }
    bool turnsBefore(std::uint32_t g, std::uint32_t h) const;
    void sortAroundNodes();
    void traceCycles();
    void joinComponents();
    std::uint32_t outermost(std::uint32_t h) const;
    std::uint32_t cycleBelow(Vec2 p, std::uint32_t except);
    bool liesAbove(std::uint32_t h, std::uint32_t g) const;

    const std::vector<Vec2> &nodes_;
    const std::vector<DomainSegment> &segments_;
    std::vector<std::uint32_t> clockwise_; ///< next half-edge clockwise around its origin
    std::vector<std::uint32_t> cycle_;
    Sets components_;
    Sets faces_{0};
    BoxTree tree_;
};

/// True if a segment can take part in faces.
bool isTraceable(const Domain &domain, const DomainSegment &segment);
/// The same domain with traceable segments only.
Domain traceable(const Domain &domain);

} // namespace forefront
