#include "core/engine/mapped/mapped_rows.hpp"

#include "core/engine/base/cancelled.hpp"
#include "core/engine/base/ids.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/geometry/polygon.hpp"
#include "core/engine/geometry/predicates.hpp"
#include "core/engine/mapped/row_grid.hpp"
#include "core/engine/mapped/row_untangle.hpp"
#include "core/engine/mapped/strip_rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

namespace forefront {

namespace {

/// The edges around a mapped face, counter-clockwise.
struct RowOutline {
    std::vector<std::uint32_t> nodes; ///< from the first corner on
    std::vector<std::size_t> corners; ///< places of the corners in `nodes`, then the number of nodes
};

/// Returns the outlines of faces as the boundary divides them.
class RowOutlines {
  public:
    RowOutlines(const Domain &domain, std::span<const TransfiniteFace> faces, std::span<const StripFace> strips,
                const DiscreteDomain &boundary)
        : domain_(domain), boundary_(boundary) {
        for (std::size_t f = 0; f < faces.size(); ++f) {
            faceOf_[faces[f].region] = f;
        }
        for (std::size_t f = 0; f < strips.size(); ++f) {
            faceOf_[strips[f].region] = faces.size() + f;
        }
        next_.resize(faces.size() + strips.size());
        for (const DiscreteSegment &s : boundary.segments) {
            if (const auto left = faceOf_.find(s.leftRegion); left != faceOf_.end()) {
                next_[left->second][s.a] = s.b;
            }
            if (const auto right = faceOf_.find(s.rightRegion); right != faceOf_.end()) {
                next_[right->second][s.b] = s.a;
            }
        }
    }

    bool isMapped(std::uint32_t region) const { return faceOf_.contains(region); }
    const NextNodes &next(std::size_t f) const { return next_[f]; }

    RowOutline of(std::size_t f, const TransfiniteFace &face) const {
        RowOutline outline;
        const NextNodes &next = next_[f];
        const Vec2 first = domain_.nodes[face.corners.front()];
        std::uint32_t node = std::find_if(next.begin(), next.end(), [&](const auto &step) {
                                 return boundary_.nodes[step.first] == first;
                             })->first;
        do {
            const std::size_t corner = outline.corners.size();
            if (corner < face.corners.size() && boundary_.nodes[node] == domain_.nodes[face.corners[corner]]) {
                outline.corners.push_back(outline.nodes.size());
            }
            outline.nodes.push_back(node);
            node = next.at(node);
        } while (node != outline.nodes.front());
        outline.corners.push_back(outline.nodes.size());
        return outline;
    }

  private:
    const Domain &domain_;
    const DiscreteDomain &boundary_;
    std::map<std::uint32_t, std::size_t> faceOf_; ///< by region
    std::vector<NextNodes> next_;                 ///< per face, then per strip
};

/// Fills faces one after the other.
class RowBuilder {
  public:
    RowBuilder(const DiscreteDomain &boundary, BoundaryLayers &rows, const Progress &progress)
        : boundary_(boundary), rows_(rows), progress_(progress) {}

    Status fill(const TransfiniteFace &face, const RowOutline &outline) {
        const auto count = [&](std::size_t k) { return outline.corners[k + 1] - outline.corners[k]; };
        const std::size_t across = count(1), along = count(0), sides = face.corners.size();
        if (count(0) != count(2) || (sides == 4 && count(1) != count(3))) {
            return fault("mapped-sides", "opposite sides of a mapped face have different numbers of edges",
                         "give them equal numbers of elements", at(outline.nodes.front()));
        }
        if (Status faults = checkCorners(face, outline); !faults.empty()) {
            return faults;
        }
        ids_.assign((along + 1) * (across + 1), kNoIndex);
        RowGrid grid(along, across);
        columns_ = across + 1;
        const auto around = [&](std::size_t k) { return outline.nodes[k % outline.nodes.size()]; };
        const auto set = [&](std::size_t i, std::size_t j, std::uint32_t node) {
            ids_[i * columns_ + j] = node;
            grid.at(i, j) = at(node);
        };
        for (std::size_t j = 0; j <= across; ++j) {
            set(0, j, sides == 3 ? around(0) : around(outline.nodes.size() - j));
            set(along, j, around(along + j));
        }
        for (std::size_t i = 0; i <= along; ++i) {
            set(i, 0, around(i));
            set(i, across, around(outline.corners[2] + along - i));
        }
        grid.interpolate();
        const bool valid = !grid.invertedCell(!face.quads) || grid.smoothUntilValid(!face.quads, progress_) ||
                           untangleRows(grid, !face.quads, progress_);
        if (progress_.cancelled()) {
            return cancelled("filling mapped faces");
        }
        if (!valid) {
            return inverted(outline, grid.cellCentre(*grid.invertedCell(!face.quads)));
        }
        addNodes(grid);
        addRowCells(grid, ids_, face.quads, face.region, rows_);
        return {};
    }

  private:
    /// Returns the interior angle at a place of an outline, degrees.
    double angleAt(const RowOutline &outline, std::size_t k) const {
        const std::size_t n = outline.nodes.size();
        const Vec2 p = at(outline.nodes[k]), in = p - at(outline.nodes[(k + n - 1) % n]),
                   out = at(outline.nodes[(k + 1) % n]) - p;
        return 180.0 - std::atan2(cross(in, out), dot(in, out)) * 180.0 / std::numbers::pi;
    }

    /// Refuses corners that turn inwards: the one quadrilateral there has their angle. Two triangles share it, and
    /// those at the corner where the rows of three sides meet are triangles, too.
    Status checkCorners(const TransfiniteFace &face, const RowOutline &outline) const {
        const std::size_t n = outline.nodes.size();
        for (std::size_t c = face.corners.size() == 3 ? 1 : 0; face.quads && c < face.corners.size(); ++c) {
            const std::size_t k = outline.corners[c];
            const std::uint32_t node = outline.nodes[k];
            if (orientation(at(outline.nodes[(k + n - 1) % n]), at(node), at(outline.nodes[(k + 1) % n])) <= 0) {
                return fault("mapped-corners",
                             "a corner of a mapped face has an interior angle of " +
                                 numberText(std::round(angleAt(outline, k)), 4) +
                                 " degrees, which no quadrilateral has; expected less than 180",
                             "choose another node as a corner, or triangles", at(node));
            }
        }
        return {};
    }

    /// Returns the fault that an element at a place is inverted, which names the node nearest to it where the outline
    /// turns inwards, if there is one.
    Diagnostics inverted(const RowOutline &outline, Vec2 where) const {
        constexpr double kInwards = 190.0; // degrees
        std::optional<std::size_t> nearest;
        for (std::size_t k = 0; k < outline.nodes.size(); ++k) {
            const bool isNearer =
                !nearest || distance(at(outline.nodes[k]), where) < distance(at(outline.nodes[*nearest]), where);
            if (isNearer && angleAt(outline, k) > kInwards) {
                nearest = k;
            }
        }
        if (!nearest) {
            return fault("mapped-inverted", "an element of a mapped face would be inverted",
                         "choose other corners, or divide the face into parts with less bent sides", where);
        }
        return fault(
            "mapped-inverted",
            "an element of a mapped face would be inverted beside the node " + placeText(at(outline.nodes[*nearest])) +
                ", where its outline turns inwards",
            "draw a line from that node to the facing side, which makes two faces of it, or choose other corners",
            where);
    }

    static Diagnostics fault(const char *code, std::string what, const char *advice, Vec2 where) {
        Diagnostics faults = error(code, std::move(what), advice);
        faults.front().at = where;
        return faults;
    }
    Vec2 at(std::uint32_t node) const { return boundary_.nodes[node]; }

    void addNodes(const RowGrid &grid) {
        for (std::size_t i = 1; i < grid.along(); ++i) {
            for (std::size_t j = 1; j < grid.across(); ++j) {
                ids_[i * columns_ + j] = static_cast<std::uint32_t>(boundary_.nodes.size() + rows_.inner.size());
                rows_.inner.push_back(grid.at(i, j));
            }
        }
    }

    const DiscreteDomain &boundary_;
    BoundaryLayers &rows_;
    const Progress &progress_;
    std::size_t columns_ = 0;
    std::vector<std::uint32_t> ids_; ///< nodes of the grid of the face
};

/// Returns what mapped faces and strips leave of a boundary. Points without a tag that lie in them are left out.
/// `faces`: the nodes around each.
DiscreteDomain withoutFaces(const DiscreteDomain &boundary, const RowOutlines &outlines,
                            std::span<const std::vector<std::uint32_t>> faces) {
    DiscreteDomain rest = boundary;
    rest.segments.clear();
    rest.stretches.clear();
    for (std::size_t i = 0; i < boundary.segments.size(); ++i) {
        DiscreteSegment s = boundary.segments[i];
        s.leftRegion = outlines.isMapped(s.leftRegion) ? kOutside : s.leftRegion;
        s.rightRegion = outlines.isMapped(s.rightRegion) ? kOutside : s.rightRegion;
        if (s.leftRegion == kOutside && s.rightRegion == kOutside) {
            continue;
        }
        rest.segments.push_back(s);
        if (!boundary.stretches.empty()) {
            rest.stretches.push_back(boundary.stretches[i]);
        }
    }
    std::vector<std::vector<Vec2>> polygons;
    for (const std::vector<std::uint32_t> &outline : faces) {
        std::vector<Vec2> &polygon = polygons.emplace_back();
        for (const std::uint32_t node : outline) {
            polygon.push_back(boundary.nodes[node]);
        }
    }
    const std::size_t tagged = boundary.taggedPoints().size();
    rest.points.assign(boundary.taggedPoints().begin(), boundary.taggedPoints().end());
    for (std::size_t k = tagged; k < boundary.points.size(); ++k) {
        const Vec2 p = boundary.nodes[boundary.points[k].node];
        if (std::none_of(polygons.begin(), polygons.end(),
                         [p](const auto &polygon) { return locate(polygon, p) != PointPlace::Outside; })) {
            rest.points.push_back(boundary.points[k]);
        }
    }
    rest.gradedNodes = rest.points.size() - tagged;
    return rest;
}

} // namespace

TriMesh nodesOf(const DiscreteDomain &boundary) {
    TriMesh mesh;
    mesh.nodes = boundary.nodes;
    mesh.curves = boundary.curves;
    mesh.boundaryNames = boundary.boundaryNames;
    mesh.regionNames = boundary.regionNames;
    return mesh;
}

Result<BoundaryLayers> mappedRows(const Domain &domain, std::span<const TransfiniteFace> faces,
                                  std::span<const StripFace> strips, const DiscreteDomain &boundary,
                                  const Progress &progress) {
    BoundaryLayers rows;
    const RowOutlines outlines(domain, faces, strips, boundary);
    RowBuilder builder(boundary, rows, progress);
    std::vector<std::vector<std::uint32_t>> around;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        progress("filling mapped faces", static_cast<double>(f) / static_cast<double>(faces.size()));
        RowOutline outline = outlines.of(f, faces[f]);
        if (Status faults = builder.fill(faces[f], outline); !faults.empty()) {
            return faults;
        }
        around.push_back(std::move(outline.nodes));
    }
    for (std::size_t f = 0; f < strips.size(); ++f) {
        progress("filling strips", static_cast<double>(f) / static_cast<double>(strips.size()));
        const Result<StripOutline> outline = stripOutline(strips[f], domain, boundary, outlines.next(faces.size() + f));
        if (!outline) {
            return outline.faults();
        }
        if (Status faults = fillStrip(strips[f], *outline, boundary, rows, progress); !faults.empty()) {
            return faults;
        }
        around.push_back(outline->around());
    }
    rows.outer = std::make_shared<const DiscreteDomain>(withoutFaces(boundary, outlines, around));
    return rows;
}

} // namespace forefront
