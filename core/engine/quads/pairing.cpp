#include "core/engine/quads/pairing.hpp"

#include "core/engine/base/key_order.hpp"
#include "core/engine/mesh/edge_table.hpp"

#include <algorithm>
#include <utility>

namespace forefront {

namespace {

bool hasOneColour(const Element &t, const std::vector<std::uint8_t> &colours) {
    const std::uint8_t c = colours[index(t[0])];
    return colours[index(t[1])] == c && colours[index(t[2])] == c;
}

/// Puts a node of the other colour into each triangle of one colour.
void divideOneColoured(TriMesh &mesh, std::vector<std::uint8_t> &colours, std::vector<std::uint32_t> &faces) {
    const std::size_t count = mesh.elements.size();
    for (std::size_t e = 0; e < count; ++e) {
        const Element t = mesh.elements[e];
        if (!hasOneColour(t, colours)) {
            continue;
        }
        const NodeId middle{static_cast<std::uint32_t>(mesh.nodes.size())};
        Vec2 sum;
        for (const NodeId n : t) {
            sum += mesh.nodes[index(n)];
        }
        mesh.nodes.push_back((1.0 / 3.0) * sum);
        colours.push_back(static_cast<std::uint8_t>(1 - colours[index(t[0])]));
        mesh.elements[e] = {t[0], t[1], middle};
        mesh.elements.push_back({t[1], t[2], middle});
        mesh.elements.push_back({t[2], t[0], middle});
        if (!faces.empty()) {
            faces.insert(faces.end(), 2, faces[e]);
        }
    }
}

} // namespace

std::vector<std::uint64_t> oneColouredEdges(const ColouredBoundary &boundary) {
    std::vector<std::uint64_t> kept;
    for (const std::uint32_t s : boundary.oneColoured) {
        const auto [a, b] = std::minmax(boundary.domain.segments[s].a, boundary.domain.segments[s].b);
        kept.push_back(pairKey(a, b));
    }
    std::sort(kept.begin(), kept.end());
    return kept;
}

PairedCells pairTriangles(ColouredTriangles &&triangles, const std::vector<std::uint64_t> &kept, OneColoured rule) {
    // By names of their own: clang 14 cannot capture structured bindings.
    auto &mesh = triangles.mesh;
    auto &colours = triangles.colours;
    auto &faces = triangles.faces;
    if (rule == OneColoured::Divide) {
        divideOneColoured(mesh, colours, faces);
    }
    PairedCells result;
    const auto add = [&](const QuadCell &cell, std::size_t element) {
        result.cells.push_back(cell);
        if (!faces.empty()) {
            result.faces.push_back(faces[element]);
        }
    };
    std::vector<std::uint8_t> used(mesh.elements.size(), 0);
    const EdgeTable edges(mesh);
    result.cells.reserve(mesh.elements.size() / 2);
    edges.forEach([&](NodeId a, NodeId b, std::span<const HalfEdge> sides) {
        if (colours[index(a)] != colours[index(b)] || sides.size() != 2 ||
            std::binary_search(kept.begin(), kept.end(), pairKey(a, b))) {
            return;
        }
        const std::size_t e = sides[0] / 3, f = sides[1] / 3;
        const bool stays = rule == OneColoured::Leave &&
                           (hasOneColour(mesh.elements[e], colours) || hasOneColour(mesh.elements[f], colours));
        if (used[e] != 0 || used[f] != 0 || stays) {
            return;
        }
        used[e] = used[f] = 1;
        const Element &s = mesh.elements[e], &t = mesh.elements[f];
        const unsigned k = sides[0] % 3, j = sides[1] % 3;
        const auto number = [](NodeId n) { return static_cast<std::uint32_t>(n); };
        add({number(s[(k + 1) % 3]), number(s[(k + 2) % 3]), number(s[k]), number(t[(j + 2) % 3])}, e);
    });
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        if (used[e] == 0) {
            const Element &t = mesh.elements[e];
            add({static_cast<std::uint32_t>(t[0]), static_cast<std::uint32_t>(t[1]), static_cast<std::uint32_t>(t[2]),
                 kNoIndex},
                e);
        }
    }
    result.nodes = std::move(mesh.nodes);
    return result;
}

} // namespace forefront
