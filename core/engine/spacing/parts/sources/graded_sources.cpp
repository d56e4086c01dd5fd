#include "core/engine/spacing/parts/sources/graded_sources.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace forefront {

bool isGraded(const SizeSource &source) {
    const bool differs = source.endSize && *source.endSize != source.size;
    return source.shape == SourceShape::Line && (differs || source.plane) &&
           std::isfinite(1.0 / distanceSquared(source.a, source.b));
}

/// Returns the size of a gradient at a position along its line.
double GradedSources::Line::alongPlane(double x) const {
    const double free = std::clamp(x, 0.0, steepFrom);
    const double rho = octaves > 0.0 ? size * std::exp(octaves * free / length) : size + slope * free;
    const double beyond = x - steepFrom;
    const double largest = octaves > 0.0 ? size * std::exp(octaves) : size + slope * length;
    return beyond > 0.0 && steepFrom < length ? std::min(largest, rho + gradation * beyond) : rho;
}

double GradedSources::Line::at(Vec2 p) const {
    const Vec2 d = p - from;
    const double x = dot(d, along), y = std::fabs(cross(along, d));
    if (plane) {
        return alongPlane(x);
    }
    const double nearest = std::clamp(x, 0.0, length);
    const double rho = size + slope * nearest + growth * std::max(0.0, std::hypot(x - nearest, y) - radius);
    return steep && x > 0.0 ? std::min(rho, limitedAt(x, std::max(0.0, y - radius))) : rho;
}

/// Returns the smallest value that the gradation allows at a place beside or beyond the line, `x` > 0 along it and
/// `side` beyond the radius. What limits it most is either on the line, or, where the growth is less than the
/// gradation, in the direction perpendicular to the line at its finer end.
double GradedSources::Line::limitedAt(double x, double side) const {
    const auto leg = [this](double part) { return std::sqrt((gradation - part) * (gradation + part)); };
    const double onLine = slope < gradation ? std::clamp(x - side * slope / leg(slope), 0.0, length) : 0.0;
    const double above = growth < gradation ? std::max(0.0, side - x * growth / leg(growth)) : 0.0;
    return std::min(size + slope * onLine + gradation * std::hypot(x - onLine, side),
                    size + growth * above + gradation * std::hypot(x, side - above));
}

double GradedSources::Line::lowerBound(const Box2 &box) const {
    if (plane) {
        double least = length; // the position of a corner: the gradient never falls along its line
        for (const Vec2 corner : {box.min, box.max, Vec2{box.min.x, box.max.y}, Vec2{box.max.x, box.min.y}}) {
            least = std::min(least, dot(corner - from, along));
        }
        return alongPlane(least);
    }
    const double steepest = std::min(std::hypot(slope, growth), gradation);
    return std::max(size, at(box.centre()) - steepest * 0.5 * box.diagonal());
}

double GradedSources::Line::upperBound(const Box2 &box) const {
    if (plane) {
        double most = 0.0;
        for (const Vec2 corner : {box.min, box.max, Vec2{box.min.x, box.max.y}, Vec2{box.max.x, box.min.y}}) {
            most = std::max(most, dot(corner - from, along));
        }
        return alongPlane(most);
    }
    double farthest = 0.0; // a corner, since the distance to a convex shape is convex
    for (const Vec2 corner : {box.min, box.max, Vec2{box.min.x, box.max.y}, Vec2{box.max.x, box.min.y}}) {
        const double x = std::clamp(dot(corner - from, along), 0.0, length);
        farthest = std::max(farthest, distance(corner, from + x * along));
    }
    return size + slope * length + growth * std::max(0.0, farthest - radius);
}

namespace {

/// Returns where along its line a gradient gets steeper than the gradation; its length if it does not.
double steepPlace(double size, double slope, double octaves, double length, double gradation) {
    if (octaves <= 0.0) {
        return slope > gradation ? 0.0 : length;
    }
    // size·octaves/length·exp(octaves·x/length) = gradation
    const double x = length / octaves * std::log(gradation * length / (size * octaves));
    return std::clamp(x, 0.0, length);
}

} // namespace

std::optional<GradedSources> GradedSources::build(std::span<const SizeSource> sources, double gradation,
                                                  const Box2 &box) {
    GradedSources part;
    part.minimum_ = part.maximum_ = std::numeric_limits<double>::infinity();
    for (std::uint32_t k = 0; k < sources.size(); ++k) {
        const SizeSource &source = sources[k];
        if (!isGraded(source)) {
            continue;
        }
        Line line;
        const double endSize = source.endSize.value_or(source.size);
        const bool forward = source.size < endSize;
        const double length = distance(source.a, source.b);
        line.from = forward ? source.a : source.b;
        line.along = (1.0 / length) * ((forward ? source.b : source.a) - line.from);
        line.length = length;
        line.radius = source.radius;
        line.size = std::min(source.size, endSize);
        line.slope = std::fabs(endSize - source.size) / length;
        line.growth = std::min(source.growth, gradation);
        line.gradation = gradation;
        line.steep = std::hypot(line.slope, line.growth) > gradation;
        line.plane = source.plane;
        line.octaves = source.plane && source.geometric ? std::log(std::max(source.size, endSize) / line.size) : 0.0;
        line.steepFrom = steepPlace(line.size, line.slope, line.octaves, length, gradation);
        line.source = k;
        part.minimum_ = std::min(part.minimum_, line.lowerBound(box));
        part.maximum_ = std::min(part.maximum_, line.upperBound(box));
        part.lines_.push_back(line);
    }
    return part.lines_.empty() ? std::nullopt : std::optional(std::move(part));
}

double GradedSources::at(Vec2 p) const {
    double rho = std::numeric_limits<double>::infinity();
    for (const Line &line : lines_) {
        rho = std::min(rho, line.at(p));
    }
    return rho;
}

SpacingSample GradedSources::sample(Vec2 p, const SiteWords &words) const {
    const auto winner =
        std::min_element(lines_.begin(), lines_.end(), [p](const Line &a, const Line &b) { return a.at(p) < b.at(p); });
    SpacingSample sample{winner->at(p), SpacingOrigin::Source, winner->source, sourceWords(words, winner->source)};
    for (auto line = lines_.begin(); line != lines_.end(); ++line) {
        if (line != winner && (!sample.runnerUp || line->at(p) < sample.runnerUp->rho)) {
            sample.runnerUp = SpacingRunnerUp{line->at(p), sourceWords(words, line->source)};
        }
    }
    return sample;
}

} // namespace forefront
