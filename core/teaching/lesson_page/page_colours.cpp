#include "core/teaching/lesson_page/page_colours.hpp"

#include "core/engine/base/number_text.hpp"
#include "core/engine/spacing/spacing_field.hpp"
#include "core/teaching/page/recorded_run.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace forefront {

namespace {

constexpr std::size_t kMaxTriangles = 3000;

bool shows(const LessonPage &page, const char *layer) {
    return page.layers && std::find(page.layers->begin(), page.layers->end(), layer) != page.layers->end();
}

/// Values of the nodes or elements of a mesh.
struct ValuedMesh {
    std::shared_ptr<const MeshSnapshot> mesh;
    std::vector<double> values;
    std::string name;
    bool spacing = false; ///< on a logarithmic scale, as a tint
};

bool canHold(const std::shared_ptr<const MeshSnapshot> &mesh) {
    return mesh && !mesh->whole && !mesh->mesh.elements.empty() && mesh->mesh.elements.size() <= kMaxTriangles;
}

ValuedMesh valuesOf(const LessonPage &page, LessonRun &run, const SessionSnapshot &shown) {
    ValuedMesh valued;
    if (page.colours.any() && shows(page, "quality") && canHold(shown.mesh)) {
        if (Result<std::vector<double>> values = coloursOn(page.colours, shown.mesh->mesh, {})) {
            valued = {shown.mesh, *std::move(values), page.colours.name, false};
        }
    } else if (shows(page, "size") && shown.spacing) {
        const std::shared_ptr<const SessionSnapshot> end = run.at({.atEnd = true});
        if (canHold(end->mesh)) {
            valued = {end->mesh, {}, "\xcf\x81", true};
            for (const Vec2 node : end->mesh->mesh.nodes) {
                valued.values.push_back(shown.spacing->at(node));
            }
        }
    }
    return valued;
}

} // namespace

void writePageColours(TextWriter &out, const LessonPage &page, LessonRun &run, const SessionSnapshot &shown) {
    const ValuedMesh valued = valuesOf(page, run, shown);
    if (valued.values.empty()) {
        out << "null";
        return;
    }
    const auto [least, greatest] = std::minmax_element(valued.values.begin(), valued.values.end());
    const double from = *least, to = *greatest;
    const auto scaled = [&](double value) { return valued.spacing ? std::log(value) : value; };
    const double span = scaled(to) - scaled(from);
    out << "{\"name\":" << scriptString(valued.name) << ",\"from\":" << scriptString(numberText(from, 3))
        << ",\"to\":" << scriptString(numberText(to, 3)) << ",\"tint\":" << (valued.spacing ? 1 : 0) << ",\"nodes\":[";
    const TriMesh &mesh = valued.mesh->mesh;
    const char *comma = "";
    for (const Vec2 node : mesh.nodes) {
        out << comma << numberText(node.x, 5) << ',' << numberText(node.y, 5);
        comma = ",";
    }
    out << "],\"elements\":[";
    comma = "";
    for (const Element &element : mesh.elements) {
        for (const NodeId node : element) {
            out << comma << static_cast<std::uint64_t>(index(node));
            comma = ",";
        }
    }
    out << "],\"values\":[";
    comma = "";
    for (const double value : valued.values) { // in thousandths of the range
        const double t = span > 0.0 ? (scaled(value) - scaled(from)) / span : 0.5;
        out << comma << static_cast<std::uint64_t>(std::lround(1000.0 * t));
        comma = ",";
    }
    out << "]}";
}

} // namespace forefront
