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

TEST_CASE("Theme: text, edges of fields and marks contrast with all surfaces they lie on, in both themes") {
    for (const ThemeKind kind : {ThemeKind::Dark, ThemeKind::Light}) {
        CAPTURE(kind == ThemeKind::Dark ? "dark" : "light");
        const Theme t = makeTheme(kind);
        const Role panel{"panel", t.panel}, inset{"inset", t.inset}, popup{"popup", t.popup},
            raised{"raised", t.raised}, hovered{"hovered", t.hovered}, canvas{"canvas", t.canvas},
            domain{"domain", t.domain}, selected{"selectedRow", t.selectedRow};
        const Role text{"text", t.text}, muted{"muted", t.muted}, accent{"accent", t.accent};
        checkContrast({text}, {panel, inset, popup, raised, hovered, selected}, 7.0);
        checkContrast({muted}, {panel, inset, popup, raised, hovered, selected}, 4.5);
        checkContrast({{"placeholder", t.placeholder}}, {panel, inset, popup}, 4.5);
        checkContrast({{"good", t.good}, {"bad", t.bad}, {"warn", t.warn}, accent}, {panel, inset, popup}, 4.5);
        checkContrast({{"onAccent", t.onAccent}}, {accent}, 4.5);
        checkContrast({{"faint", t.faint}}, {panel, inset, popup, raised}, 3.0);
        checkContrast({{"fieldBorder", t.fieldBorder}}, {panel, inset, popup}, 3.0);
        checkContrast({accent}, {panel, inset, popup, raised, canvas, domain}, 3.0);
        checkContrast({{"boundary", t.boundary},
                       {"constraint", t.constraint},
                       {"base", t.base},
                       {"accepted", t.accepted},
                       {"bad", t.bad},
                       {"candidate", t.candidate},
                       {"selection", t.selection}},
                      {canvas, domain}, 3.0);
        checkContrast({{"front", t.front}, {"mesh", t.mesh}}, {domain, {"element", t.element}}, 3.0);
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
        const std::vector<Role> roles{{"boundary", t.boundary},
                                      {"mesh", over(t.mesh, t.element)},
                                      {"constraint", t.constraint},
                                      {"front", t.front},
                                      {"base", t.base},
                                      {"accepted", t.accepted},
                                      {"bad", t.bad},
                                      {"selection", t.selection},
                                      {"candidate", t.candidate}};
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
