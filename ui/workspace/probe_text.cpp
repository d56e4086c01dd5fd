#include "core/drawing/names/region_commands.hpp"
#include "core/engine/mesh/placed_cell.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/judging.hpp"
#include "ui/workspace/workspace.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace forefront {

namespace {

using Rows = std::vector<std::pair<std::string, std::string>>;

/// Collects the rows of one part of the evaluated mesh.
class PartReader {
  public:
    explicit PartReader(const Judgement &judgement) : judgement_(judgement), mesh_(judgement.of.mesh->view()) {}

    Rows element(std::uint32_t number) const {
        const PlacedCell cell(mesh_, number);
        const std::size_t corners = cell.corners().size();
        Rows rows{{"Element", std::to_string(number)}, {"\xce\xb1", ui::format("%.4f", shapeFactor(cell))}};
        if (cell.kind != CellKind::Triangle3) {
            rows.insert(rows.begin() + 1, {"Kind", cell.traits().name});
            rows.emplace_back("Scaled Jacobian", ui::format("%.4f", scaledJacobian(cell)));
        }
        rows.emplace_back("Angles", angleTexts(cell));
        const double twice = twiceArea(cell);
        rows.emplace_back("Area", ui::number(0.5 * twice));
        std::string neighbours, lengths, ratios;
        double growth = 1.0;
        for (std::size_t k = 0; k < corners; ++k) {
            const std::uint32_t edge = judgement_.edges->of(number, k);
            lengths += (k == 0 ? "" : "  ") + ui::number(lengthOf(edge), 3);
            ratios += (k == 0 ? "" : "  ") + ratioText(edge);
            if (const ElementId other = acrossFrom(edge, number); other != kNoElement) {
                neighbours += (neighbours.empty() ? "" : "  ") + std::to_string(index(other));
                growth = std::max(growth, areaRatio(twice, other));
            }
        }
        rows.emplace_back("Edges", lengths);
        if (judgement_.of.spacing) {
            rows.emplace_back("L/\xcf\x81", ratios);
        }
        rows.emplace_back("Neighbours", neighbours.empty() ? "none" : neighbours);
        rows.emplace_back("Growth", neighbours.empty() ? "none" : ui::number(growth));
        std::string nodes;
        for (const NodeId node : mesh_.nodesOf(number)) {
            nodes += (nodes.empty() ? "" : "  ") + nodeText(node);
        }
        rows.emplace_back("Nodes", nodes);
        const std::int32_t tag = mesh_.region(number);
        rows.emplace_back("Region", tagText(tag, regionName(mesh_.regionNames, tag)));
        if (judgement_.of.fieldValues && judgement_.info.part == MeshPart::Elements) {
            rows.emplace_back(judgement_.name, ui::number(judgement_.values[number], 6));
        }
        return rows;
    }

    Rows edge(std::uint32_t number) const {
        const MeshEdge &edge = judgement_.edges->edges[number];
        Rows rows{{"Edge", nodeText(edge.a) + " \xe2\x80\x93 " + nodeText(edge.b)},
                  {"Length", ui::number(lengthOf(number))}};
        if (judgement_.of.spacing) {
            const double ratio = ratioOf(number);
            rows.emplace_back("L/\xcf\x81", ui::number(ratio));
            rows.emplace_back("\xce\xb4", ui::number(std::min(ratio, 1.0 / ratio)));
        }
        std::string beside = std::to_string(index(edge.elements[0]));
        beside += edge.elements[1] != kNoElement ? "  " + std::to_string(index(edge.elements[1])) : "  (boundary)";
        rows.emplace_back("Elements", beside);
        const auto tagged = std::find_if(mesh_.edges.begin(), mesh_.edges.end(), [&](const TaggedEdge &t) {
            return std::minmax(t.a, t.b) == std::minmax(edge.a, edge.b);
        });
        rows.emplace_back("Boundary", tagged == mesh_.edges.end()
                                          ? "none"
                                          : tagText(tagged->tag, boundaryName(mesh_.boundaryNames, tagged->tag)));
        rows.emplace_back("Midpoint", placeText(midpoint(at(edge.a), at(edge.b))));
        return rows;
    }

    Rows node(std::uint32_t number) const {
        const NodeId id{number};
        const std::vector<std::uint32_t> around = elementsAround(id);
        std::string elements;
        for (const std::uint32_t element : around) {
            elements += (elements.empty() ? "" : "  ") + std::to_string(element);
        }
        const bool boundary = std::any_of(around.begin(), around.end(), [&](std::uint32_t element) {
            const std::span<const std::uint32_t> edges = judgement_.edges->of(element);
            return std::any_of(edges.begin(), edges.end(), [&](std::uint32_t side) {
                const MeshEdge &edge = judgement_.edges->edges[side];
                return edge.elements[1] == kNoElement && (edge.a == id || edge.b == id);
            });
        });
        Rows rows{{"Node", std::to_string(number)},
                  {"Position", placeText(at(id))},
                  {"Valence", std::to_string(around.size())},
                  {"Elements", elements},
                  {"Location", boundary ? "on the boundary" : "inside"}};
        if (judgement_.of.fieldValues && judgement_.info.part == MeshPart::Nodes) {
            rows.emplace_back(judgement_.name, ui::number(judgement_.values[number], 6));
        }
        return rows;
    }

  private:
    /// Returns the elements at a node, by index.
    std::vector<std::uint32_t> elementsAround(NodeId node) const {
        std::vector<std::uint32_t> found;
        judgement_.tree->query(boxAround(at(node), 0.0), [&](std::uint32_t element) {
            element = static_cast<std::uint32_t>(judgement_.of.mesh->element(element));
            if (std::ranges::find(mesh_.nodesOf(element), node) != mesh_.nodesOf(element).end()) {
                found.push_back(element);
            }
        });
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        return found;
    }
    Vec2 at(NodeId node) const { return mesh_.nodes[index(node)]; }
    static std::string nodeText(NodeId node) { return std::to_string(index(node)); }
    static std::string placeText(Vec2 place) { return ui::format("%.6g, %.6g", place.x, place.y); }
    static std::string tagText(std::int32_t tag, const std::string &name) {
        return std::to_string(tag) + (name.empty() ? "" : ", " + name);
    }
    /// Returns the angles at the corners, between the chords of the edges.
    static std::string angleTexts(const PlacedCell &cell) {
        std::string texts;
        for (std::size_t k = 0; k < cell.corners().size(); ++k) {
            const Vec2 ahead = cell.cornerAfter(k) - cell.nodes[k], back = cell.cornerBefore(k) - cell.nodes[k];
            const double degrees = std::atan2(cross(ahead, back), dot(ahead, back)) * 180.0 / std::numbers::pi;
            texts += (k == 0 ? "" : "  ") + ui::format("%.1f\xc2\xb0", degrees);
        }
        return texts;
    }
    double lengthOf(std::uint32_t edge) const {
        const MeshEdge &e = judgement_.edges->edges[edge];
        return edgeLength(mesh_.nodes, e.a, e.middle, e.b);
    }
    double ratioOf(std::uint32_t edge) const {
        const MeshEdge &e = judgement_.edges->edges[edge];
        return lengthOf(edge) / judgement_.of.spacing->at(midpoint(at(e.a), at(e.b)));
    }
    std::string ratioText(std::uint32_t edge) const {
        return judgement_.of.spacing ? ui::number(ratioOf(edge), 3) : std::string();
    }
    ElementId acrossFrom(std::uint32_t edge, std::uint32_t element) const {
        const auto &pair = judgement_.edges->edges[edge].elements;
        return index(pair[0]) == element ? pair[1] : pair[0];
    }
    double areaRatio(double twice, ElementId other) const {
        const double beside = std::abs(twiceArea(PlacedCell(mesh_, index(other))));
        const double own = std::abs(twice); // named, since minmax() returns references
        const auto [smaller, larger] = std::minmax(own, beside);
        return smaller > 0.0 ? larger / smaller : INFINITY;
    }

    const Judgement &judgement_;
    MeshView mesh_;
};

} // namespace

Rows describePart(const Workspace &context, const MeshPick &pick) {
    const Judgement &judgement = *context.judgement;
    if (!judgement.of.mesh || !judgement.edges || !judgement.tree) {
        return {};
    }
    const PartReader reader(judgement);
    const MeshView mesh = judgement.of.mesh->view();
    switch (pick.part) {
    case MeshPart::Elements:
        return pick.index < mesh.elementCount() ? reader.element(pick.index) : Rows();
    case MeshPart::Edges:
        return pick.index < judgement.edges->edges.size() ? reader.edge(pick.index) : Rows();
    case MeshPart::Nodes:
        break;
    }
    return pick.index < mesh.nodes.size() ? reader.node(pick.index) : Rows();
}

} // namespace forefront
