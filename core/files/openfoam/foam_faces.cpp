#include "core/files/openfoam/foam_faces.hpp"

#include "core/engine/mesh/edge_table.hpp"
#include "core/files/common/tagged_sides.hpp"

#include <algorithm>
#include <utility>

namespace forefront {

namespace {

constexpr std::uint32_t kNoEdge = static_cast<std::uint32_t>(-1);

class FoamBuilder {
  public:
    FoamBuilder(const MeshView &mesh, std::uint32_t layers)
        : mesh_(mesh), table_(mesh), layers_(layers), twins_(table_.halfEdges().count(), kNoHalfEdge),
          edges_(table_.halfEdges().count(), kNoEdge) {}

    Result<FoamFaces> build() {
        if (Diagnostics faults = pair(); !faults.empty()) {
            return faults;
        }
        const TaggedSides sides(mesh_);
        for (std::uint32_t k = static_cast<std::uint32_t>(mesh_.edges.size()); k-- > 0;) { // of several, the first
            for (const ElementSide &side : sides.of(k)) {
                edges_[halves().of(side.element, side.side)] = k;
            }
        }
        for (std::uint32_t e = 0; e < mesh_.elementCount(); ++e) {
            for (std::uint32_t layer = 0; layer < layers_; ++layer) {
                addInner(e, layer);
            }
        }
        result_.inner = result_.faces.size();
        for (std::uint32_t e = 0; e < mesh_.elementCount(); ++e) {
            addOuter(e);
        }
        return std::move(result_);
    }

  private:
    const HalfEdges &halves() const { return table_.halfEdges(); }

    /// Finds the side beyond each side.
    Diagnostics pair() {
        Diagnostics faults;
        table_.forEach([&](NodeId low, NodeId high, std::span<const HalfEdge> sides) {
            if (sides.size() == 2) {
                twins_[sides[0]] = sides[1];
                twins_[sides[1]] = sides[0];
            } else if (sides.size() > 2 && faults.empty()) {
                faults = error("not-manifold", "more than two elements share an edge", "check the mesh");
                faults.front().at = 0.5 * (mesh_.nodes[index(low)] + mesh_.nodes[index(high)]);
            }
        });
        return faults;
    }

    std::uint32_t node(NodeId n, std::uint32_t level) const {
        return static_cast<std::uint32_t>(index(n)) * (layers_ + 1) + level;
    }

    FoamFace sideFace(HalfEdge h, std::uint32_t layer) const {
        const NodeId a = halves().startOf(h), b = halves().endOf(h);
        FoamFace face;
        face.corners = {node(a, layer), node(b, layer), node(b, layer + 1), node(a, layer + 1)};
        face.owner = static_cast<std::uint32_t>(halves().elementOf(h)) * layers_ + layer;
        return face;
    }

    /// Returns the face at a level, with its normal along z or, if `down`, against it.
    FoamFace levelFace(std::uint32_t e, std::uint32_t level, bool down) const {
        const std::span<const NodeId> corners = mesh_.cornersOf(e);
        FoamFace face;
        face.count = static_cast<std::uint8_t>(corners.size());
        for (std::size_t k = 0; k < corners.size(); ++k) {
            face.corners[k] = node(corners[down ? corners.size() - 1 - k : k], level);
        }
        return face;
    }

    /// Adds the faces between a cell and those of higher numbers, by these.
    void addInner(std::uint32_t e, std::uint32_t layer) {
        std::array<std::pair<FoamFace, HalfEdge>, kMaxCellCorners + 1> found;
        std::size_t count = 0;
        if (layer + 1 < layers_) {
            FoamFace top = levelFace(e, layer + 1, false);
            top.owner = e * layers_ + layer;
            top.neighbour = top.owner + 1;
            found[count++] = {top, kNoHalfEdge};
        }
        for (unsigned k = 0; k < halves().sidesOf(e); ++k) {
            const HalfEdge h = halves().of(e, k);
            const auto beyond =
                twins_[h] == kNoHalfEdge ? 0U : static_cast<std::uint32_t>(halves().elementOf(twins_[h]));
            if (twins_[h] != kNoHalfEdge && beyond > e) {
                FoamFace face = sideFace(h, layer);
                face.neighbour = beyond * layers_ + layer;
                found[count++] = {face, h};
            }
        }
        std::sort(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(count),
                  [](const auto &a, const auto &b) { return a.first.neighbour < b.first.neighbour; });
        for (std::size_t k = 0; k < count; ++k) {
            const auto &[face, h] = found[k];
            const std::uint32_t edge = h == kNoHalfEdge       ? kNoEdge
                                       : edges_[h] != kNoEdge ? edges_[h]
                                                              : edges_[twins_[h]];
            if (edge != kNoEdge) {
                FoamZone &zone = result_.zones[mesh_.edges[edge].tag];
                zone.faces.push_back(result_.faces.size());
                zone.flipped.push_back(halves().startOf(h) != mesh_.edges[edge].a);
            }
            result_.faces.push_back(face);
        }
    }

    void addOuter(std::uint32_t e) {
        for (unsigned k = 0; k < halves().sidesOf(e); ++k) {
            const HalfEdge h = halves().of(e, k);
            for (std::uint32_t layer = 0; twins_[h] == kNoHalfEdge && layer < layers_; ++layer) {
                auto &part = edges_[h] == kNoEdge ? result_.untagged : result_.parts[mesh_.edges[edges_[h]].tag];
                part.push_back(sideFace(h, layer));
            }
        }
        result_.back.push_back(levelFace(e, 0, true));
        result_.back.back().owner = e * layers_;
        result_.front.push_back(levelFace(e, layers_, false));
        result_.front.back().owner = e * layers_ + layers_ - 1;
    }

    const MeshView &mesh_;
    EdgeTable table_;
    std::uint32_t layers_;
    std::vector<HalfEdge> twins_;      ///< per half-edge the one beyond
    std::vector<std::uint32_t> edges_; ///< per half-edge its tagged edge
    FoamFaces result_;
};

} // namespace

Result<FoamFaces> foamFaces(const MeshView &mesh, std::uint32_t layers) {
    return FoamBuilder(mesh, layers).build();
}

} // namespace forefront
