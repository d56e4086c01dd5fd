#include "ui/canvas/legend.hpp"

#include "ui/canvas/ruler_scale.hpp"
#include "ui/style/imgui_versions.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace forefront {

namespace {

ImVec2 im(double x, double y) {
    return {static_cast<float>(x), static_cast<float>(y)};
}

ImVec2 extent(ImFont *font, const std::string &text) {
    return font->CalcTextSizeA(imgui::lineOf(*font), 1e9F, 0.0F, text.c_str());
}

/// Hatches the bad side of a limit and draws the tick by which it is dragged.
void drawLimit(ImDrawList &list, const Theme &theme, const PixelRect &bar, const LegendLimit &limit, double s) {
    const double at = bar.x + limit.at * bar.width;
    const double from = limit.below ? bar.x : at, to = limit.below ? at : bar.x + bar.width;
    const double bottom = bar.y + bar.height;
    list.PushClipRect(im(from, bar.y), im(to, bottom), true);
    const double step = 5.0 * s;
    const int lines = static_cast<int>(std::ceil((to - from + bar.height) / step));
    for (int k = 0; k < lines; ++k) {
        const double x = from - bar.height + k * step;
        list.AddLine(im(x, bottom), im(x + bar.height, bar.y), fade(theme.boundary, 0.8), static_cast<float>(1.5 * s));
    }
    list.PopClipRect();
    const double half = 4.5 * s;
    list.AddLine(im(at, bar.y - 2.0 * s), im(at, bottom), theme.text, static_cast<float>(2.0 * s));
    list.AddTriangleFilled(im(at - half, bar.y - 6.5 * s), im(at + half, bar.y - 6.5 * s), im(at, bar.y - 0.5 * s),
                           theme.text);
}

} // namespace

std::vector<LegendLabel> legendLabels(ImFont *font, const std::vector<LegendTick> &ticks, double bar, double gap) {
    std::vector<LegendLabel> labels;
    const auto place = [&](const LegendTick &tick) {
        const double width = static_cast<double>(extent(font, tick.text).x);
        const double left = std::round(std::clamp(tick.at * bar - 0.5 * width, 0.0, std::max(0.0, bar - width)));
        const bool free = std::all_of(labels.begin(), labels.end(), [&](const LegendLabel &other) {
            return left >= other.left + other.width + gap || other.left >= left + width + gap;
        });
        if (free) {
            labels.push_back({left, width, tick.text, tick.at});
        }
    };
    if (!ticks.empty()) {
        place(ticks.front());
        place(ticks.back());
    }
    for (std::size_t i = 1; i + 1 < ticks.size(); ++i) {
        place(ticks[i]);
    }
    return labels;
}

PixelRect colourBarRect(Pixel corner, double scale) {
    const double left = std::round(corner.x - kLegendWidth * scale), top = std::round(corner.y - kLegendHeight * scale);
    return {left + 12.0 * scale, top + 26.0 * scale, (kLegendWidth - 24.0) * scale, 9.0 * scale};
}

void drawColourBar(CanvasPainter &painter, const Theme &theme, const Fonts &fonts, Pixel corner, const ColourBar &bar) {
    const double s = painter.scale();
    const double width = kLegendWidth * s, height = kLegendHeight * s;
    const double left = std::round(corner.x - width), top = std::round(corner.y - height);
    const auto round = static_cast<float>(6.0 * s);
    ImDrawList &list = painter.list();
    list.AddRectFilled(im(left, top), im(left + width, top + height), fade(theme.popup, 0.92), round);
    list.AddRect(im(left, top), im(left + width, top + height), theme.popupBorder, round);
    const PixelRect rect = colourBarRect(corner, s);
    list.AddText(fonts.small, imgui::lineOf(*fonts.small), im(rect.x, top + 6.0 * s), theme.muted, bar.title.c_str());
    const auto colour = [&](double t) { return mix(theme.domain, bar.map(t), bar.opacity); };
    constexpr int kPieces = 64;
    for (int i = 0; i < kPieces; ++i) {
        const double from = static_cast<double>(i) / kPieces, to = static_cast<double>(i + 1) / kPieces;
        list.AddRectFilledMultiColor(im(rect.x + from * rect.width, rect.y),
                                     im(rect.x + to * rect.width, rect.y + rect.height), colour(from), colour(to),
                                     colour(to), colour(from));
    }
    if (bar.limit) {
        drawLimit(list, theme, rect, *bar.limit, s);
    }
    for (const LegendLabel &label : legendLabels(fonts.small, bar.ticks, rect.width, 6.0 * s)) {
        const double at = rect.x + label.at * rect.width; // a tick whose number has no room is left out with it
        const double y = rect.y + rect.height;
        list.AddLine(im(at, y), im(at, y + 3.0 * s), theme.muted);
        list.AddText(fonts.small, imgui::lineOf(*fonts.small), im(rect.x + label.left, y + 3.0 * s), theme.text,
                     label.text.c_str());
    }
}

std::vector<LegendTick> linearTicks(const ColourRange &range) {
    std::vector<LegendTick> ticks{{0.0, "\xe2\x89\xa4" + ui::number(range.from, 3)}};
    const double minStep = (range.to - range.from) / 4.0;
    const double power = std::pow(10.0, std::floor(std::log10(minStep)));
    const double step = power * (minStep <= power         ? 1.0
                                 : minStep <= 2.0 * power ? 2.0
                                 : minStep <= 5.0 * power ? 5.0
                                                          : 10.0);
    const Multiples within = multiplesWithin(range.from, range.to, step);
    for (int k = 0; k < within.count; ++k) {
        const double value = (within.first + k) * step, at = range.position(value);
        if (at > 0.1 && at < 0.92) { // not too close to the ends
            ticks.push_back({at, ui::number(value, 3)});
        }
    }
    ticks.push_back({1.0, ui::number(range.to, 3)});
    return ticks;
}

std::vector<double> roundValues(double minimum, double maximum, std::size_t limit) {
    std::vector<double> values;
    const int first = static_cast<int>(std::floor(std::log10(minimum)));
    for (const std::vector<double> &digits : {std::vector<double>{1, 2, 5}, {1, 3}, {1}}) {
        values.clear();
        for (int power = first; power < first + 40 && std::pow(10.0, power) <= maximum; ++power) {
            for (const double digit : digits) {
                const double value = digit * std::pow(10.0, power);
                if (value >= minimum * 0.999 && value <= maximum * 1.001) {
                    values.push_back(value);
                }
            }
        }
        if (values.size() <= limit) {
            break;
        }
    }
    while (values.size() > limit) {
        for (std::size_t i = 1; i < values.size(); ++i) {
            values.erase(values.begin() + static_cast<std::ptrdiff_t>(i));
        }
    }
    return values;
}

std::vector<double> contourValues(double minimum, double maximum, std::size_t limit) {
    constexpr double kApart = 1.01; // from the ends, more than a raster of single precision is off
    std::vector<double> values = roundValues(minimum, maximum, limit);
    std::erase_if(values, [&](double value) { return value < kApart * minimum || kApart * value > maximum; });
    return values;
}

std::vector<LegendTick> logarithmicTicks(double minimum, double maximum, std::size_t limit) {
    if (!(minimum > 0.0) || !(maximum > minimum)) {
        return {{0.5, ui::number(minimum, 3)}};
    }
    std::vector<LegendTick> ticks;
    const double span = std::log(maximum / minimum);
    for (const double value : roundValues(minimum, maximum, limit)) {
        ticks.push_back({std::clamp(std::log(value / minimum) / span, 0.0, 1.0), ui::number(value, 3)});
    }
    // The ends are always labelled; round numbers close to them are not.
    std::erase_if(ticks, [](const LegendTick &tick) { return tick.at < 0.16 || tick.at > 0.84; });
    ticks.insert(ticks.begin(), {0.0, ui::number(minimum, 2)});
    ticks.push_back({1.0, ui::number(maximum, 2)});
    return ticks;
}

} // namespace forefront
