#include "core/teaching/tables/log_plot.hpp"

#include "core/teaching/tables/power_law.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace forefront {

namespace {

// The sheet in pixels: the frame of the plot, with the legend to its right.
constexpr double kWidth = 900.0, kHeight = 520.0;
constexpr double kLeft = 78.0, kRight = 640.0, kTop = 54.0, kBottom = 458.0;
constexpr const char *kInk = "#24292f";
constexpr const char *kQuiet = "#57606a";
constexpr const char *kDecadeLine = "#d0d7de";
constexpr const char *kFineLine = "#eef1f4";

std::string oneDecimal(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", value);
    return text;
}

std::string escaped(const std::string &text) {
    std::string result;
    for (const char c : text) {
        result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
    }
    return result;
}

/// An axis of the sheet.
struct Axis : Decades {
    double from = 0.0, to = 1.0; ///< pixels

    double place(double value) const { return from + (to - from) * Decades::place(value); }
};

class PlotDrawing {
  public:
    explicit PlotDrawing(const LogPlot &plot)
        : plot_(plot), x_{decadesOf(plot, &Vec2::x), kLeft, kRight}, y_{decadesOf(plot, &Vec2::y), kBottom, kTop} {}

    std::string run() {
        svg_ = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + oneDecimal(kWidth) + ' ' +
               oneDecimal(kHeight) +
               "\" font-family=\"Inter, Helvetica, Arial, sans-serif\" font-size=\"13\">\n"
               "<rect width=\"100%\" height=\"100%\" rx=\"8\" fill=\"#ffffff\"/>\n";
        text(kLeft, 30.0, plot_.title, kInk, "font-size=\"17\" font-weight=\"600\"");
        axes();
        for (const PlotSeries &series : plot_.series) {
            draw(series);
        }
        legend();
        return svg_ + "</svg>\n";
    }

  private:
    void line(Vec2 a, Vec2 b, const std::string &style) {
        svg_ += "<path d=\"M" + oneDecimal(a.x) + ' ' + oneDecimal(a.y) + 'L' + oneDecimal(b.x) + ' ' +
                oneDecimal(b.y) + "\" fill=\"none\" " + style + "/>\n";
    }
    void text(double x, double y, const std::string &words, const char *colour, const std::string &style) {
        svg_ += "<text x=\"" + oneDecimal(x) + "\" y=\"" + oneDecimal(y) + "\" fill=\"" + colour + "\" " + style + '>' +
                escaped(words) + "</text>\n";
    }
    static std::string stroke(const std::string &colour, double width, bool dashed = false) {
        return "stroke=\"" + colour + "\" stroke-width=\"" + oneDecimal(width) + '"' +
               (dashed ? " stroke-dasharray=\"5 4\"" : "");
    }

    void axes() {
        for (const bool decades : {false, true}) {
            gridLines(x_, decades, [&](double at) { return std::pair(Vec2{at, kBottom}, Vec2{at, kTop}); });
            gridLines(y_, decades, [&](double at) { return std::pair(Vec2{kLeft, at}, Vec2{kRight, at}); });
        }
        for (int d = x_.first; d <= x_.last; ++d) {
            power(x_.place(std::pow(10.0, d)), kBottom + 20.0, d, "middle");
        }
        for (int d = y_.first; d <= y_.last; ++d) {
            power(kLeft - 8.0, y_.place(std::pow(10.0, d)) + 4.5, d, "end");
        }
        text(0.5 * (kLeft + kRight), kBottom + 44.0, plot_.xLabel, kQuiet, "text-anchor=\"middle\"");
        const double middle = 0.5 * (kTop + kBottom);
        text(22.0, middle, plot_.yLabel, kQuiet,
             "text-anchor=\"middle\" transform=\"rotate(-90 22 " + oneDecimal(middle) + ")\"");
    }
    /// Draws the lines at the decades, or the fine ones at 2 to 9 times each.
    template <class Ends>
    void gridLines(const Axis &axis, bool decades, Ends &&ends) {
        for (int d = axis.first; d <= axis.last; ++d) {
            for (int k = decades ? 1 : 2; k <= (decades ? 1 : d < axis.last ? 9 : 0); ++k) {
                const auto [a, b] = ends(axis.place(k * std::pow(10.0, d)));
                line(a, b, stroke(decades ? kDecadeLine : kFineLine, 1.0));
            }
        }
    }
    /// Writes a power of ten, or the number itself if it is short.
    void power(double x, double y, int decade, const char *anchor) {
        const std::string style = std::string("text-anchor=\"") + anchor + '"';
        if (decade >= -2 && decade <= 3) {
            char words[16];
            std::snprintf(words, sizeof words, "%g", std::pow(10.0, decade));
            text(x, y, words, kQuiet, style);
            return;
        }
        svg_ += "<text x=\"" + oneDecimal(x) + "\" y=\"" + oneDecimal(y) + "\" fill=\"" + kQuiet + "\" " + style +
                ">10<tspan dy=\"-5\" font-size=\"10\">" + std::to_string(decade) + "</tspan></text>\n";
    }

    void mark(Vec2 at, const PlotSeries &series) {
        svg_ += "<circle cx=\"" + oneDecimal(at.x) + "\" cy=\"" + oneDecimal(at.y) + "\" r=\"4\" fill=\"" +
                (series.published ? "#ffffff" : series.colour) + "\" " + stroke(series.colour, 1.8) + "/>\n";
    }
    void draw(const PlotSeries &series) {
        double from = INFINITY, to = 0.0;
        for (const Vec2 p : series.points) {
            from = std::min(from, p.x);
            to = std::max(to, p.x);
        }
        if (const auto law = fitPowerLaw(series.points)) {
            line({x_.place(from), y_.place(law->at(from))}, {x_.place(to), y_.place(law->at(to))},
                 stroke(series.colour, 1.6, series.published));
        }
        for (const Vec2 p : series.points) {
            if (p.x > 0.0 && p.y > 0.0) {
                mark({x_.place(p.x), y_.place(p.y)}, series);
            }
        }
    }

    void legend() {
        double y = kTop + 14.0;
        for (const PlotSeries &series : plot_.series) {
            constexpr double kStart = kRight + 22.0;
            line({kStart, y}, {kStart + 34.0, y}, stroke(series.colour, 1.6, series.published));
            mark({kStart + 17.0, y}, series);
            text(kStart + 44.0, y + 4.5, series.name, kInk, "");
            if (const auto law = fitPowerLaw(series.points)) {
                char words[32];
                std::snprintf(words, sizeof words, "%.2f", law->exponent);
                text(kWidth - 24.0, y + 4.5, words, kQuiet, "text-anchor=\"end\"");
            }
            y += 27.0;
        }
        if (!plot_.series.empty()) {
            text(kWidth - 24.0, y + 6.0, "right: exponent of the fitted line", kQuiet,
                 "text-anchor=\"end\" font-size=\"11\"");
        }
    }

    const LogPlot &plot_;
    Axis x_, y_;
    std::string svg_;
};

} // namespace

double Decades::place(double value) const {
    return (std::log10(value) - first) / (last - first);
}

Decades decadesOf(const LogPlot &plot, double Vec2::*coordinate) {
    double minimum = INFINITY, maximum = 0.0;
    for (const PlotSeries &series : plot.series) {
        for (const Vec2 p : series.points) {
            if (p.*coordinate > 0.0) {
                minimum = std::min(minimum, p.*coordinate);
                maximum = std::max(maximum, p.*coordinate);
            }
        }
    }
    Decades decades;
    if (maximum > 0.0) {
        decades.first = static_cast<int>(std::floor(std::log10(minimum)));
        decades.last = std::max(decades.first + 1, static_cast<int>(std::ceil(std::log10(maximum))));
    }
    return decades;
}

std::string toSvg(const LogPlot &plot) {
    return PlotDrawing(plot).run();
}

} // namespace forefront
