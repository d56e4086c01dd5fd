#include "app/reports/crack_report.hpp"

#include "core/engine/base/number_text.hpp"
#include "core/engine/domain/domain.hpp"

namespace forefront {

void addCracks(const CrackReport &report, const std::map<std::int32_t, std::string> &names, JsonWriter &json) {
    json.key("cracks").beginObject().key("lines").beginArray();
    for (const CrackFaces &crack : report.cracks) {
        json.beginObject().member("left", boundaryName(names, crack.left));
        json.member("right", boundaryName(names, crack.right));
        json.member("edges", crack.edges).member("length", crack.length).endObject();
    }
    json.endArray().member("added_nodes", report.addedNodes).member("tips", report.tips).endObject();
}

std::string crackLines(const CrackReport &report, const std::map<std::int32_t, std::string> &names) {
    std::string lines;
    for (const CrackFaces &crack : report.cracks) {
        lines += "crack: faces " + boundaryName(names, crack.left) + " and " + boundaryName(names, crack.right) +
                 " of " + countText(crack.edges, "edge") + " each\n";
    }
    return lines.empty() ? lines
                         : lines + countText(report.addedNodes, "node") + " added for cracks, " +
                               countText(report.tips, "tip") + " inside the domain\n";
}

} // namespace forefront
