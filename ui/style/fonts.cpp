#include "ui/style/fonts.hpp"

#include "ui/style/icon_raster.hpp"
#include "ui/style/icons.hpp"
#include "ui/style/imgui_versions.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <utility>
#include <vector>

namespace forefront {

namespace {

// Latin, Greek (α δ ρ Γ Ω), punctuation, super- and subscripts, arrows, mathematics, shapes.
const ImWchar kTextRanges[] = {0x0020, 0x017f, 0x0391, 0x03c9, 0x2010, 0x2027, 0x202f, 0x203a,
                               0x2070, 0x2094, 0x2190, 0x2195, 0x21e7, 0x21e7, 0x2202, 0x2202,
                               0x2205, 0x2265, 0x2318, 0x2318, 0x25a0, 0x25cf, 0};
// Of formulas: see core/teaching/markup/math_symbols.cpp.
const ImWchar kMathRanges[] = {0x0020, 0x007e, 0x00a0, 0x00ff, 0x0391, 0x03c9, 0x2010, 0x2027,
                               0x2032, 0x2032, 0x2190, 0x2193, 0x2202, 0x2265, 0};
const ImWchar kLetters[] = {0x0020, 0x007e, 0};
const ImWchar kSums[] = {0x220f, 0x2211, 0x222b, 0x222b, 0};
const ImWchar kAllLatin[] = {0x0020, 0x017f, 0x2010, 0x2027, 0};

/// Height of a line of Inter and of DejaVu, in ems. Dear ImGui takes the size of a font to be that of its line.
constexpr float kLine = 1.2F;
constexpr float kSmallIcon = 16.0F, kIcon = 20.0F; ///< design pixels

class AtlasBuilder {
  public:
    AtlasBuilder(float scale, std::string &warning) : scale_(scale), warning_(warning) {}

    /// Adds a text font with an em of `size` design pixels and icons of another size. Symbols that it lacks come from
    /// DejaVu.
    ImFont *text(const char *file, float size, float icon) {
        ImFont *font = add(file, size, kTextRanges, nullptr);
        if (font == nullptr) {
            font = add("truetype/dejavu/DejaVuSans.ttf", size, kTextRanges, nullptr);
        }
        if (font == nullptr) {
            ImFontConfig config;
            config.SizePixels = pixels(size);
            font = atlas().AddFontDefault(&config);
        } else {
            ImFontConfig merge;
            merge.MergeMode = true;
            add("truetype/dejavu/DejaVuSans.ttf", size, kTextRanges, &merge);
        }
        addIcons(*font, pixels(size), static_cast<int>(std::lround(icon * scale_)));
        return font;
    }

    /// Adds a font of formulas; symbols that it lacks come from DejaVu.
    ImFont *math(const char *file, float size, const ImWchar *ranges) {
        ImFont *const font = add(file, size, ranges, nullptr);
        if (font == nullptr) {
            return add("truetype/dejavu/DejaVuSans.ttf", size, ranges, nullptr);
        }
        ImFontConfig merge;
        merge.MergeMode = true;
        add("truetype/dejavu/DejaVuSans.ttf", size, ranges, &merge);
        return font;
    }

    ImFont *mono(float size) { return add("truetype/dejavu/DejaVuSansMono.ttf", size, kAllLatin, nullptr); }

    /// Builds the atlas and draws the icons into it.
    void build() {
        imgui::build(atlas());
        std::map<std::pair<std::size_t, int>, std::vector<std::uint8_t>> drawn; // by glyph and size
        for (const PlacedIcon &icon : icons_) {
            const int size = icon.size;
            std::vector<std::uint8_t> &cover = drawn[{icon.glyph, size}];
            if (cover.empty()) {
                cover = drawIcon(iconShapes()[icon.glyph / 2], icon.glyph % 2 == 0 ? IconPart::Whole : IconPart::Nodes,
                                 size);
            }
            imgui::drawInto(atlas(), icon.place, cover);
        }
    }

  private:
    /// A part of an icon in the atlas; `glyph`: twice the index of its shape, one more for its nodes.
    struct PlacedIcon {
        std::size_t glyph;
        int place; ///< its number in the atlas
        int size;  ///< in pixels
    };

    static ImFontAtlas &atlas() { return *ImGui::GetIO().Fonts; }
    float pixels(float em) const { return std::round(em * kLine * scale_); }

    /// Adds the icons to a font, in the middle of its line.
    void addIcons(ImFont &font, float line, int size) {
        const float top = std::round(0.5F * (line - static_cast<float>(size)));
        for (std::size_t k = 0; k < iconShapes().size(); ++k) {
            const bool nodes = *iconShapes()[k].nodes != '\0';
            for (std::size_t part = 0; part < (nodes ? 2U : 1U); ++part) {
                const char *const text = iconShapes()[k].text;
                const auto letter = static_cast<unsigned>(codeOf(text) + (part == 0 ? 0 : kNodesOfIcon));
                icons_.push_back({2 * k + part, imgui::reserveGlyph(atlas(), font, line, letter, size, top), size});
            }
        }
    }

    ImFont *add(const char *file, float size, const ImWchar *ranges, const ImFontConfig *config) {
        const std::filesystem::path path = std::filesystem::path(FOREFRONT_FONT_ROOT) / file;
        std::error_code ignored;
        if (!std::filesystem::exists(path, ignored)) {
            if (warning_.empty()) {
                warning_ = "font " + path.string() + " not found; install fonts-inter and fonts-dejavu-core";
            }
            return nullptr;
        }
        return atlas().AddFontFromFileTTF(path.c_str(), pixels(size), config, ranges);
    }

    float scale_;
    std::string &warning_;
    std::vector<PlacedIcon> icons_;
};

} // namespace

Fonts loadFonts(float scale, std::string &warning) {
    ImFontAtlas &atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    imgui::useFreeType(atlas);
    AtlasBuilder builder(scale, warning);
    Fonts fonts;
    fonts.body = builder.text("opentype/inter/Inter-Regular.otf", 13.0F, kSmallIcon);
    fonts.strong = fonts.heading = builder.text("opentype/inter/Inter-SemiBold.otf", 13.0F, kSmallIcon);
    fonts.small = builder.text("opentype/inter/Inter-Regular.otf", 12.0F, kSmallIcon);
    fonts.title = builder.text("opentype/inter/Inter-SemiBold.otf", 16.0F, kSmallIcon);
    fonts.page = fonts.icons = builder.text("opentype/inter/Inter-SemiBold.otf", 20.0F, kIcon);
    fonts.mono = builder.mono(12.0F);
    fonts.mono = fonts.mono != nullptr ? fonts.mono : fonts.body;
    fonts.italic = builder.math("opentype/inter/Inter-Italic.otf", 13.0F, kLetters);
    fonts.index = builder.math("opentype/inter/Inter-Regular.otf", 10.0F, kMathRanges);
    fonts.indexItalic = builder.math("opentype/inter/Inter-Italic.otf", 10.0F, kLetters);
    fonts.sum = builder.math("opentype/inter/Inter-Regular.otf", 20.0F, kSums);
    for (ImFont **const font : {&fonts.italic, &fonts.index, &fonts.indexItalic, &fonts.sum}) {
        *font = *font != nullptr ? *font : fonts.body;
    }
    ImGui::GetIO().FontDefault = fonts.body;
    builder.build();
    for (ImFont *font : atlas.Fonts) {
        // FreeType within Dear ImGui does not apply the OpenType feature "tnum" that would do the same.
        imgui::makeTabular(*font, '0', '9');
    }
    return fonts;
}

} // namespace forefront
