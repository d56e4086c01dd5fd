#include "ui/workspace/run/run_words.hpp"

#include "ui/widgets/widgets.hpp"
#include "ui/workspace/mesh/element_words.hpp"

#include <cstddef>
#include <utility>

namespace forefront {

namespace {

/// Returns one note on all edges of second order that are straight though they lie along curves.
Diagnostics straightEdgesOf(const SessionSnapshot &s) {
    if (!s.order || s.order->straight.empty()) {
        return {};
    }
    const std::size_t count = s.order->straight.size();
    return {{.severity = Severity::Note,
             .code = "straight-edge",
             .message = (count == 1 ? std::string("1 edge along a curve is straight")
                                    : ui::count(count) + " edges along curves are straight") +
                        ", since the curve would fold an element or meet another edge",
             .advice = "choose smaller elements there to follow the curve",
             .at = s.order->straight.front().at}};
}

/// Returns one note on all elements of second order whose Jacobian determinant varies much.
Diagnostics unevenElementsOf(const SessionSnapshot &s) {
    if (!s.order || s.order->uneven.empty()) {
        return {};
    }
    const std::size_t count = s.order->uneven.size();
    return {{.severity = Severity::Note,
             .code = "uneven-element",
             .message = ui::format("the Jacobian determinant falls below %g of its maximum in ", kReportedUniformity) +
                        (count == 1 ? "1 element" : ui::count(count) + " elements") +
                        ui::format("; the least ratio is %.3g", s.order->uneven.front().ratio),
             .advice = "choose smaller elements there, unless a sharp corner is the reason",
             .at = s.order->uneven.front().at}};
}

} // namespace

std::string resultText(const SessionSnapshot &s) {
    const std::string counts = !s.order && (!s.mesh || !s.mesh->whole)
                                   ? ui::format("%llu triangles", static_cast<unsigned long long>(s.quality.elements))
                                   : elementsInWords(s.quality.kinds);
    return counts + ui::format(", %llu nodes in %.3g s; minimum \xce\xb1 %.3f, mean %.3f",
                               static_cast<unsigned long long>(s.quality.nodes), s.secondsMesh + s.secondsImprove,
                               s.quality.alphaMin, s.quality.alphaMean);
}

std::string previewText(const SessionSnapshot &s) {
    return ui::format("Preview of %llu triangles; the full mesh will have about %.2g",
                      static_cast<unsigned long long>(s.quality.elements), s.requestedElements);
}

Diagnostics notesOf(const SessionSnapshot &s) {
    Diagnostics notes = s.spacing ? s.spacing->notes() : Diagnostics();
    for (const auto &notesOn : {straightEdgesOf, unevenElementsOf}) {
        for (Diagnostic &note : notesOn(s)) {
            notes.push_back(std::move(note));
        }
    }
    for (Diagnostic &note : s.leastAngle ? forcedAngles(*s.leastAngle) : Diagnostics()) {
        notes.push_back(std::move(note));
    }
    return notes;
}

} // namespace forefront
