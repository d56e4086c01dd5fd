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

std::string pairText(const ImproveStep &step) {
    if (step.elements.empty()) {
        return "the halves of squares joined; no triangle of one colour is left";
    }
    return step.addedNodes.empty()
               ? "triangles of one colour joined to a neighbour"
               : numberOf(step.addedNodes.size(), "triangle of one colour gets a node in its middle",
                          "triangles of one colour get a node in their middle");
}

/// Returns how many changes were refused before a step: "; 2 others tried before did not pay".
std::string refusedText(const ImproveStep &step) {
    return step.refused == 0
               ? ""
               : "; " + numberOf(step.refused, "other tried before did not pay", "others tried before did not pay");
}

std::string walkText(const ImproveStep &step) {
    // Elements between two triangles are divided anew, which leaves the number of edges; each join takes one away.
    const std::size_t joined = step.removedEdges.size() - step.addedEdges.size();
    const std::size_t passed = step.elements.empty() ? 0 : step.elements.size() - 1;
    if (joined == 0) {
        return "triangle moved through " + numberOf(passed, "element", "elements") + ", where its way ends";
    }
    if (joined > 1) {
        return std::to_string(joined) + " pairs of triangles joined through the elements between them";
    }
    return passed == 0
               ? "two neighbouring triangles joined"
               : "two triangles joined through the " + numberOf(passed, "element", "elements") + " between them";
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
        return "completed: minimum angle, boundary layers, mapped faces, other regions, cracks or second order";
    case ImproveChange::Pair:
        return pairText(step);
    case ImproveChange::Walk:
        return walkText(step);
    case ImproveChange::Collapse:
        return "two opposite corners of an element merged";
    case ImproveChange::Rotate:
        return "edge turned to the next corners of its two elements";
    case ImproveChange::Split:
        return "node split in two, with a new element between";
    case ImproveChange::Doublet:
        return "node between two elements removed: they become one";
    case ImproveChange::Raise:
        return "node of the boundary given one more element";
    case ImproveChange::Insert:
        return "node added: three elements in the place of two";
    case ImproveChange::Inset:
        return "smaller element put inside an element: five in its place";
    case ImproveChange::Pass:
        return "all changes of a pass over the irregular nodes";
    case ImproveChange::Refill:
        return step.addedEdges.empty() && step.removedEdges.empty()
                   ? movedNodes(step) + " to make elements convex"
                   : "elements that were not convex replaced, with those around them";
    case ImproveChange::DividePoor:
        return "poor quadrilaterals divided into triangles";
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
    const std::string number = std::to_string(step.number) + " of " + std::to_string(steps) + ": ";
    if (step.quads) {
        const QuadFigures &before = step.quadsBefore, &after = step.quadsAfter;
        if (!step.measured) {
            return "Clean-up " + number + changeText(step);
        }
        const char *const part = step.change == ImproveChange::Completion
                                     ? "; in the part of the front, irregular nodes"
                                     : "; irregular nodes";
        return "Clean-up " + number + changeText(step) + refusedText(step) +
               figureText(part, static_cast<double>(before.irregular), static_cast<double>(after.irregular), "%.0f") +
               figureText(", scaled Jacobian minimum", before.jacobianMin, after.jacobianMin, "%.3f") +
               figureText(", mean", before.jacobianMean, after.jacobianMean, "%.4f");
    }
    return "Improvement " + number + changeText(step) +
           figureText("; minimum α", step.before.alphaMin, step.after.alphaMin, "%.3f") +
           figureText(", mean α", step.before.alphaMean, step.after.alphaMean, "%.3f") +
           figureText(", minimum angle", step.before.minAngle, step.after.minAngle, "%.1f°");
}

} // namespace forefront
