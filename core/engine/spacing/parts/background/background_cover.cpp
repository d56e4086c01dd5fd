#include "core/engine/spacing/parts/background/background_cover.hpp"

#include "core/engine/base/number_text.hpp"

#include <algorithm>
#include <cmath>

namespace forefront {
namespace {

constexpr int kCoverProbes = 64;         ///< intervals of the probing grid along each side
constexpr double kCoverTolerance = 0.01; ///< share of the domain that may be left out without a note
constexpr double kPercent = 100.0;

std::string boxText(const Box2 &box) {
    return "from " + placeText(box.min) + " to " + placeText(box.max);
}

Box2 boxOfMesh(const BackgroundMesh &mesh) {
    Box2 box;
    for (const auto &corners : mesh.elements) {
        for (const std::uint32_t node : corners) {
            box.add(mesh.nodes[node]);
        }
    }
    return box;
}

/// Returns true if the mesh and the inside of the domain have a place in common. Where neither has a node in the other,
/// their sides cross.
bool meetsDomain(const BackgroundMesh &mesh, const BackgroundPart &part, const DomainGraph &graph,
                 const InsideTest &inside) {
    const auto covered = [&](Vec2 p) { return std::isfinite(part.at(p)); };
    const auto nodes = graph.points.begin() + static_cast<std::ptrdiff_t>(graph.node.size()); // then markers follow
    return std::any_of(graph.points.begin(), nodes, covered) ||
           std::any_of(mesh.elements.begin(), mesh.elements.end(), [&](const auto &corners) {
               const Vec2 a = mesh.nodes[corners[0]], b = mesh.nodes[corners[1]], c = mesh.nodes[corners[2]];
               return inside.contains(a) || inside.boundaryCrosses(a, b) || inside.boundaryCrosses(b, c) ||
                      inside.boundaryCrosses(c, a);
           });
}

/// Returns the share of the inside of the domain that the mesh covers, by probing.
double coveredShare(const BackgroundPart &part, const Box2 &box, const InsideTest &inside) {
    std::size_t all = 0, covered = 0;
    for (int j = 0; j < kCoverProbes; ++j) {
        for (int i = 0; i < kCoverProbes; ++i) {
            const Vec2 p =
                box.min + Vec2{box.size().x * (i + 0.5) / kCoverProbes, box.size().y * (j + 0.5) / kCoverProbes};
            if (inside.contains(p)) {
                ++all;
                covered += std::isfinite(part.at(p)) ? 1U : 0U;
            }
        }
    }
    return all > 0 ? static_cast<double>(covered) / static_cast<double>(all) : 1.0;
}

} // namespace

Diagnostics compareCover(const BackgroundMesh &mesh, const BackgroundPart &part, const PartInput &input) {
    const InsideTest *const inside = input.faces.inside();
    if (inside == nullptr) {
        return {};
    }
    const std::string boxes = "the mesh lies " + boxText(boxOfMesh(mesh)) + ", the domain " + boxText(input.box);
    if (!meetsDomain(mesh, part, input.faces.get()->graph, *inside)) {
        return error("bad-background", "the background mesh does not meet the domain: " + boxes,
                     "give both in the same coordinates, or choose another background mesh");
    }
    const double share = coveredShare(part, input.box, *inside);
    if (share >= 1.0 - kCoverTolerance) {
        return {};
    }
    Diagnostic note;
    note.severity = Severity::Note;
    note.code = "background-partial";
    note.message = "the background mesh covers about " + numberText(std::floor(kPercent * share), 3) +
                   " % of the domain: " + boxes;
    note.advice = input.spec.usesAutomatic() ? "the rest gets automatic sizes" : "the other sizes hold in the rest";
    return {std::move(note)};
}

} // namespace forefront
