#include "core/drawing/formulas/spacing_commands.hpp"

#include "core/drawing/formulas/bring_formulas.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/spacing/part_list.hpp"
#include "core/engine/spacing/parts/expression/expression_parser.hpp"
#include "core/engine/spacing/spec/spec_check.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>

namespace forefront {
namespace {

Diagnostics noSuchSource(std::size_t index) {
    return error("no-such-source", "size source " + std::to_string(index) + " not found");
}

/// A circle must have a radius when it is edited; one from a file may have none.
Diagnostics faultsOf(const SizeSource &source, std::size_t index) {
    Diagnostics faults;
    checkSource(source, static_cast<std::uint32_t>(index), faults);
    if (faults.empty() && source.shape == SourceShape::Circle && source.radius == 0.0) {
        faults = error("bad-source", "invalid circle radius 0; expected a number above 0");
    }
    return faults;
}

Result<Document> withGoodLimits(Document document) {
    Diagnostics faults;
    checkLimits(document.spacing, faults);
    if (!faults.empty()) {
        return faults;
    }
    return document;
}

/// Sets one of the numbers of elements of the spacing if `check` finds no fault in it.
Result<Document> withCheckedCount(const Document &document, std::optional<double> SpacingSpec::*member,
                                  const std::optional<double> &count,
                                  void (*check)(const std::optional<double> &, Diagnostics &)) {
    Diagnostics faults;
    check(count, faults);
    if (!faults.empty()) {
        return faults;
    }
    Document next = document;
    next.spacing.*member = count;
    return next;
}

} // namespace

Result<Document> setSize(const Document &document, std::optional<double> size) {
    Diagnostics faults;
    checkSize(size, "spacing", faults);
    if (!faults.empty()) {
        return faults;
    }
    Document next = document;
    next.spacing.size = size;
    return next;
}

Document setExpression(const Document &document, std::string expression) {
    Document next = document;
    if (expression.find_first_not_of(" \t\r\n") == std::string::npos) {
        next.spacing.expression.reset();
    } else {
        next.spacing.expression = std::move(expression);
    }
    return next;
}

Result<Document> setLimits(const Document &document, std::optional<double> minimum, std::optional<double> maximum) {
    Document next = document;
    next.spacing.minimum = minimum;
    next.spacing.maximum = maximum;
    return withGoodLimits(std::move(next));
}

Result<Document> setGradation(const Document &document, std::optional<double> gradation) {
    Document next = document;
    next.spacing.gradation = gradation;
    return withGoodLimits(std::move(next));
}

Result<Document> setSegmentsPerTurn(const Document &document, std::optional<double> count) {
    return withCheckedCount(document, &SpacingSpec::segmentsPerTurn, count, checkSegmentsPerTurn);
}

Result<Document> setElementsAcross(const Document &document, std::optional<double> count) {
    return withCheckedCount(document, &SpacingSpec::elementsAcross, count, checkElementsAcross);
}

Result<Document> setCurveTolerance(const Document &document, std::optional<double> tolerance) {
    if (tolerance && !(*tolerance > 0.0 && std::isfinite(*tolerance))) {
        return error("bad-tolerance",
                     "invalid curve tolerance " + numberText(*tolerance, 6) + "; expected a positive number");
    }
    Document next = document;
    next.curveTolerance = tolerance.value_or(0.0);
    return next;
}

Document setFromBoundary(const Document &document, bool fromBoundary) {
    Document next = document;
    next.spacing.fromBoundary = fromBoundary;
    return next;
}

Result<Document> addSource(const Document &document, SizeSource source) {
    if (Diagnostics faults = faultsOf(source, document.spacing.sources.size()); !faults.empty()) {
        return faults;
    }
    Document next = document;
    next.spacing.keepAutomatic = keepAutomaticWith(document.spacing);
    next.spacing.sources.push_back(std::move(source));
    return next;
}

std::optional<bool> keepAutomaticWith(const SpacingSpec &spacing) {
    return !spacing.keepAutomatic && spacing.sources.empty() ? std::optional(true) : spacing.keepAutomatic;
}

Document setKeepAutomatic(const Document &document, bool keep) {
    Document next = document;
    next.spacing.keepAutomatic = keep;
    return next;
}

Result<Document> replaceSource(const Document &document, std::size_t index, SizeSource source) {
    if (index >= document.spacing.sources.size()) {
        return noSuchSource(index);
    }
    if (Diagnostics faults = faultsOf(source, index); !faults.empty()) {
        return faults;
    }
    Document next = document;
    next.spacing.sources[index] = std::move(source);
    return next;
}

Result<Document> removeSource(const Document &document, std::size_t index) {
    if (index >= document.spacing.sources.size()) {
        return noSuchSource(index);
    }
    Document next = document;
    next.spacing.sources.erase(next.spacing.sources.begin() + static_cast<std::ptrdiff_t>(index));
    return next;
}

Result<Document> setPartSize(const Document &document, std::int32_t tag, std::optional<PartSize> size) {
    Document next = document;
    next.elementCounts.erase(tag);
    if (size) {
        next.spacing.partSizes[tag] = *size;
    } else {
        next.spacing.partSizes.erase(tag);
    }
    Diagnostics faults;
    checkPartSizes(next.spacing.partSizes, faults);
    if (!faults.empty()) {
        return faults;
    }
    return next;
}

Document setPaint(const Document &document, PaintedSpacing paint) {
    Document next = document;
    next.spacing.paint = std::move(paint);
    return next;
}

Result<Document> setSpacing(const Document &document, SpacingSpec spacing) {
    Document next = document;
    NameChanges changes;
    if (spacing.expression) {
        std::set<std::string> wanted;
        for (const std::string_view name : namesIn(*spacing.expression)) {
            wanted.emplace(name);
        }
        if (!bringParameters(next, constantParameters(spacing.names), wanted, changes)) {
            return error("too-many-parameters",
                         "the expression of the spacing uses parameters, and the document would have more than " +
                             std::to_string(kMaxParameters),
                         "remove parameters that are not used");
        }
        spacing.expression = renameIn(*spacing.expression, changes);
    }
    spacing.names = next.spacing.names;
    spacing.placed = {}; // nodes and regions of the document have their own
    next.spacing = std::move(spacing);
    next.elementCounts.clear();
    for (auto &pointer : next.shapes) { // as those of boundary parts
        if (!pointer->segmentSizes.empty()) {
            Shape shape = *pointer;
            shape.segmentSizes.clear();
            pointer = std::make_shared<const Shape>(std::move(shape));
        }
    }
    return next;
}

Result<Document> setImportedSpacing(const Document &document, SpacingSpec spacing) {
    SpacingSpec rest = spacing;
    rest.background = nullptr;
    if (!spacing.background || !sameContent(rest, SpacingSpec())) {
        return setSpacing(document, std::move(spacing));
    }
    Document next = document;
    next.spacing.size.reset();
    next.spacing.expression.reset();
    next.spacing.fromBoundary = false;
    next.spacing.background = std::move(spacing.background);
    return next;
}

std::string displayName(const SizeSource &source, std::size_t index) {
    if (!source.name.empty()) {
        return source.name;
    }
    return std::string(wordOf(source.shape)) + " source " + std::to_string(index + 1);
}

} // namespace forefront
