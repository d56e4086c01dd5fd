#include "ui/widgets/log_plot_view.hpp"

#include "core/teaching/tables/power_law.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace forefront::ui {

namespace {

/// Draws a plot into a rectangle of the window: axes and marks at the left, the legend at the right.
class LogPlotView {
  public:
    LogPlotView(WidgetContext &context, const LogPlot &plot, const PixelRect &rect, PlotLegend legend)
        : context_(context), plot_(plot), list_(*ImGui::GetWindowDrawList()), x_(decadesOf(plot, &Vec2::x)),
          y_(decadesOf(plot, &Vec2::y)), legend_(legend) {
        constexpr double kLegend = 230.0, kMargin = 14.0, kAxis = 46.0, kAbove = 24.0, kBelow = 40.0;
        left_ = static_cast<float>(rect.x) + context.px(kAxis);
        right_ = static_cast<float>(rect.x + rect.width) - context.px(legend == PlotLegend::With ? kLegend : kMargin);
        top_ = static_cast<float>(rect.y) + context.px(kAbove);
        bottom_ = static_cast<float>(rect.y + rect.height) - context.px(kBelow);
        end_ = static_cast<float>(rect.x + rect.width);
    }

    void draw() {
        list_.AddRectFilled({left_, top_}, {right_, bottom_}, context_.theme.canvas);
        ImGui::PushFont(context_.fonts.small);
        axis(x_, true);
        axis(y_, false);
        words((left_ + right_) / 2, bottom_ + context_.px(21), plot_.xLabel, 0.5F, context_.theme.muted);
        words(left_, top_ - context_.px(20), plot_.yLabel, 0.0F, context_.theme.muted);
        float y = top_;
        for (std::size_t k = 0; k < plot_.series.size(); ++k) {
            series(plot_.series[k], colour(k));
            y += legend_ == PlotLegend::With ? legend(plot_.series[k], colour(k), y) : 0.0F;
        }
        ImGui::PopFont();
    }

  private:
    /// Series of the same grid have one colour, Lo's hollow and ours filled.
    Colour colour(std::size_t series) const {
        const Theme &theme = context_.theme;
        const Colour colours[] = {theme.candidate, theme.front, theme.good, theme.accent, theme.bad, theme.muted};
        std::vector<std::string> known;
        for (std::size_t k = 0; k <= series; ++k) {
            if (std::find(known.begin(), known.end(), plot_.series[k].colour) == known.end()) {
                known.push_back(plot_.series[k].colour);
            }
        }
        const auto at = std::find(known.begin(), known.end(), plot_.series[series].colour) - known.begin();
        return colours[static_cast<std::size_t>(at) % std::size(colours)];
    }

    ImVec2 place(Vec2 p) const {
        return {left_ + (right_ - left_) * static_cast<float>(x_.place(p.x)),
                bottom_ + (top_ - bottom_) * static_cast<float>(y_.place(p.y))};
    }
    void words(float x, float y, const std::string &text, float share, Colour colour) {
        list_.AddText({x - share * ImGui::CalcTextSize(text.c_str()).x, y}, colour, text.c_str());
    }

    /// Draws the lines of an axis, fine ones at 2 to 9 times each decade, and the numbers of the decades.
    void axis(const Decades &decades, bool horizontal) {
        const int step = std::max(1, (decades.last - decades.first) / 8);
        for (int d = decades.first; d <= decades.last; ++d) {
            for (int k = 1; k <= (d < decades.last ? 9 : 1); ++k) {
                const double at = decades.place(k * std::pow(10.0, d));
                const float x = left_ + (right_ - left_) * static_cast<float>(at);
                const float y = bottom_ + (top_ - bottom_) * static_cast<float>(at);
                const Colour ink = fade(context_.theme.gridLine, k == 1 ? 1.0 : 0.45);
                horizontal ? list_.AddLine({x, top_}, {x, bottom_}, ink) : list_.AddLine({left_, y}, {right_, y}, ink);
                if (k == 1 && (d - decades.first) % step == 0) {
                    const std::string number = ui::format("%g", std::pow(10.0, d));
                    const float half = 0.5F * ImGui::CalcTextSize(number.c_str()).x;
                    horizontal
                        ? words(std::min(x, end_ - half), bottom_ + context_.px(4), number, 0.5F, context_.theme.muted)
                        : words(left_ - context_.px(6), y - context_.px(8), number, 1.0F, context_.theme.muted);
                }
            }
        }
    }

    void mark(ImVec2 at, bool hollow, Colour colour) {
        list_.AddCircleFilled(at, context_.px(4), hollow ? context_.theme.canvas : colour);
        list_.AddCircle(at, context_.px(4), colour, 0, context_.px(1.5));
    }

    void series(const PlotSeries &series, Colour colour) {
        double from = INFINITY, to = 0.0;
        for (const Vec2 p : series.points) {
            from = std::min(from, p.x);
            to = std::max(to, p.x);
        }
        if (const auto law = fitPowerLaw(series.points)) {
            list_.AddLine(place({from, law->at(from)}), place({to, law->at(to)}),
                          fade(colour, series.published ? 0.6 : 1.0), context_.px(1.5));
        }
        for (const Vec2 p : series.points) {
            if (p.x > 0.0 && p.y > 0.0) {
                mark(place(p), series.published, colour);
            }
        }
    }

    /// Draws the line of the legend for a series and returns its height.
    float legend(const PlotSeries &series, Colour colour, float y) {
        const float x = right_ + context_.px(20), height = context_.px(19);
        mark({x, y + height / 2}, series.published, colour);
        std::string text = series.name;
        if (const auto law = fitPowerLaw(series.points)) {
            text += ui::format(", exponent %.2f", law->exponent);
        }
        list_.AddText({x + context_.px(12), y}, context_.theme.text, text.c_str());
        return height;
    }

    WidgetContext &context_;
    const LogPlot &plot_;
    ImDrawList &list_;
    Decades x_, y_;
    PlotLegend legend_;
    float left_ = 0.0F, right_ = 0.0F, top_ = 0.0F, bottom_ = 0.0F; ///< of the marks, in pixels
    float end_ = 0.0F;                                              ///< right edge of the whole plot
};

} // namespace

void logPlot(WidgetContext &context, std::string_view name, const LogPlot &plot, double height, PlotLegend legend) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 size{ImGui::GetContentRegionAvail().x, context.px(height)};
    ImGui::Dummy(size);
    ui::mark(context, name);
    LogPlotView(context, plot,
                {static_cast<double>(at.x), static_cast<double>(at.y), static_cast<double>(size.x),
                 static_cast<double>(size.y)},
                legend)
        .draw();
}

} // namespace forefront::ui
