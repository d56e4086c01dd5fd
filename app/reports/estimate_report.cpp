#include "app/reports/estimate_report.hpp"

#include "core/engine/base/number_text.hpp"
#include "core/engine/base/version.hpp"
#include "core/files/json/json_writer.hpp"

namespace forefront {

std::string estimateText(const RunEstimate &estimate, const MeshingOptions &options) {
    constexpr int kDigits = 3;
    std::string text = "about " + numberText(estimate.elements, kDigits) + " elements, " +
                       numberText(estimate.nodes, kDigits) + " nodes, " +
                       countText(estimate.boundaryEdges, "boundary edge") + "\nabout " +
                       numberText(estimate.bytes / 1e6, kDigits) + " MB of memory, " + numberText(estimate.seconds, 2) +
                       " s of CPU time\n";
    if (options.elements != Elements::Triangles) {
        text += "the number of quadrilaterals can differ by a half where sizes change fast\n";
    }
    if (options.leastAngle) {
        text += "elements added for the least angle are not counted\n";
    }
    return text;
}

std::string estimateJson(const RunEstimate &estimate, const std::string &input) {
    JsonWriter json(JsonWriter::Layout::Indented);
    json.beginObject().member("version", version()).member("input", input).member("dry_run", true);
    json.member("elements", estimate.elements).member("nodes", estimate.nodes);
    json.member("boundary_edges", estimate.boundaryEdges).member("bytes", estimate.bytes);
    json.member("seconds", estimate.seconds).member("seconds_prepare", estimate.secondsPrepare);
    return json.endObject().text();
}

} // namespace forefront
