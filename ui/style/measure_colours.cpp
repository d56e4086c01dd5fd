#include "ui/style/measure_colours.hpp"

#include <algorithm>
#include <cmath>

namespace forefront {

namespace {

constexpr std::size_t kBins = 40;

/// The range of a histogram.
ColourRange wholeRange(Measure measure, const MeasureSummary &summary) {
    switch (measure) {
    case Measure::ShapeFactor:
    case Measure::ScaledJacobian:
    case Measure::Conformity:
        return {0.0, 1.0};
    case Measure::MinAngle:
        return {0.0, summary.maximum > 60.5 ? 90.0 : 60.0}; // of quadrilaterals, or of triangles
    case Measure::MaxAngle:
        return {60.0, 180.0};
    case Measure::Valence:
        return {0.5, std::max(12.0, std::min(summary.maximum, 40.0)) + 0.5};
    case Measure::Region:
        return {summary.minimum - 0.5, summary.maximum + 0.5};
    case Measure::SizeRatio: {
        const double far = std::max({1.25, summary.maximum, 1.0 / std::max(summary.minimum, 1e-3)});
        return {1.0 / std::min(far, 1e3), std::min(far, 1e3)};
    }
    default:
        break;
    }
    if (!infoOf(measure).logarithmic) {
        return {summary.minimum, std::max(summary.maximum, summary.minimum + 1.0)};
    }
    const double from = summary.minimum > 0.0 ? summary.minimum : std::max(summary.percentiles[0], 1e-300);
    return {from, std::max(std::min(summary.maximum, 1e6 * from), 1.05 * from)};
}

} // namespace

ColourMap mapOf(Measure measure, QualityScale scale, ThemeKind theme) {
    const bool dark = theme == ThemeKind::Dark;
    switch (measure) {
    case Measure::SizeRatio:
    case Measure::Valence:
        return dark ? divergingDark : diverging;
    case Measure::Region:
        return categories;
    default:
        break;
    }
    const BadEnd bad = infoOf(measure).bad;
    if (bad == BadEnd::None) {
        return viridis;
    }
    if (scale == QualityScale::Cividis) {
        return bad == BadEnd::Low ? cividis : cividisReversed;
    }
    if (bad == BadEnd::Low) {
        return dark ? qualityDark : qualityLight;
    }
    return dark ? qualityDarkReversed : qualityLightReversed;
}

std::optional<ColourRange> fixedRange(Measure measure) {
    switch (measure) {
    case Measure::ShapeFactor:
    case Measure::ScaledJacobian:
    case Measure::Conformity:
        return ColourRange{0.5, 1.0}; // red ends at 0.6, amber is 0.75, from 0.88 on it is quiet
    case Measure::MinAngle:
        return ColourRange{15.0, 60.0};
    case Measure::MaxAngle:
        return ColourRange{60.0, 150.0};
    case Measure::AreaRatio:
        return ColourRange{1.0, 5.0};
    default:
        return std::nullopt;
    }
}

ColourRange fittedRange(Measure measure, const MeasureSummary &summary) {
    const ColourRange whole = wholeRange(measure, summary);
    const double low = summary.percentiles.front(), high = summary.percentiles.back();
    constexpr std::size_t kMinBins = 2; // a narrower range would exaggerate tiny differences
    if (measure == Measure::Valence) {
        return {3.0, 9.0};
    }
    if (measure == Measure::SizeRatio) {
        const double far = std::max({1.1, high, 1.0 / std::max(low, 1e-6)});
        return {1.0 / far, far};
    }
    if (measure == Measure::Region || measure == Measure::Birth || summary.count == 0) {
        return whole;
    }
    MeasureHistogram bins{whole.from, whole.to, infoOf(measure).logarithmic, std::vector<std::uint64_t>(kBins)};
    ColourRange range = whole;
    if (infoOf(measure).bad != BadEnd::High) {
        range.from = bins.edge(std::min(bins.binOf(low), kBins - kMinBins));
    }
    if (infoOf(measure).bad != BadEnd::Low) {
        range.to = bins.edge(std::max(bins.binOf(high) + 1, kMinBins));
    }
    return range.from < range.to ? range : whole;
}

MeasureHistogram shownHistogram(Measure measure, std::span<const double> values, const MeasureSummary &summary) {
    const ColourRange whole = wholeRange(measure, summary);
    const bool counts = measure == Measure::Valence || measure == Measure::Region; // one bin for each number
    const double span = whole.to - whole.from;
    const std::size_t bins = counts && span <= 64.0 ? std::max<std::size_t>(1, static_cast<std::size_t>(span)) : kBins;
    return histogramOf(values, whole.from, whole.to, infoOf(measure).logarithmic, bins);
}

double mapPosition(Measure measure, const ColourRange &range, double value) {
    if (measure == Measure::Region) {
        constexpr double kCategories = 8.0;
        return (std::fmod(std::max(value, 1.0) - 1.0, kCategories) + 0.5) / kCategories;
    }
    if (infoOf(measure).logarithmic) {
        return value > 0.0 ? std::log(value / range.from) / std::log(range.to / range.from) : 0.0;
    }
    return range.position(value);
}

double mapValue(Measure measure, const ColourRange &range, double at) {
    return infoOf(measure).logarithmic ? range.from * std::pow(range.to / range.from, at)
                                       : range.from + at * (range.to - range.from);
}

Colour regionColour(std::int32_t tag) {
    return categories(mapPosition(Measure::Region, {}, tag));
}

} // namespace forefront
