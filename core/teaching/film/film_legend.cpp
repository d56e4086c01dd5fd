#include "core/teaching/film/film_legend.hpp"

#include <array>
#include <string>

namespace forefront {

namespace {

constexpr double kLegendSize = 12.0;          ///< font size in pixels
constexpr double kLeft = 12.0, kApart = 16.0; ///< pixels before the first entry, and between two of them
constexpr double kFirst = 14.0, kLine = 18.0; ///< pixels from the top to the first baseline, and between baselines

struct LegendEntry {
    const char *text;
    Ink ink;
};
constexpr std::array<LegendEntry, 6> kEntries{{{"base AB", Ink::Base},
                                               {"front", Ink::Front},
                                               {"accepted", Ink::Accepted},
                                               {"rejected", Ink::Rejected},
                                               {"not tested", Ink::Candidate},
                                               {"circle: search around C", Ink::Candidate}}};

/// Calls place(entry, x, line) for each entry, with a new line where the next one does not fit. Returns the number of
/// lines.
template <class Place>
int layOut(int width, Place place) {
    double x = kLeft;
    int line = 0;
    for (const LegendEntry &entry : kEntries) {
        const double room = filmTextWidth(entry.text, kLegendSize);
        if (x > kLeft && x + room > width - kLeft) {
            x = kLeft;
            ++line;
        }
        place(entry, x, line);
        x += room + kApart;
    }
    return line + 1;
}

} // namespace

int legendLines(int width) {
    return layOut(width, [](const LegendEntry &, double, int) {});
}

void addLegend(double top, FilmScene &scene) {
    layOut(scene.width, [&](const LegendEntry &entry, double x, int line) {
        scene.texts.push_back({{x, top + kFirst + kLine * line}, entry.text, entry.ink, kLegendSize, {}});
    });
}

} // namespace forefront
