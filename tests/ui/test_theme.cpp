#include "tests/ui/colour_vision.hpp"
#include "ui/style/edge_colour.hpp"
#include "ui/style/measure_colours.hpp"
#include "ui/style/spacing_tint.hpp"
#include "ui/style/theme.hpp"

#include <doctest/doctest.h>

#include <initializer_list>
#include <string>
#include <vector>

namespace forefront::test {

namespace {

/// A colour of a theme and its name.
struct Role {
    const char *name;
    Colour colour;
};

/// Checks that every colour of one list has a contrast with every colour of another.
void checkContrast(std::initializer_list<Role> marks, std::initializer_list<Role> grounds, double minimum) {
    for (const Role &mark : marks) {
        for (const Role &ground : grounds) {
            CAPTURE(mark.name);
            CAPTURE(ground.name);
            CHECK(contrast(over(mark.colour, ground.colour), ground.colour) >= minimum);
        }
    }
}

} // namespace

// Every pair that the interface draws: a new one belongs here.
TEST_CASE("Theme: text, edges of fields and marks contrast with all surfaces they lie on, in both themes") {
    for (const ThemeKind kind : {ThemeKind::Dark, ThemeKind::Light}) {
        CAPTURE(kind == ThemeKind::Dark ? "dark" : "light");
        const Theme t = makeTheme(kind);
        const Role panel{"panel", t.panel}, inset{"inset", t.inset}, popup{"popup", t.popup},
            raised{"raised", t.raised}, hovered{"hovered", t.hovered}, pressed{"pressed", t.pressed},
            canvas{"canvas", t.canvas}, domain{"domain", t.domain}, element{"element", t.element},
            selected{"selectedRow", t.selectedRow}, field{"hovered field", mix(t.inset, t.raised, 0.5)},
            marked{"selected text", mix(t.inset, t.accent, 0.35)}, plate{"plate", over(labelPlate(t), t.domain)},
            crossed{"plate over a line", over(labelPlate(t), kind == ThemeKind::Dark ? t.text : t.boundary)},
            pill{"pill", over(fade(t.accent, 0.35), t.panel)};
        const Role text{"text", t.text}, muted{"muted", t.muted}, accent{"accent", t.accent}, good{"good", t.good},
            bad{"bad", t.bad}, warn{"warn", t.warn}, accepted{"accepted", t.accepted};
        checkContrast({text}, {panel, inset, popup, raised, hovered, selected, field, marked, plate, canvas, domain},
                      7.0);
        checkContrast({text, muted}, {crossed}, 4.5);
        checkContrast({text}, {pressed, pill}, 4.5); // what is on, held down or shown alone
        checkContrast({muted}, {panel, inset, popup, raised, hovered, selected, field, plate, canvas, domain}, 4.5);
        checkContrast({{"placeholder", t.placeholder}}, {panel, inset, popup, field}, 4.5);
        // Messages, links and verdicts; on rows and buttons, the colours of states are those of icons.
        checkContrast({good, bad, warn, accent, accepted}, {panel, inset, popup}, 4.5);
        checkContrast({good, bad, warn, accent, accepted}, {raised, hovered, selected, canvas, domain}, 3.0);
        const Role primary[] = {
            accent, {"accent, hovered", mix(t.accent, t.text, 0.15)}, {"accent, pressed", mix(t.accent, t.text, 0.3)}};
        for (const Role &ground : primary) {
            checkContrast({{"onAccent", t.onAccent}}, {ground}, 4.5);
        }
        checkContrast({{"faint", t.faint}}, {panel, inset, popup, raised}, 3.0);
        checkContrast({{"fieldBorder", t.fieldBorder}}, {panel, inset, popup}, 3.0);
        checkContrast({text, muted}, {pressed}, 3.0); // icons that are on, knobs of sliders
        checkContrast({{"boundary", t.boundary},
                       {"constraint", t.constraint},
                       {"determined", t.determined},
                       {"front", t.front},
                       {"base", t.base},
                       {"accepted", t.accepted},
                       {"bad", t.bad},
                       {"candidate", t.candidate},
                       {"compared", t.compared},
                       {"selection", t.selection},
                       {"cell", t.cell},
                       {"visited", t.visited},
                       {"brush", t.brush}},
                      {canvas, domain, element}, 3.0);
        checkContrast({{"mesh", t.mesh}}, {domain, element}, 3.0);
        checkContrast({{"core", t.core}}, {{"base", t.base}}, 3.0);
    }
}

TEST_CASE("Theme: surfaces of different height differ, and the plates above have an edge") {
    for (const ThemeKind kind : {ThemeKind::Dark, ThemeKind::Light}) {
        const Theme t = makeTheme(kind);
        CHECK(contrast(t.panel, t.canvas) >= 1.2);
        CHECK(contrast(t.raised, t.panel) >= 1.15);
        CHECK(contrast(t.raised, t.inset) >= 1.2);
        CHECK(contrast(t.popupBorder, t.popup) >= 1.6);
        CHECK(contrast(t.popupBorder, t.panel) >= 1.6);
    }
}

TEST_CASE("Theme: the meanings on the canvas are told apart, also without seeing red and green") {
    for (const ThemeKind kind : {ThemeKind::Dark, ThemeKind::Light}) {
        CAPTURE(kind == ThemeKind::Dark ? "dark" : "light");
        const Theme t = makeTheme(kind);
        const std::vector<Role> roles{{"boundary", t.boundary},     {"mesh", over(t.mesh, t.element)},
                                      {"constraint", t.constraint}, {"determined", t.determined},
                                      {"front", t.front},           {"base", t.base},
                                      {"accepted", t.accepted},     {"bad", t.bad},
                                      {"selection", t.selection},   {"candidate", t.candidate}};
        for (std::size_t i = 0; i < roles.size(); ++i) {
            for (std::size_t k = i + 1; k < roles.size(); ++k) {
                CAPTURE(roles[i].name);
                CAPTURE(roles[k].name);
                CHECK(apart(roles[i].colour, roles[k].colour) >= 15.0);
            }
        }
        CHECK(apart(t.accepted, t.bad) >= 60.0);
        CHECK(apart(t.warn, t.front) >= 14.0);
        CHECK(apart(t.constraint, t.selection) >= 25.0);
    }
}

TEST_CASE("Theme: edges over colours of values contrast with every one of them") {
    for (const ColourMap map : {mapOf(Measure::ShapeFactor, QualityScale::Alarm, ThemeKind::Dark),
                                mapOf(Measure::ShapeFactor, QualityScale::Alarm, ThemeKind::Light),
                                mapOf(Measure::ShapeFactor, QualityScale::Cividis, ThemeKind::Dark),
                                mapOf(Measure::SizeRatio, QualityScale::Alarm, ThemeKind::Dark),
                                mapOf(Measure::Area, QualityScale::Alarm, ThemeKind::Dark), ColourMap(spacingColour)}) {
        for (int k = 0; k <= 100; ++k) {
            const Colour fill = map(k / 100.0);
            CHECK(contrast(edgeOn(fill), fill) >= 3.0);
            const bool lighter = luminance(edgeOn(fill)) > luminance(fill);
            CHECK(lighter == (luminance(fill) < 0.18));
        }
    }
    for (const ThemeKind kind : {ThemeKind::Dark, ThemeKind::Light}) {
        const Theme t = makeTheme(kind);
        for (int k = 0; k <= 100; ++k) {
            const Colour field = mix(t.domain, spacingColour(k / 100.0), spacingTint(kind));
            CHECK(contrast(over(t.meshOnTint, field), field) >= 3.0);
        }
    }
}

} // namespace forefront::test
