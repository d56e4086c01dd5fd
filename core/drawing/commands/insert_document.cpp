#include "core/drawing/commands/insert_document.hpp"

#include "core/drawing/commands/convert_unit.hpp"
#include "core/drawing/constraints/map_constraints.hpp"
#include "core/drawing/formulas/bring_formulas.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/formulas/spacing_commands.hpp"
#include "core/drawing/names/distinct_tags.hpp"
#include "core/drawing/names/region_commands.hpp"
#include "core/drawing/shapes/groups.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace forefront {
namespace {

/// The positions of all shapes, sources and markers of a document.
class ItemPlaces {
  public:
    explicit ItemPlaces(const Document &document) {
        for (const auto &shape : document.shapes) {
            places_.push_back({static_cast<int>(shape->kind()), shape->nodes});
        }
        for (const SizeSource &source : document.spacing.sources) {
            places_.push_back({kFirstSource + static_cast<int>(source.shape), {source.a, source.b}});
        }
        for (const MarkedRegion &marker : document.regionMarkers) {
            places_.push_back({kMarker, {marker.at}});
        }
        std::sort(places_.begin(), places_.end(), before);
    }

    /// Returns true if an item coincides with one of the same kind in another document.
    bool meet(const ItemPlaces &other) const {
        return std::any_of(other.places_.begin(), other.places_.end(), [this](const Place &place) {
            return std::binary_search(places_.begin(), places_.end(), place, before);
        });
    }

  private:
    static constexpr int kMarker = -1, kFirstSource = 100;
    struct Place {
        int kind = 0;
        std::vector<Vec2> points;
    };
    static bool before(const Place &a, const Place &b) {
        return a.kind != b.kind ? a.kind < b.kind
                                : std::lexicographical_compare(a.points.begin(), a.points.end(), b.points.begin(),
                                                               b.points.end(), comesBefore);
    }

    std::vector<Place> places_;
};

Diagnostics notesOf(std::size_t droppedFormulas) {
    if (droppedFormulas == 0) {
        return {};
    }
    Diagnostic note;
    note.severity = Severity::Warning;
    note.code = "dropped-formulas";
    note.message = std::to_string(droppedFormulas) +
                   (droppedFormulas == 1 ? " formula became a plain number" : " formulas became plain numbers") +
                   "; the document would need more than " + std::to_string(kMaxParameters) + " parameters";
    note.advice = "undo, remove parameters that are not used, and insert again";
    return {note};
}

/// Returns a document with the drawing of another one and the given sources.
Document inserted(const Document &document, const Document &other, double scale, const std::vector<SizeSource> &sources,
                  Insertion *insertion) {
    Document next = document;
    Selection fresh;
    ReceivedItems items;
    CopiedGroups groups(document);
    if (document.unit == LengthUnit::None && document.shapes.empty() && scale == 1.0) {
        next.unit = other.unit;
    }
    for (const auto &shape : other.shapes) {
        auto copy = std::make_shared<Shape>(*shape);
        copy->id = next.nextId++;
        copy->group = groups(shape->group);
        scaleShape(*copy, scale);
        fresh.shapes.insert(copy->id);
        items.shapes[shape->id] = copy->id;
        next.shapes.push_back(std::move(copy));
    }
    for (const MarkedRegion &marker : other.regionMarkers) {
        const auto index = static_cast<std::uint32_t>(next.regionMarkers.size());
        fresh.markers.insert(index);
        items.markers[static_cast<std::uint32_t>(items.markers.size())] = index;
        next.regionMarkers.push_back(
            {scale * marker.at, marker.tag, scale * scale * marker.maxArea, scale * marker.size, marker.growth});
    }
    next.spacing.keepAutomatic = sources.empty() ? next.spacing.keepAutomatic : keepAutomaticWith(document.spacing);
    for (const SizeSource &source : sources) {
        const auto index = static_cast<std::uint32_t>(next.spacing.sources.size());
        fresh.sources.insert(index);
        items.sources[static_cast<std::uint32_t>(items.sources.size())] = index;
        next.spacing.sources.push_back(source);
    }
    const std::vector<std::int32_t> known = boundaryTags(document);
    for (const auto &[tag, elements] : other.elementCounts) {
        if (!std::binary_search(known.begin(), known.end(), tag)) {
            next.elementCounts.emplace(tag, elements);
        }
    }
    for (LayerSpec layer : other.layers) {
        const bool taken = std::any_of(document.layers.begin(), document.layers.end(),
                                       [&](const LayerSpec &own) { return own.tag == layer.tag; });
        if (!taken && !std::binary_search(known.begin(), known.end(), layer.tag)) {
            layer.first *= scale;
            layer.thickness = layer.thickness ? std::optional(scale * *layer.thickness) : std::nullopt;
            next.layers.push_back(layer);
        }
    }
    const auto isNew = [&](std::int32_t tag) {
        return !std::binary_search(known.begin(), known.end(), tag) &&
               std::none_of(document.periodic.begin(), document.periodic.end(),
                            [&](const PeriodicSpec &own) { return own.from == tag || own.to == tag; });
    };
    std::copy_if(other.periodic.begin(), other.periodic.end(), std::back_inserter(next.periodic),
                 [&](const PeriodicSpec &spec) { return isNew(spec.from) && isNew(spec.to); });
    std::copy_if(other.cracks.begin(), other.cracks.end(), std::back_inserter(next.cracks), [&](std::int32_t tag) {
        return !std::binary_search(known.begin(), known.end(), tag) && std::ranges::count(document.cracks, tag) == 0;
    });
    for (StripSpec spec : other.strips) {
        const bool taken =
            std::ranges::any_of(document.strips, [&](const StripSpec &own) { return own.tag == spec.tag; });
        if (!taken && !std::binary_search(known.begin(), known.end(), spec.tag)) {
            spec.width *= scale;
            next.strips.push_back(spec);
        }
    }
    const auto has = [](const auto &list, std::int32_t region) {
        return std::ranges::any_of(list, [&](const auto &own) { return own.region == region; });
    };
    const auto isNewRegion = [&](std::int32_t region) {
        return !(region == 1 && !document.shapes.empty()) && // faces without a marker
               std::ranges::none_of(document.regionMarkers, [&](const auto &own) { return own.tag == region; });
    };
    std::ranges::copy_if(other.regionElements, std::back_inserter(next.regionElements), [&](const auto &own) {
        return isNewRegion(own.region) && !has(document.regionElements, own.region);
    });
    for (const MappedSpec &spec : other.mapped) {
        if (isNewRegion(spec.region) && !has(document.mapped, spec.region)) {
            MappedSpec &copy = next.mapped.emplace_back(spec);
            std::ranges::transform(copy.corners, copy.corners.begin(), [scale](Vec2 p) { return scale * p; });
        }
    }
    next.boundaryNames.insert(other.boundaryNames.begin(), other.boundaryNames.end());
    next.regionNames.insert(other.regionNames.begin(), other.regionNames.end());
    items.constraints = copyConstraints(next, other, items.shapes);
    mapConstraints(next, fresh.shapes, PlaneMap::scaling({scale, scale}, {}));
    const std::size_t dropped = bringFormulas(next, other, items, scale);
    if (insertion != nullptr) {
        *insertion = {std::move(fresh), notesOf(dropped)};
    }
    return next;
}

} // namespace

Document insertDrawing(const Document &document, const Document &other, double scale, Insertion *insertion) {
    return inserted(document, withDistinctTags(other, document), scale, {}, insertion);
}

Result<Document> insertCopied(const Document &document, const Document &copied, Vec2 step, Insertion *insertion) {
    const double scale = conversion(copied.unit, document.unit).value_or(1.0);
    const Result<Document> converted = scale == 1.0 ? Result<Document>(copied) : convertUnit(copied, document.unit);
    if (!converted) {
        return converted;
    }
    const Document other = withDistinctTags(*converted, document);
    Selection all = selectAll(other);
    for (const auto &shape : other.shapes) { // hidden and locked ones must move, too
        all.shapes.insert(shape->id);
    }
    const ItemPlaces taken(document);
    Result<Document> moved = other;
    constexpr int kMaxSteps = 1000; // guards against steps too small to move anything
    for (int k = 1; k <= kMaxSteps && taken.meet(ItemPlaces(*moved)); ++k) {
        moved = moveSelection(other, all, static_cast<double>(k) * step);
        if (!moved) {
            return moved;
        }
    }
    Document next = inserted(document, *moved, 1.0, moved->spacing.sources, insertion);
    const std::vector<std::int32_t> known = boundaryTags(document);
    for (const auto &[tag, size] : moved->spacing.partSizes) {
        if (!std::binary_search(known.begin(), known.end(), tag) && !next.elementCounts.contains(tag)) {
            next.spacing.partSizes.insert_or_assign(tag, size);
        }
    }
    return next;
}

} // namespace forefront
