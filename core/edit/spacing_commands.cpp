#include "core/edit/spacing_commands.hpp"

#include <algorithm>

namespace forefront {
namespace {

bool positive(std::optional<double> value) {
    return !value || (std::isfinite(*value) && *value > 0.0);
}

Diagnostics badSize(const char *what) {
    return error("bad-size", std::string(what) + " must be a number above 0");
}

} // namespace

Result<Document> setSize(const Document &document, std::optional<double> size) {
    if (!positive(size)) {
        return badSize("a size");
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
    if (!positive(minimum) || !positive(maximum)) {
        return badSize("a limit of the spacing");
    }
    if (minimum && maximum && *minimum > *maximum) {
        return error("bad-limits", "the least spacing is above the greatest");
    }
    Document next = document;
    next.spacing.minimum = minimum;
    next.spacing.maximum = maximum;
    return next;
}

Result<Document> setGradation(const Document &document, std::optional<double> gradation) {
    if (!positive(gradation)) {
        return error("bad-size", "the gradation must be a number above 0", "0.1 is gentle, 0.3 is steep");
    }
    Document next = document;
    next.spacing.gradation = gradation;
    return next;
}

Document setFromBoundary(const Document &document, bool fromBoundary) {
    Document next = document;
    next.spacing.fromBoundary = fromBoundary;
    return next;
}

Diagnostics checkSource(const SizeSource &source) {
    if (!isFinite(source.a) || !isFinite(source.b)) {
        return error("bad-source", "a coordinate of the source is not a finite number");
    }
    if (!std::isfinite(source.radius) || source.radius < 0.0 ||
        (source.shape == SourceShape::Circle && source.radius == 0.0)) {
        return error("bad-source", "a radius must be above 0");
    }
    if (!positive(source.size)) {
        return badSize("the size of a source");
    }
    if (!std::isfinite(source.growth) || source.growth < 0.0) {
        return error("bad-growth", "the growth of a source must be 0 or more");
    }
    return {};
}

Result<Document> addSource(const Document &document, SizeSource source) {
    if (Diagnostics faults = checkSource(source); !faults.empty()) {
        return faults;
    }
    Document next = document;
    next.spacing.sources.push_back(std::move(source));
    return next;
}

Result<Document> replaceSource(const Document &document, std::size_t index, SizeSource source) {
    if (index >= document.spacing.sources.size()) {
        return error("no-such-source", "there is no such source");
    }
    if (Diagnostics faults = checkSource(source); !faults.empty()) {
        return faults;
    }
    Document next = document;
    next.spacing.sources[index] = std::move(source);
    return next;
}

Result<Document> removeSource(const Document &document, std::size_t index) {
    if (index >= document.spacing.sources.size()) {
        return error("no-such-source", "there is no such source");
    }
    Document next = document;
    next.spacing.sources.erase(next.spacing.sources.begin() + static_cast<std::ptrdiff_t>(index));
    return next;
}

Document setPaint(const Document &document, PaintedSpacing paint) {
    Document next = document;
    next.spacing.paint = std::move(paint);
    return next;
}

Document setSpacing(const Document &document, SpacingSpec spacing) {
    Document next = document;
    next.spacing = std::move(spacing);
    return next;
}

std::string displayName(const SizeSource &source, std::size_t index) {
    if (!source.name.empty()) {
        return source.name;
    }
    const char *shape = source.shape == SourceShape::Point  ? "point"
                        : source.shape == SourceShape::Line ? "line"
                                                            : "circle";
    return std::string(shape) + " source " + std::to_string(index + 1);
}

} // namespace forefront
