#include "core/engine/improve/improve_step.hpp"

#include "core/engine/mesh/shape_tally.hpp"

#include <cstdio>
#include <functional>

namespace forefront {

namespace {

std::string numberOf(std::size_t count, const char *one, const char *many) {
    return count == 1 ? std::string("1 ") + one : std::to_string(count) + ' ' + many;
}

std::string movedNodes(const ImproveStep &step) {
    return numberOf(step.moves.size(), "node moves", "nodes move");
}

std::string changeText(const ImproveStep &step) {
    switch (step.change) {
    case ImproveChange::Swap:
        return "edge swapped for the other diagonal";
    case ImproveChange::Sweep:
        return "smoothing, " + movedNodes(step) + " at once";
    case ImproveChange::Restore:
        return numberOf(step.moves.size(), "node returns", "nodes return") + ", since an element got worse";
    case ImproveChange::RelaxedSwap:
        return "edge swapped, " + movedNodes(step) + " around it";
    case ImproveChange::Merge:
        return "node removed, " + movedNodes(step) + " around it";
    case ImproveChange::Divide:
        return "node added, " + movedNodes(step) + " around it";
    case ImproveChange::Cleanup:
        return std::string("poor element: ") + (step.addedEdges.empty() ? "" : "edge swapped, ") + movedNodes(step);
    case ImproveChange::Growth:
        return movedNodes(step) + " to even the areas of neighbours";
    case ImproveChange::Polish:
        return movedNodes(step) + " for better shapes";
    case ImproveChange::Remainder:
        return "all further changes at once";
    case ImproveChange::Completion:
        return "minimum angle, boundary layers or nodes in the middle of edges added";
    case ImproveChange::Renumber:
        break;
    }
    return "nodes and elements renumbered";
}

/// Returns a figure before and after a step, or only once if its text stays the same.
std::string figureText(const char *name, double before, double after, const char *format) {
    const auto text = [format](double value) {
        char buffer[32];
        static_cast<void>(std::snprintf(buffer, sizeof buffer, format, value));
        return std::string(buffer);
    };
    const std::string was = text(before), is = text(after);
    return std::string(name) + ' ' + (was == is ? is : was + " → " + is);
}

} // namespace

ShapeFigures figuresOf(const TriMesh &mesh) {
    return figuresOf(shapesOf(mesh.nodes, mesh.elements, std::identity{}));
}

ShapeFigures figuresOf(const MeshQuality &quality) {
    return {quality.alphaMin, quality.alphaMean, quality.minAngle};
}

std::string caption(const ImproveStep &step, std::size_t steps) {
    return "Improvement " + std::to_string(step.number) + " of " + std::to_string(steps) + ": " + changeText(step) +
           figureText("; minimum α", step.before.alphaMin, step.after.alphaMin, "%.3f") +
           figureText(", mean α", step.before.alphaMean, step.after.alphaMean, "%.3f") +
           figureText(", minimum angle", step.before.minAngle, step.after.minAngle, "%.1f°");
}

} // namespace forefront
