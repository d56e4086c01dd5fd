#include "app/reports/quads_report.hpp"

#include "core/engine/base/number_text.hpp"

#include <array>
#include <cstdio>
#include <string_view>
#include <vector>

namespace forefront {

namespace {

void addPlaces(std::string_view name, const std::vector<Vec2> &places, JsonWriter &json) {
    json.key(name).beginArray();
    for (const Vec2 place : places) {
        json.values(std::array{place.x, place.y});
    }
    json.endArray();
}

} // namespace

void addQuads(const QuadReport &quads, JsonWriter &json) {
    json.key("quadrilaterals").beginObject();
    json.member("front", quads.lattice ? "lattice" : "rows").member("rows", quads.rows);
    json.member("openings", quads.openings).member("closings", quads.closings).member("searched", quads.searched);
    json.member("added_nodes", quads.addedNodes).member("odd_edges", quads.oddEdges);
    json.member("not_convex", quads.notConvex).member("changes", quads.changes);
    addPlaces("not_convex_at", quads.notConvexAt, json);
    json.member("triangles_left", quads.triangles);
    addPlaces("triangles_for_quads_at", quads.trianglesAt, json);
    json.member("irregular_nodes", quads.irregularNodes).member("interior_nodes", quads.innerNodes);
    json.endObject();
}

std::string quadLines(const QuadReport &quads, bool alone) {
    char share[16];
    std::snprintf(share, sizeof share, "%.2f", 100.0 * quads.irregularShare());
    std::string lines = "quadrilaterals: " + std::string(quads.lattice ? "a lattice inside two rows" : "rows") + ", " +
                        share + " % of the interior nodes irregular";
    if (quads.addedNodes > 0) {
        lines += ", " + countText(quads.addedNodes, "boundary node") + " added for even loops";
    }
    lines += '\n';
    if (quads.triangles > 0 && alone) {
        lines += countText(quads.triangles, "triangle") +
                 " left, where the edges of a face had to stay and are odd in number" +
                 (quads.trianglesAt.empty() ? "" : ", or where quadrilaterals would not be convex") + '\n';
    }
    return lines;
}

} // namespace forefront
