#include "core/engine/adapt/gradient_recovery.hpp"

#include "core/engine/base/cancelled.hpp"
#include "core/engine/base/paced_progress.hpp"
#include "core/engine/mesh/topology.hpp"

#include <algorithm>
#include <cmath>

namespace forefront {

namespace {

/// Minimum number of elements for a fit of three unknowns.
constexpr std::size_t kEnough = 5;

class PatchRecovery {
  public:
    PatchRecovery(const TriMesh &mesh, NodeElements around, std::span<const Vec2> gradients)
        : mesh_(mesh), around_(std::move(around)), gradients_(gradients), inPatch_(mesh.elements.size(), 0) {}

    Result<CornerGradients> run(const Progress &progress) {
        CornerGradients corners(mesh_.elements.size());
        PacedProgress pace(progress, "recovering the gradient", mesh_.nodes.size());
        for (std::uint32_t n = 0; n < mesh_.nodes.size(); ++n) {
            if (!pace.next()) {
                return cancelled("recovering the gradient");
            }
            const auto elements = elementsAround(NodeId{n});
            std::vector<std::int32_t> done;
            for (const ElementId e : elements) {
                const std::int32_t region = mesh_.region(index(e));
                if (std::find(done.begin(), done.end(), region) == done.end()) {
                    done.push_back(region);
                    assign(NodeId{n}, region, recoverAt(NodeId{n}, region), corners);
                }
            }
        }
        return corners;
    }

  private:
    std::span<const ElementId> elementsAround(NodeId node) const {
        const std::uint32_t begin = around_.offsets[index(node)], end = around_.offsets[index(node) + 1];
        return {around_.elements.data() + begin, end - begin};
    }
    Vec2 place(NodeId node) const { return mesh_.nodes[index(node)]; }
    Vec2 centroid(ElementId e) const {
        const Element &nodes = mesh_.elements[index(e)];
        return (1.0 / 3.0) * (place(nodes[0]) + place(nodes[1]) + place(nodes[2]));
    }
    double area(ElementId e) const {
        const Element &nodes = mesh_.elements[index(e)];
        return 0.5 * cross(place(nodes[1]) - place(nodes[0]), place(nodes[2]) - place(nodes[0]));
    }

    void assign(NodeId node, std::int32_t region, Vec2 gradient, CornerGradients &corners) const {
        for (const ElementId e : elementsAround(node)) {
            for (std::size_t k = 0; k < 3 && mesh_.region(index(e)) == region; ++k) {
                if (mesh_.elements[index(e)][k] == node) {
                    corners[index(e)][k] = gradient;
                }
            }
        }
    }

    void addToPatch(NodeId node, std::int32_t region) {
        for (const ElementId e : elementsAround(node)) {
            if (mesh_.region(index(e)) == region && inPatch_[index(e)] != stamp_) {
                inPatch_[index(e)] = stamp_;
                patch_.push_back(e);
            }
        }
    }

    Vec2 recoverAt(NodeId node, std::int32_t region) {
        patch_.clear();
        ++stamp_;
        addToPatch(node, region);
        const std::size_t ring = patch_.size();
        if (ring < kEnough) {
            for (std::size_t i = 0; i < ring; ++i) {
                for (const NodeId next : mesh_.elements[index(patch_[i])]) {
                    addToPatch(next, region);
                }
            }
        }
        Vec2 gradient;
        return fit(place(node), gradient) ? gradient : mean(ring);
    }

    /// Returns the fitted function at the node, from normal equations of 1, x, y about the node in units of the patch
    /// size.
    bool fit(Vec2 at, Vec2 &gradient) const {
        double size = 0.0;
        for (const ElementId e : patch_) {
            size = std::max(size, distance(at, centroid(e)));
        }
        if (patch_.size() < kEnough || !(size > 0.0)) {
            return false;
        }
        double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
        Vec2 g, gx, gy;
        for (const ElementId e : patch_) {
            const Vec2 d = (1.0 / size) * (centroid(e) - at);
            const Vec2 value = gradients_[index(e)];
            x += d.x, y += d.y, xx += d.x * d.x, xy += d.x * d.y, yy += d.y * d.y;
            g += value, gx += d.x * value, gy += d.y * value;
        }
        const auto count = static_cast<double>(patch_.size());
        // First column of the inverse of the symmetric matrix {count x y; x xx xy; y xy yy}, by cofactors.
        const double c0 = xx * yy - xy * xy, c1 = xy * y - x * yy, c2 = x * xy - xx * y;
        const double determinant = count * c0 + x * c1 + y * c2;
        constexpr double kFlat = 1e-4; // centroids nearly on a line
        if (!(determinant > kFlat * count * count * count)) {
            return false;
        }
        gradient = (1.0 / determinant) * (c0 * g + c1 * gx + c2 * gy);
        return true;
    }

    /// Returns the mean over the first elements of the patch, weighted by area.
    Vec2 mean(std::size_t count) const {
        Vec2 sum;
        double weight = 0.0;
        for (std::size_t i = 0; i < count; ++i) {
            sum += area(patch_[i]) * gradients_[index(patch_[i])];
            weight += area(patch_[i]);
        }
        return weight > 0.0 ? (1.0 / weight) * sum : Vec2{};
    }

    const TriMesh &mesh_;
    NodeElements around_;
    std::span<const Vec2> gradients_;
    std::vector<std::uint64_t> inPatch_; ///< stamp of the last patch an element was in
    std::uint64_t stamp_ = 0;
    std::vector<ElementId> patch_;
};

} // namespace

Result<std::vector<Vec2>> elementGradients(const TriMesh &mesh, std::span<const double> values,
                                           const Progress &progress) {
    std::vector<Vec2> gradients(mesh.elements.size());
    PacedProgress pace(progress, "computing the gradient", mesh.elements.size());
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        if (!pace.next()) {
            return cancelled("recovering the gradient");
        }
        const Element &nodes = mesh.elements[e];
        const Vec2 ab = mesh.nodes[index(nodes[1])] - mesh.nodes[index(nodes[0])];
        const Vec2 ac = mesh.nodes[index(nodes[2])] - mesh.nodes[index(nodes[0])];
        const double second = values[index(nodes[1])] - values[index(nodes[0])];
        const double third = values[index(nodes[2])] - values[index(nodes[0])];
        if (const double twiceArea = cross(ab, ac); twiceArea > 0.0) {
            gradients[e] = (1.0 / twiceArea) * Vec2{second * ac.y - third * ab.y, third * ab.x - second * ac.x};
        }
    }
    return gradients;
}

Result<CornerGradients> recoverGradient(const TriMesh &mesh, std::span<const Vec2> gradients,
                                        const Progress &progress) {
    std::optional<NodeElements> around = nodeElements(mesh, progress);
    if (!around) {
        return cancelled("recovering the gradient");
    }
    return PatchRecovery(mesh, std::move(*around), gradients).run(progress);
}

} // namespace forefront
