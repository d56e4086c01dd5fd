#include "core/files/common/solid_mesh.hpp"

#include "core/files/common/tagged_sides.hpp"
#include "core/files/common/usual_extrusion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace forefront {

namespace {

/// Fills in the parts of a mesh of several layers.
class Extruder {
  public:
    Extruder(const MeshView &mesh, const Extrusion &extrusion, SolidMesh &solid)
        : mesh_(mesh), height_(extrusion.height), layers_(extrusion.layers), solid_(solid) {}

    void addNodes() {
        solid_.nodes.reserve(mesh_.nodes.size() * (layers_ + 1));
        for (const Vec2 node : mesh_.nodes) {
            for (std::uint32_t layer = 0; layer <= layers_; ++layer) {
                solid_.nodes.push_back({node.x, node.y, layer == layers_ ? height_ : height_ * layer / layers_});
            }
        }
    }

    void addCells() {
        solid_.cells.reserve(mesh_.elementCount() * layers_);
        for (std::size_t e = 0; e < mesh_.elementCount(); ++e) {
            const std::span<const NodeId> corners = mesh_.cornersOf(e);
            for (std::uint32_t layer = 0; layer < layers_; ++layer) {
                SolidCell &cell = solid_.cells.emplace_back();
                cell.count = static_cast<std::uint8_t>(2 * corners.size());
                cell.region = mesh_.region(e);
                for (std::size_t k = 0; k < corners.size(); ++k) {
                    cell.corners[k] = node(corners[k], layer);
                    cell.corners[k + corners.size()] = node(corners[k], layer + 1);
                }
            }
        }
    }

    /// Adds the faces over tagged edges. Of the two sides of an edge inside, the one in its direction is taken. An edge
    /// that is a side of no element has no face.
    void addSides() {
        const TaggedSides table(mesh_);
        for (std::size_t k = 0; k < mesh_.edges.size(); ++k) {
            const std::span<const ElementSide> sides = table.of(k);
            if (sides.empty()) {
                continue;
            }
            const auto along = std::find_if(sides.begin(), sides.end(), [](const ElementSide &s) { return s.along; });
            const ElementSide side = along != sides.end() ? *along : sides.front();
            const std::span<const NodeId> corners = mesh_.cornersOf(side.element);
            const NodeId a = corners[side.side], b = corners[(side.side + 1) % corners.size()];
            for (std::uint32_t layer = 0; layer < layers_; ++layer) {
                solid_.faces.push_back({{node(a, layer), node(b, layer), node(b, layer + 1), node(a, layer + 1)},
                                        4,
                                        mesh_.edges[k].tag,
                                        side.element * layers_ + layer,
                                        static_cast<std::uint8_t>(2 + side.side)});
            }
        }
    }

    void addCover(bool front) {
        for (std::uint32_t e = 0; e < mesh_.elementCount(); ++e) {
            const std::span<const NodeId> corners = mesh_.cornersOf(e);
            SolidFace &face = solid_.faces.emplace_back();
            face.count = static_cast<std::uint8_t>(corners.size());
            face.tag = front ? solid_.front : solid_.back;
            face.cell = e * layers_ + (front ? layers_ - 1 : 0);
            face.side = front ? 1 : 0;
            for (std::size_t k = 0; k < corners.size(); ++k) {
                face.corners[k] = node(corners[front ? k : corners.size() - 1 - k], front ? layers_ : 0);
            }
        }
    }

  private:
    std::uint32_t node(NodeId n, std::uint32_t layer) const {
        return static_cast<std::uint32_t>(index(n)) * (layers_ + 1) + layer;
    }

    const MeshView &mesh_;
    double height_;
    std::uint32_t layers_;
    SolidMesh &solid_;
};

} // namespace

SolidMesh::SolidMesh(const MeshView &mesh, const Extrusion &extrusion) : tags(tagsOf(mesh)) {
    const std::vector<std::int32_t> covers = freeTags(mesh, 2);
    back = covers[0];
    front = covers[1];
    Extruder extruder(mesh, extrusion, *this);
    extruder.addNodes();
    extruder.addCells();
    extruder.addSides();
    extruder.addCover(false);
    extruder.addCover(true);
    tags.points.clear();
    tags.edges.emplace(back, "back");
    tags.edges.emplace(front, "front");
}

Extrusion usualExtrusion(const MeshView &mesh) {
    double twice = 0.0;
    for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
        const std::span<const NodeId> corners = mesh.cornersOf(e);
        const Vec2 origin = mesh.nodes[index(corners[0])];
        for (std::size_t k = 2; k < corners.size(); ++k) {
            twice += cross(mesh.nodes[index(corners[k - 1])] - origin, mesh.nodes[index(corners[k])] - origin);
        }
    }
    const double width =
        std::sqrt(0.5 * std::fabs(twice) / static_cast<double>(std::max<std::size_t>(mesh.elementCount(), 1)));
    return {width > 0.0 ? width : 1.0, 1};
}

std::vector<std::int32_t> freeTags(const MeshView &mesh, std::size_t count) {
    std::set<std::int32_t> used;
    for (const TaggedEdge &edge : mesh.edges) {
        used.insert(edge.tag);
    }
    for (const TaggedNode &point : mesh.points) {
        used.insert(point.tag);
    }
    const std::int64_t above = std::max(used.empty() ? 0 : *used.rbegin(), 0);
    const bool fits = above + static_cast<std::int64_t>(count) <= std::numeric_limits<std::int32_t>::max();
    std::vector<std::int32_t> tags;
    for (std::int32_t tag = fits ? static_cast<std::int32_t>(above + 1) : 1; tags.size() < count; ++tag) {
        if (used.count(tag) == 0) {
            tags.push_back(tag);
        }
    }
    return tags;
}

} // namespace forefront
