#include "ui/parts/naming.hpp"

#include "core/drawing/formulas/spacing_commands.hpp"
#include "core/drawing/names/region_commands.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/tag_runs.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/edit_state.hpp"

#include <algorithm>
#include <charconv>
#include <string_view>
#include <system_error>
#include <utility>

namespace forefront {
namespace {

std::string counted(std::size_t number, const char *one, const char *many) {
    return ui::count(number) + ' ' + (number == 1 ? one : many);
}

std::string partTitle(const Document &document, const BoundaryPart &part) {
    if (part.shapes.size() == 1 && part.segments.empty()) {
        const Shape *const shape = findShape(document, *part.shapes.begin());
        return "Boundary tag of " + (shape != nullptr ? displayName(*shape) : std::string("the shape"));
    }
    std::string what = part.shapes.empty() ? "" : counted(part.shapes.size(), "shape", "shapes");
    if (!part.segments.empty()) {
        what += (what.empty() ? "" : " and ") + counted(part.segments.size(), "segment", "segments");
    }
    return "Boundary tag of " + what;
}

/// Returns the number that a text is, such as a tag; nothing if it is anything else.
std::optional<std::int32_t> tagNumber(const std::string &text) {
    std::int32_t number = 0;
    const char *const end = text.data() + text.size();
    const auto [rest, fault] = std::from_chars(text.data(), end, number);
    return fault == std::errc() && rest == end && number >= 1 ? std::optional(number) : std::nullopt;
}

/// Returns the named part of a label "label/boundary/SHAPE/RUN".
std::optional<NamedThing> labelledRun(const Document &document, std::uint32_t id, std::size_t run) {
    const Shape *const shape = findShape(document, id);
    const Outline outline = shape != nullptr ? outlineOf(*shape) : Outline();
    const std::vector<TagRun> runs = shape != nullptr ? tagRuns(*shape, outline) : std::vector<TagRun>();
    if (run >= runs.size()) {
        return std::nullopt;
    }
    NamedThing thing{.kind = NamedThing::Kind::Part, .shape = id, .tag = runs[run].tag};
    if (runs.size() == 1) {
        thing.part.shapes.insert(id);
    }
    for (std::size_t k = 0; k < runs[run].count && runs.size() > 1; ++k) {
        thing.part.segments.insert({id, outline.part(runs[run].segment(k, outline.segmentCount()))});
    }
    return thing;
}

/// Returns the tag that a thing has after it was given a name.
std::int32_t tagNow(const Document &document, const NamedThing &thing, const std::string &name) {
    if (thing.kind == NamedThing::Kind::Tag && !thing.existsIn(document)) {
        return boundaryTagNamed(document, name).value_or(thing.tag);
    }
    const bool part = thing.kind == NamedThing::Kind::Part && !thing.part.segments.empty();
    const SegmentRef first = part ? *thing.part.segments.begin() : SegmentRef();
    const Shape *const shape = part ? findShape(document, first.shape) : nullptr;
    return shape != nullptr && first.segment < taggedSegments(*shape) ? segmentTag(*shape, first.segment) : thing.tag;
}

} // namespace

bool NamedThing::existsIn(const Document &document) const {
    switch (kind) {
    case Kind::Shape:
        return findShape(document, shape) != nullptr;
    case Kind::Tag: {
        const std::vector<std::int32_t> tags = boundaryTags(document);
        return std::find(tags.begin(), tags.end(), tag) != tags.end();
    }
    case Kind::Part:
        return std::all_of(part.shapes.begin(), part.shapes.end(),
                           [&](std::uint32_t id) { return findShape(document, id) != nullptr; }) &&
               std::all_of(part.segments.begin(), part.segments.end(), [&](SegmentRef segment) {
                   const Shape *const owner = findShape(document, segment.shape);
                   return owner != nullptr && segment.segment < taggedSegments(*owner);
               });
    case Kind::Region:
        return marker < document.regionMarkers.size();
    case Kind::Source:
        return source < document.spacing.sources.size();
    }
    return false;
}

std::string NamedThing::name(const Document &document) const {
    switch (kind) {
    case Kind::Shape: {
        const Shape *const named = findShape(document, shape);
        return named != nullptr ? named->name : std::string();
    }
    case Kind::Tag:
    case Kind::Part:
        return boundaryName(document.boundaryNames, tag);
    case Kind::Region:
        return marker < document.regionMarkers.size()
                   ? regionName(document.regionNames, document.regionMarkers[marker].tag)
                   : std::string();
    case Kind::Source:
        return source < document.spacing.sources.size() ? document.spacing.sources[source].name : std::string();
    }
    return {};
}

std::string NamedThing::title(const Document &document) const {
    switch (kind) {
    case Kind::Shape: {
        const Shape *const named = findShape(document, shape);
        return "Name of " + (named != nullptr ? displayName(*named) : std::string("the shape"));
    }
    case Kind::Tag:
        return "Name of boundary " + std::to_string(tag) + " everywhere";
    case Kind::Part:
        return partTitle(document, part);
    case Kind::Region:
        return "Name of the region";
    case Kind::Source:
        return "Name of " + (source < document.spacing.sources.size()
                                 ? displayName(document.spacing.sources[source], source)
                                 : std::string("the source"));
    }
    return {};
}

std::vector<std::string> NamedThing::choices(const Document &document) const {
    std::vector<std::string> names;
    if (kind == Kind::Part || kind == Kind::Tag) {
        for (const std::int32_t known : boundaryTags(document)) {
            names.push_back(boundaryName(document.boundaryNames, known));
        }
    } else if (kind == Kind::Region) {
        for (const std::int32_t known : regionTags(document)) {
            names.push_back(regionName(document.regionNames, known));
        }
    }
    std::vector<std::string> once;
    for (std::string &each : names) {
        if (std::find(once.begin(), once.end(), each) == once.end()) {
            once.push_back(std::move(each));
        }
    }
    return once;
}

Result<Document> NamedThing::renamed(const Document &document, const std::string &name) const {
    switch (kind) {
    case Kind::Shape:
        return setShapeName(document, shape, name);
    case Kind::Tag:
        return renameBoundaryTag(document, tag, name);
    case Kind::Part: {
        // A number is a tag. Tags without a name have default ones, which can be entered too.
        const std::optional<std::int32_t> named = name.empty() ? std::nullopt : boundaryTagNamed(document, name);
        const std::optional<std::int32_t> known = named ? named : tagNumber(name);
        if (!known) {
            return nameBoundaryPart(document, part, name);
        }
        Result<Document> next = setShapeTag(document, part.shapes, *known);
        return next ? setSegmentTag(*next, part.segments, *known) : next;
    }
    case Kind::Region:
        return nameRegionOf(document, marker, name);
    case Kind::Source: {
        if (source >= document.spacing.sources.size()) {
            return document;
        }
        SizeSource renamed = document.spacing.sources[source];
        renamed.name = name;
        return replaceSource(document, source, std::move(renamed));
    }
    }
    return document;
}

void Naming::openInPanel(NamedThing what) {
    thing = std::move(what);
    inPanel = true;
    frames = 0;
}

void Naming::openOnCanvas(NamedThing what, Pixel place, const DocumentStore &store, bool label) {
    text = what.name(*store.current());
    revision = store.revision();
    thing = std::move(what);
    other.reset();
    inPanel = false;
    at = place;
    frames = 0;
    fault.clear();
    choice = -1;
    edited = false;
    everywhere = label;
}

void Naming::swapThings(const Document &document) {
    std::swap(thing, other);
    if (!edited) {
        text = thing->name(document);
    }
    fault.clear();
    choice = -1;
    everywhere = false;
}

void applyName(Shell &context, const NamedThing &thing, const std::string &name) {
    static constexpr const char *kLabels[] = {"Name shape", "Rename boundary", "Name boundary", "Name region",
                                              "Name source"};
    context.applyCommand(thing.renamed(*context.document.current(), name),
                         kLabels[static_cast<std::size_t>(thing.kind)]);
    if (std::optional<NamedThing> &row = context.naming.row; row && row->same(thing)) {
        row->tag = tagNow(*context.document.current(), *row, name); // the name may have brought another tag
    }
    context.animate();
}

std::optional<NamedThing> labelAt(const Shell &context, Pixel pixel) {
    constexpr std::string_view kBoundary = "label/boundary/", kRegion = "label/region/";
    const WidgetRegistry::Map &all = context.widgets.all();
    for (auto widget = all.lower_bound("label/"); widget != all.end() && widget->first.starts_with("label/");
         ++widget) {
        const std::string_view name = widget->first;
        if (!widget->second.rect.contains(pixel)) {
            continue;
        }
        const auto numberAt = [name](std::size_t begin) {
            std::uint32_t number = 0;
            std::from_chars(name.data() + std::min(begin, name.size()), name.data() + name.size(), number);
            return number;
        };
        if (name.starts_with(kRegion)) {
            return NamedThing{.kind = NamedThing::Kind::Region, .marker = numberAt(kRegion.size())};
        }
        return labelledRun(*context.document.current(), numberAt(kBoundary.size()), numberAt(name.rfind('/') + 1));
    }
    return std::nullopt;
}

Selection selectionOf(const Document &document, const NamedThing &thing) {
    Selection selection;
    switch (thing.kind) {
    case NamedThing::Kind::Shape:
        selection.shapes.insert(thing.shape);
        break;
    case NamedThing::Kind::Tag:
        return selectTag(document, thing.tag);
    case NamedThing::Kind::Part:
        selection.shapes = thing.part.shapes;
        selection.segments = thing.part.segments;
        break;
    case NamedThing::Kind::Region:
        selection.markers.insert(thing.marker);
        break;
    case NamedThing::Kind::Source:
        selection.sources.insert(thing.source);
        break;
    }
    selection.prune(document);
    return selection;
}

std::optional<NamedThing> boundaryPartOf(const Document &document, const Selection &selection) {
    if (selection.shapes.empty() && selection.segments.empty()) {
        return std::nullopt;
    }
    NamedThing thing{.kind = NamedThing::Kind::Part, .part = {selection.shapes, selection.segments}};
    const bool whole = !selection.shapes.empty();
    const std::uint32_t id = whole ? *selection.shapes.begin() : selection.segments.begin()->shape;
    const Shape *const shape = findShape(document, id);
    if (shape == nullptr) {
        return std::nullopt;
    }
    thing.tag = segmentTag(*shape, whole ? 0 : selection.segments.begin()->segment);
    return thing;
}

std::optional<NamedThing> namedThing(const Document &document, const Selection &selection) {
    if (selection.size() == 1 && selection.shapes.size() == 1) {
        const Shape *const shape = findShape(document, *selection.shapes.begin());
        const bool severalParts = shape != nullptr && !shape->segmentTags.empty();
        return severalParts ? std::optional(NamedThing{.kind = NamedThing::Kind::Shape, .shape = shape->id})
                            : boundaryPartOf(document, selection);
    }
    if (selection.size() == 1 && selection.markers.size() == 1) {
        return NamedThing{.kind = NamedThing::Kind::Region, .marker = *selection.markers.begin()};
    }
    if (selection.size() == 1 && selection.sources.size() == 1) {
        return NamedThing{.kind = NamedThing::Kind::Source, .source = *selection.sources.begin()};
    }
    return boundaryPartOf(document, selection);
}

std::optional<NamedThing> otherThing(const Document &document, const Selection &selection, const NamedThing &thing) {
    if (selection.size() != 1 || selection.shapes.size() != 1) {
        return std::nullopt;
    }
    if (thing.kind == NamedThing::Kind::Shape) {
        return boundaryPartOf(document, selection);
    }
    return thing.kind == NamedThing::Kind::Part
               ? std::optional(NamedThing{.kind = NamedThing::Kind::Shape, .shape = *selection.shapes.begin()})
               : std::nullopt;
}

} // namespace forefront
