#include "tests/ui/colour_vision.hpp"
#include "ui/style/theme.hpp"
#include "ui/widgets/widgets.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <sstream>
#include <string>

namespace forefront::test {

namespace {

/// A role of a theme and its name on the style page.
struct NamedRole {
    const char *name;
    Colour Theme::*colour;
};

/// Returns the table of contrasts as it is on the style page: a row for each text or mark, a column for each ground.
std::string contrastTable() {
    constexpr NamedRole kMarks[] = {{"text", &Theme::text},
                                    {"muted", &Theme::muted},
                                    {"placeholder", &Theme::placeholder},
                                    {"faint", &Theme::faint},
                                    {"fieldBorder", &Theme::fieldBorder},
                                    {"accent", &Theme::accent},
                                    {"good", &Theme::good},
                                    {"bad", &Theme::bad},
                                    {"warn", &Theme::warn},
                                    {"boundary", &Theme::boundary},
                                    {"mesh", &Theme::mesh},
                                    {"constraint", &Theme::constraint},
                                    {"front", &Theme::front},
                                    {"base", &Theme::base},
                                    {"accepted", &Theme::accepted},
                                    {"candidate", &Theme::candidate},
                                    {"selection", &Theme::selection}};
    constexpr NamedRole kGrounds[] = {
        {"panel", &Theme::panel},   {"inset", &Theme::inset},   {"raised", &Theme::raised},  {"popup", &Theme::popup},
        {"canvas", &Theme::canvas}, {"domain", &Theme::domain}, {"element", &Theme::element}};
    std::string table = "| dark / light |";
    for (const NamedRole &ground : kGrounds) {
        table += ' ' + std::string(ground.name) + " |";
    }
    table += "\n|---|";
    for (std::size_t k = 0; k < std::size(kGrounds); ++k) {
        table += "---|";
    }
    const Theme dark = makeTheme(ThemeKind::Dark), light = makeTheme(ThemeKind::Light);
    for (const NamedRole &mark : kMarks) {
        table += "\n| " + std::string(mark.name) + " |";
        for (const NamedRole &ground : kGrounds) {
            const auto ratio = [&](const Theme &theme) {
                const Colour below = theme.*ground.colour;
                return ui::format("%.1f", contrast(over(theme.*mark.colour, below), below));
            };
            table += ' ' + ratio(dark) + " / " + ratio(light) + " |";
        }
    }
    return table;
}

} // namespace

TEST_CASE("Theme: the table of contrasts on the style page is that of the themes") {
    std::ostringstream page;
    page << std::ifstream(std::string(FOREFRONT_SOURCE_DIR) + "/ui/style/README.md").rdbuf();
    const std::string table = contrastTable();
    CHECK_MESSAGE(page.str().find(table) != std::string::npos, "replace the table of contrasts by\n" << table);
}

} // namespace forefront::test
