#include "core/engine/adapt/error_estimate.hpp"

#include "core/engine/adapt/gradient_recovery.hpp"
#include "core/engine/base/cancelled.hpp"
#include "core/engine/base/paced_progress.hpp"

#include <cmath>

namespace forefront {

double ErrorEstimate::relative() const {
    return total > 0.0 ? total / std::hypot(norm, total) : 0.0;
}

Result<ErrorEstimate> estimateError(const TriMesh &mesh, std::span<const double> values, const Progress &progress) {
    const Result<std::vector<Vec2>> gradients = elementGradients(mesh, values, progress);
    if (!gradients) {
        return gradients.faults();
    }
    const Result<CornerGradients> recovered = recoverGradient(mesh, *gradients, progress);
    if (!recovered) {
        return recovered.faults();
    }
    ErrorEstimate estimate;
    estimate.elements.resize(mesh.elements.size());
    double total = 0.0, norm = 0.0;
    PacedProgress pace(progress, "estimating the error", mesh.elements.size());
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        if (!pace.next()) {
            return cancelled("estimating the error");
        }
        const Element &nodes = mesh.elements[e];
        const Vec2 a = mesh.nodes[index(nodes[0])];
        const double area = 0.5 * cross(mesh.nodes[index(nodes[1])] - a, mesh.nodes[index(nodes[2])] - a);
        // The square of a function linear over a triangle: area/12·(Σ d² + (Σ d)²) of its values d at the corners.
        Vec2 sum;
        double squares = 0.0;
        for (const Vec2 corner : (*recovered)[e]) {
            const Vec2 d = corner - (*gradients)[e];
            sum += d;
            squares += lengthSquared(d);
        }
        const double square = area / 12.0 * (squares + lengthSquared(sum));
        estimate.elements[e] = std::sqrt(square);
        total += square;
        norm += area * lengthSquared((*gradients)[e]);
    }
    estimate.total = std::sqrt(total);
    estimate.norm = std::sqrt(norm);
    return estimate;
}

} // namespace forefront
