#include "core/drawing/names/region_commands.hpp"
#include "core/engine/mesh/quality.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/judging.hpp"
#include "ui/workspace/workspace.hpp"

#include <algorithm>
#include <cmath>

namespace forefront {

namespace {

using Rows = std::vector<std::pair<std::string, std::string>>;

/// Collects the rows of one part of the evaluated mesh.
class PartReader {
  public:
    explicit PartReader(const Judgement &judgement) : judgement_(judgement), mesh_(judgement.of.mesh->mesh) {}

    Rows element(std::uint32_t number) const {
        const Element &nodes = mesh_.elements[number];
        const Vec2 a = at(nodes[0]), b = at(nodes[1]), c = at(nodes[2]);
        Rows rows{{"Element", std::to_string(number)}, {"\xce\xb1", ui::format("%.4f", shapeFactor(a, b, c))}};
        const double twice = cross(b - a, c - a);
        rows.emplace_back("Angles", angleText(a, b, c, twice) + "  " + angleText(b, c, a, twice) + "  " +
                                        angleText(c, a, b, twice));
        rows.emplace_back("Area", ui::number(0.5 * twice));
        std::string neighbours, lengths, ratios;
        double growth = 1.0;
        for (std::size_t k = 0; k < 3; ++k) {
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
        rows.emplace_back("Nodes", nodeText(nodes[0]) + "  " + nodeText(nodes[1]) + "  " + nodeText(nodes[2]));
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
            if (std::ranges::find(mesh_.elements[element], node) != mesh_.elements[element].end()) {
                found.push_back(element);
            }
        });
        std::sort(found.begin(), found.end());
        return found;
    }
    Vec2 at(NodeId node) const { return mesh_.nodes[index(node)]; }
    static std::string nodeText(NodeId node) { return std::to_string(index(node)); }
    static std::string placeText(Vec2 place) { return ui::format("%.6g, %.6g", place.x, place.y); }
    static std::string tagText(std::int32_t tag, const std::string &name) {
        return std::to_string(tag) + (name.empty() ? "" : ", " + name);
    }
    static std::string angleText(Vec2 tip, Vec2 b, Vec2 c, double twiceArea) {
        const double radians = std::atan2(twiceArea, dot(b - tip, c - tip));
        return ui::format("%.1f\xc2\xb0", radians * 180.0 / 3.14159265358979323846);
    }
    double lengthOf(std::uint32_t edge) const {
        const MeshEdge &e = judgement_.edges->edges[edge];
        return distance(at(e.a), at(e.b));
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
        const Element &n = mesh_.elements[index(other)];
        const double beside = std::abs(cross(at(n[1]) - at(n[0]), at(n[2]) - at(n[0])));
        const double own = std::abs(twice); // named, since minmax() returns references
        const auto [smaller, larger] = std::minmax(own, beside);
        return smaller > 0.0 ? larger / smaller : INFINITY;
    }

    const Judgement &judgement_;
    const TriMesh &mesh_;
};

} // namespace

Rows describePart(const Workspace &context, const MeshPick &pick) {
    const Judgement &judgement = *context.judgement;
    if (!judgement.of.mesh || !judgement.edges || !judgement.tree) {
        return {};
    }
    const PartReader reader(judgement);
    const TriMesh &mesh = judgement.of.mesh->mesh;
    switch (pick.part) {
    case MeshPart::Elements:
        return pick.index < mesh.elements.size() ? reader.element(pick.index) : Rows();
    case MeshPart::Edges:
        return pick.index < judgement.edges->edges.size() ? reader.edge(pick.index) : Rows();
    case MeshPart::Nodes:
        break;
    }
    return pick.index < mesh.nodes.size() ? reader.node(pick.index) : Rows();
}

} // namespace forefront
