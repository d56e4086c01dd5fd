#include "core/drawing_files/clipboard/clipboard.hpp"

#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/formulas/bring_formulas.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing_files/clipboard/coordinate_list.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/drawing_files/svg/svg.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/geometry/path_curve.hpp"
#include "core/files/text/base64.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numbers>

namespace forefront {
namespace {

constexpr std::string_view kBegin = "<metadata id=\"forefront\">", kEnd = "</metadata>";

/// Builds the text of an SVG drawing; y points down there.
class SvgText {
  public:
    void number(double value) { text += exactText(value + 0.0); }
    void point(Vec2 p) {
        number(p.x);
        text += ' ';
        number(-p.y);
    }

    void outline(const Outline &outline) {
        text += outline.closed ? "<path fill=\"#dddddd\" d=\"M " : "<path fill=\"none\" d=\"M ";
        point(outline.nodes.front());
        for (std::size_t k = 0; k < outline.segmentCount(); ++k) {
            segment(outline.curve(k));
        }
        text += outline.closed ? " Z\"/>\n" : "\"/>\n";
    }

    std::string text;

  private:
    void segment(const Curve &curve) {
        switch (curve.kind()) {
        case CurveKind::Line:
            text += " L ";
            point(curve.point(1.0));
            break;
        case CurveKind::Cubic:
            cubic(curve);
            break;
        case CurveKind::Arc: { // quarter turns at most: cubics are then within 3e-4 of the radius
            const double pieces = std::ceil(std::fabs(curve.numbers()[7]) / (0.5 * std::numbers::pi) - 1e-9);
            for (int k = 0; k < static_cast<int>(pieces); ++k) {
                cubic(cubicAlong(curve.part(k / pieces, (k + 1) / pieces)));
            }
            break;
        }
        }
    }
    void cubic(const Curve &curve) {
        const std::array<double, 8> n = curve.numbers();
        text += " C ";
        point({n[2], n[3]});
        text += ' ';
        point({n[4], n[5]});
        text += ' ';
        point({n[6], n[7]});
    }
};

/// Copies the element size or the number of elements of a boundary part, and its layers.
void copySizes(const Document &document, std::int32_t tag, Document &part) {
    const auto elements = document.elementCounts.find(tag);
    if (elements != document.elementCounts.end()) {
        part.elementCounts.insert(*elements);
    }
    const auto size = document.spacing.partSizes.find(tag);
    if (size != document.spacing.partSizes.end()) {
        part.spacing.partSizes.insert(*size);
    }
    std::copy_if(document.layers.begin(), document.layers.end(), std::back_inserter(part.layers),
                 [&](const LayerSpec &layer) { return layer.tag == tag; });
}

/// Returns a document with only the selected things.
Document selectedPart(const Document &document, const Selection &selection) {
    Document part;
    part.circleTolerance = document.circleTolerance;
    part.nextId = document.nextId;
    ReceivedItems items;
    for (const auto &shape : document.shapes) {
        if (selection.shapes.contains(shape->id)) {
            items.shapes[shape->id] = shape->id;
            part.shapes.push_back(shape);
            for (std::uint32_t k = 0; k < taggedSegments(*shape); ++k) {
                copySizes(document, segmentTag(*shape, k), part);
            }
            if (shape->is<PointForm>()) {
                copySizes(document, shape->tag, part);
            }
        }
    }
    for (const std::uint32_t k : selection.sources) {
        if (k < document.spacing.sources.size()) {
            items.sources[k] = static_cast<std::uint32_t>(part.spacing.sources.size());
            part.spacing.sources.push_back(document.spacing.sources[k]);
        }
    }
    for (const std::uint32_t k : selection.markers) {
        if (k < document.regionMarkers.size()) {
            items.markers[k] = static_cast<std::uint32_t>(part.regionMarkers.size());
            part.regionMarkers.push_back(document.regionMarkers[k]);
        }
    }
    part.boundaryNames = document.boundaryNames;
    part.regionNames = document.regionNames;
    bringFormulas(part, document, items);
    return part;
}

/// Returns the project in the metadata of an SVG drawing of ours; empty if there is none.
std::string projectIn(std::string_view svg) {
    const std::size_t begin = svg.find(kBegin);
    const std::size_t end = begin == std::string_view::npos ? begin : svg.find(kEnd, begin);
    if (end == std::string_view::npos) {
        return {};
    }
    const std::size_t first = begin + kBegin.size();
    return fromBase64(svg.substr(first, end - first)).value_or(std::string());
}

} // namespace

std::string clipboardText(const Document &document, const Selection &selection) {
    return clipboardText(selectedPart(document, selection));
}

std::string clipboardText(const Document &drawing) {
    if (drawing.shapes.empty() && drawing.spacing.sources.empty() && drawing.regionMarkers.empty()) {
        return {};
    }
    const Box2 bounds = boundsOf(drawing), box = bounds.empty() ? Box2{{0, 0}, {1, 1}} : bounds;
    SvgText svg;
    svg.text = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"";
    svg.point({box.min.x, box.max.y});
    svg.text += ' ';
    svg.number(box.size().x);
    svg.text += ' ';
    svg.number(box.size().y);
    svg.text += "\">\n";
    svg.text += std::string(kBegin) + toBase64(projectText(drawing)) + std::string(kEnd) + "\n<g stroke=\"black\">\n";
    for (const auto &shape : drawing.shapes) {
        if (!shape->is<PointForm>()) {
            svg.outline(outlineOf(*shape));
        }
    }
    return svg.text + "</g>\n</svg>\n";
}

Result<Document> readClipboard(std::string_view text, ImportNotes *notes) {
    SourceText source{text, "the clipboard", {}, {}};
    source.notes = notes;
    if (const std::string project = projectIn(text); !project.empty()) {
        source.text = project;
        return readProjectText(source);
    }
    if (looksLikeProject(text.substr(0, 400))) {
        return readProjectText(source);
    }
    if (looksLikeSvg(text.substr(0, 4096))) {
        const Result<Domain> domain = readSvgShapes(source);
        return domain ? Result<Document>(fromDomain(*domain)) : Result<Document>(domain.faults());
    }
    return readCoordinates(text, notes);
}

} // namespace forefront
